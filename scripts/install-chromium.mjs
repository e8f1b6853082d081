import { existsSync, readdirSync } from 'node:fs';
import { findChromium } from './chromium.mjs';
import { runCommand, runNode, tools } from './run-command.mjs';

const BROWSER = ['chromium', 'mesa-vulkan-drivers', 'libvulkan1', 'fonts-liberation'];
/** A small font (1.6 MB) with Chinese characters, so that pictures of the Chinese page show more than boxes. */
const CHINESE = 'fonts-wqy-microhei';

/** How to run apt-get here without being asked anything: as root, or by a sudo that wants no password. Else null. */
async function aptGet() {
  if (process.platform !== 'linux' || !existsSync('/usr/bin/apt-get')) return null;
  if (process.getuid?.() === 0) return ['apt-get'];
  return (await runCommand('sudo', ['-n', 'true'], { quiet: true })) === 0 ? ['sudo', '-n', 'apt-get'] : null;
}

/** Chromium's WebGPU needs the Vulkan loader, which somebody's earlier install of the browser may lack. */
function lacksVulkanLoader() {
  if (process.platform !== 'linux') return false;
  const folders = ['/usr/lib', '/usr/lib64', ...readdirSync('/usr/lib').map((name) => `/usr/lib/${name}`)];
  return !folders.some((folder) => existsSync(`${folder}/libvulkan.so.1`));
}

/** @returns {Promise<boolean>} whether apt did it */
async function installByApt() {
  const apt = await aptGet();
  if (!apt) return false;
  const [command = '', ...before] = apt;
  const install = [...before, 'install', '-y', '-qq', '--no-install-recommends'];
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  console.log(`Installing Chromium (${apt.join(' ')} install ${BROWSER.join(' ')}) …`);
  // A list that is out of date in part is still good enough to try with.
  await runCommand(command, [...before, 'update', '-qq'], { env });
  if ((await runCommand(command, [...install, ...BROWSER], { env })) !== 0) return false;
  await runCommand(command, [...install, CHINESE], { env });
  return true;
}

async function installByPlaywright() {
  console.log('Installing Playwright’s own Chromium …');
  // System libraries can be added only where apt may be used; without, the browser often runs all the same.
  const withLibraries = (await aptGet()) ? ['--with-deps'] : [];
  const install = (/** @type {string[]} */ options) =>
    runNode(tools.playwright, ['install', '--no-shell', ...options, 'chromium']);
  if ((await install(withLibraries)) !== 0 && withLibraries.length > 0) await install([]);
}

/**
 * The path of a Chromium, installed when there was none.
 * @returns {Promise<string>}
 */
export async function ensureChromium() {
  const found = await findChromium();
  if (found && !lacksVulkanLoader()) return found;
  const byApt = await installByApt();
  if (!byApt && !found) await installByPlaywright();
  const installed = await findChromium();
  if (installed) return installed;
  throw new Error(
    'No Chromium was found and none could be installed. Please install Chromium or Chrome, ' +
      'or set the environment variable CHROMIUM to the path of one.',
  );
}
