/** The oldest Node that Vite and the tests run on. Keep in step with "engines" in package.json. */
const OLDEST = [20, 19];

/** Ends the program with a friendly sentence when Node is too old, before anything fails in a confusing way. */
export function requireNode() {
  const [major = 0, minor = 0] = process.versions.node.split('.').map(Number);
  const [oldestMajor = 0, oldestMinor = 0] = OLDEST;
  if (major > oldestMajor || (major === oldestMajor && minor >= oldestMinor)) return;
  console.error(
    `Mirrorball needs Node.js ${OLDEST.join('.')} or newer, and this is ${process.versions.node}. ` +
      'Please install a newer one (https://nodejs.org has it) and try again.',
  );
  process.exit(1);
}
