/**
 * The path integrator in several passes (path_relay.wesl), for drivers whose compiler takes seconds over one long program: each of these takes
 * it a fraction. Loaded when a scene needs it: see scripts/lazy-parts.mjs.
 */
import type { Device, FilmTexture, Pass, PassBinding, Region, Relay, Resource } from '../../gpu/device.ts';
import { GEOMETRY, SCENE_TABLE, TEXELS } from '../../packed-scene/layout.ts';
import { type Feature, switchesFor } from '../../shading/features.ts';
import fullScreenGlsl from '../../shading/generated/fullScreen.glsl?raw';
import beginGlsl from './generated/pathBegin.glsl?raw';
import endGlsl from './generated/pathEnd.glsl?raw';
import lightGlsl from './generated/pathLight.glsl?raw';
import scatterGlsl from './generated/pathScatter.glsl?raw';
import traceGlsl from './generated/pathTrace.glsl?raw';
import type { PathInputs, RelayPass, RelaySample } from './path.ts';
import type { RelayWords } from './relay-room.ts';

/** Rounds, after each of which it is asked whether any path is left. Asking takes the time of some rounds over paths that have ended. */
const ROUNDS = 4;
/** As many at most go without, because the stripe before took so many. */
const MOST_ROUNDS = 64;

const named = (name: string, count: number): PassBinding[] =>
  Array.from({ length: count }, (_, i) => ({ texture: `${name}${i}` }));
const FRAME = { block: 'Frame' };
const ENVIRONMENT = { texture: 'environment' };
const PATH = named('path', 8);
const HIT = named('hit', 2);
const CHOICE = named('choice', 8);

/** What each reads, in the order of `inputsOf`. */
const PROGRAMS = {
  begin: { fragment: beginGlsl, bindings: [FRAME] },
  trace: { fragment: traceGlsl, bindings: [FRAME, SCENE_TABLE, GEOMETRY, TEXELS, ...PATH] },
  light: { fragment: lightGlsl, bindings: [FRAME, SCENE_TABLE, ENVIRONMENT, GEOMETRY, TEXELS, ...PATH, ...HIT] },
  scatter: { fragment: scatterGlsl, bindings: [FRAME, SCENE_TABLE, GEOMETRY, TEXELS, ...HIT, ...CHOICE] },
  end: {
    fragment: endGlsl,
    bindings: [FRAME, SCENE_TABLE, ENVIRONMENT, { texture: 'previousFilm' }, { texture: 'previousSquares' }, ...PATH],
  },
};
type Part = keyof typeof PROGRAMS;
const PARTS = Object.keys(PROGRAMS) as Part[];

function inputsOf(part: Part, inputs: PathInputs, words: RelayWords): Resource[] {
  const { frame, sceneTable, environment, geometry, texels, previous } = inputs;
  const [path, hit, choice] = [words.path.layers, words.hit.layers, words.choice.layers];
  const parts: Record<Part, Resource[]> = {
    begin: [frame],
    trace: [frame, sceneTable, geometry, texels, ...path],
    light: [frame, sceneTable, environment, geometry, texels, ...path, ...hit],
    scatter: [frame, sceneTable, geometry, texels, ...hit, ...choice],
    end: [frame, sceneTable, environment, ...previous, ...path],
  };
  return parts[part];
}

/** A program for films that ask for no more than these features. Rejects with `DeviceError` when the driver refuses. */
export async function createPathRelay(
  device: Device,
  relay: Relay,
  features: ReadonlySet<Feature>,
): Promise<RelayPass> {
  const switches = switchesFor(features);
  const compiled = PARTS.map(async (part) => {
    const { fragment, bindings } = PROGRAMS[part];
    const source = { label: `path, ${part}`, switches, bindings, glsl: { vertex: fullScreenGlsl, fragment } };
    return [part, await relay.createPass(source)] as const;
  });
  return new PathRelay(device, relay, Object.fromEntries(await Promise.all(compiled)) as Record<Part, Pass>);
}

class PathRelay implements RelayPass {
  readonly label = 'path';
  readonly addsMany = false;
  readonly #device: Device;
  readonly #relay: Relay;
  readonly #passes: Record<Part, Pass>;
  /** To begin with, as the last stripe needed so many. */
  #rounds = ROUNDS;

  constructor(device: Device, relay: Relay, passes: Record<Part, Pass>) {
    this.#device = device;
    this.#relay = relay;
    this.#passes = passes;
  }

  async addSample(sample: RelaySample): Promise<boolean> {
    const { words, height, rowsPerSubmit, unwanted } = sample;
    const halves = [Promise.resolve(true), Promise.resolve(true)];
    let row = 0;
    for (let half = 0; row < height && !unwanted(); half = 1 - half) {
      await halves[half];
      const rowCount = Math.min(rowsPerSubmit(), words.rows, height - row);
      halves[half] = this.#addStripe(sample, half * words.rows, row, rowCount);
      halves[half]!.catch(() => {}); // awaited below, or not at all when the other failed first
      row += rowCount;
    }
    const whole = await Promise.all(halves);
    return row === height && whole.every(Boolean);
  }

  /** Rows of the film from `row` on, in the words' from `first` on. */
  async #addStripe(sample: RelaySample, first: number, row: number, rowCount: number): Promise<boolean> {
    const { film, inputs, words, width, height, maxDepth, takeRow, unwanted, measured } = sample;
    const begun = performance.now();
    const region = { width, height: 2 * words.rows, firstRow: first, rowCount };
    const draw = (part: Part, target: FilmTexture, on: Region = region) =>
      this.#device.draw(this.#passes[part], target, inputsOf(part, inputs, words), on);
    takeRow(row - first);
    draw('begin', words.path);
    let done = 0;
    for (let count = this.#rounds; ; count = ROUNDS) {
      count = Math.min(count, maxDepth - done);
      takeRow(row - first);
      for (let i = 0; i < count; i++) {
        draw('trace', words.hit);
        draw('light', words.choice);
        if (i < count - 1 || done + count === maxDepth) draw('scatter', words.path);
      }
      done += count;
      if (done === maxDepth) break;
      // A path that was over before this last round is not drawn.
      const left = this.#relay.drawAsking(this.#passes.scatter, words.path, inputsOf('scatter', inputs, words), region);
      if (!(await left)) break;
      if (unwanted()) return false;
    }
    this.#rounds = Math.min(Math.max(done, ROUNDS), MOST_ROUNDS);
    takeRow(row - first);
    draw('end', film, { width, height, firstRow: row, rowCount });
    await this.#device.finished();
    measured(width * rowCount, begun);
    return true;
  }
}
