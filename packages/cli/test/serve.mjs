// One process for many runs of the built program, one after the other: a GPU is opened and its programs are compiled once.
const { keepBackends, run } = await import(process.argv[2] ?? '');
keepBackends();

let last = Promise.resolve();
process.on('message', (/** @type {{ id: number, args: string[] }} */ { id, args }) => {
  last = last.then(async () => {
    let [stdout, stderr] = ['', ''];
    const code = await run(args, {
      stdout: { write: (/** @type {string} */ text) => Boolean((stdout += text)) },
      stderr: { write: (/** @type {string} */ text) => Boolean((stderr += text)) },
    });
    process.send?.({ id, code, stdout, stderr });
  });
});
process.on('disconnect', () => process.exit());
