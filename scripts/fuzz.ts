/**
 * Traces random scenes by the path integrator and keeps those whose films are not light: negative, infinite, or no number.
 * `npm run fuzz -- --scenes 10000 --seed 1` takes WebGPU and WebGL2 of a headless Chromium; `--backend webgpu` only one, `--backend dawn`
 * this machine's GPU without a browser. `--first 5000` begins later. Bad scenes go to `--keep` (test-results/fuzz), as they were
 * drawn and with all left out that can be.
 *
 * `npm run fuzz -- --models 1000 --seed 1` takes scenes with meshes, textures, layers and instances, which must also give the same film
 * twice and show the sky where the reference tracer sees nothing else. Kept ones have their arrays as lists; --first draws them again.
 *
 * `npm run fuzz -- --files 20000 --seed 1` breaks files of all kinds instead and opens them: see fuzz/break-files.ts.
 */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { keepScene } from '../tests/browser/kept-scenes.ts';
import { breakFiles } from './fuzz/break-files.ts';
import { FUZZ_BACKENDS, type FuzzBackend, openFuzzer } from './fuzz/fuzzers.ts';

const { values } = parseArgs({
  options: {
    files: { type: 'string' },
    models: { type: 'string' },
    scenes: { type: 'string', default: '1000' },
    first: { type: 'string', default: '0' },
    seed: { type: 'string', default: '1' },
    backend: { type: 'string' },
    keep: { type: 'string', default: 'test-results/fuzz' },
  },
});
function whole(name: 'files' | 'models' | 'scenes' | 'first' | 'seed'): number {
  const number = Number(values[name]);
  if (!Number.isInteger(number) || number < 0)
    throw new Error(`--${name} is ${values[name]}, and has to be a whole number.`);
  return number;
}
const kind = values.models === undefined ? 'shapes' : 'models';
const [scenes, first, seed] = [whole(kind === 'models' ? 'models' : 'scenes'), whole('first'), whole('seed')];
const chosen = FUZZ_BACKENDS.filter((name) => name === values.backend);
if (values.backend !== undefined && chosen.length === 0)
  throw new Error(`There is no backend ${values.backend}; there are ${FUZZ_BACKENDS.join(', ')}.`);
const backends: readonly FuzzBackend[] = chosen.length > 0 ? chosen : ['webgpu', 'webgl2'];

/** Scenes of one call: short enough that it can be seen where it stops. */
const CALL = 25;
/** Bad scenes that are cut down: it takes a while, and one cause has many scenes. */
const MOST_LEAST = 12;

async function fuzz(backend: FuzzBackend): Promise<number> {
  const folder = join(values.keep, backend);
  let [bad, milliseconds] = [0, 0];
  const fuzzer = await openFuzzer(backend);
  console.log(`${backend}: ${fuzzer.description}`);
  try {
    for (let at = first; at < first + scenes; at += CALL) {
      const report = await fuzzer.fuzz(kind, seed, at, Math.min(CALL, first + scenes - at));
      milliseconds += report.milliseconds;
      for (const one of report.bad) {
        mkdirSync(folder, { recursive: true });
        const path = await keepScene(`fuzz-${one.index}`, one.scene, (name) => join(folder, name));
        console.log(
          `  scene ${one.index}: ${one.what}, pixel ${one.pixel}, sample ${one.sample}: ${one.value.join(' ')}; ${path}`,
        );
        if (++bad > MOST_LEAST) continue;
        const least = await fuzzer.least(kind, seed, one.index);
        if (least) await keepScene(`fuzz-${one.index}-least`, least.scene, (name) => join(folder, name));
      }
      const done = at + CALL - first;
      if (done % (kind === 'models' ? 50 : 500) === 0)
        console.log(`  ${done} scenes, ${bad} bad, ${(milliseconds / done).toFixed(1)} ms each`);
    }
  } finally {
    await fuzzer.close();
  }
  console.log(
    `${backend}: ${scenes} scenes (seed ${seed}, from ${first}), ${bad} bad, ${(milliseconds / 1000).toFixed(0)} s.`,
  );
  return bad;
}

if (values.files !== undefined) {
  const found = await breakFiles(whole('files'), first, seed, join(values.keep, 'files'));
  process.exit(found > 0 ? 1 : 0);
}
let bad = 0;
for (const backend of backends) bad += await fuzz(backend);
process.exit(bad > 0 ? 1 : 0); // Dawn keeps threads
