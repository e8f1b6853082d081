/** The sky's map on a GPU, judged by the double-precision one: what is sampled, how often, and what rays are told. */
import {
  densityOnMap,
  overMap,
  placeDensity,
  placeOnMap,
  radianceOfMap,
} from '../../../../packages/renderer/src/reference/light/environment.ts';
import type { EnvironmentMap } from '../../../../packages/renderer/src/scene/environment.ts';
import type { Scene, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { length, normalize } from '../../../../packages/renderer/src/scene/vec3.ts';
import { ENVIRONMENTS } from '../../../fixtures/lights/environments.ts';
import { chiSquareZ } from '../../../fixtures/lights/histogram.ts';
import { randomDirection, seededRandom } from '../../../fixtures/random.ts';
import { testScene } from '../../../fixtures/scenes.ts';
import { verdictOn } from '../verdict.ts';
import {
  type Answer,
  ASK,
  type EmitterProbe,
  eyeAtOrigin,
  type GpuBackend,
  MOST_QUESTIONS,
  type Question,
  rounded,
  withProbe,
} from './probe.ts';

export interface EnvironmentReport {
  readonly name: string;
  /** Of the distribution of directions, see `chiSquareZ`. */
  readonly z: number;
  /** The same of points that are even in the square: far below 0 where they stay even. */
  readonly zOfEven: number;
  /** Of the mean of radiance / density over the samples, as a path weighs it, from the integral, relative, and its standard error. */
  readonly error: number;
  readonly noise: number;
  readonly faults: number;
  readonly examples: string[];
}

const ORIGIN: Vec3 = [0, 0, 0];
const ROTATION = 77;
const SCALE = 2;
const mean = ([r, g, b]: readonly number[]) => (r! + g! + b!) / 3;

const sceneOf = (map: EnvironmentMap): Scene =>
  testScene(
    {},
    {},
    {
      ...eyeAtOrigin,
      sky: { horizon: [0, 0, 0], zenith: [0, 0, 0], map, scale: SCALE, rotation: ROTATION },
    },
  );

/** Of 32-bit directions, a map's place is known up to this many texels. */
const placeError = ({ width }: EnvironmentMap) => 1e-6 * width;

/** The largest of a function of directions nearby: what an error of a place may make of it. */
function steepness(map: EnvironmentMap, direction: Vec3, f: (direction: Vec3) => number): number {
  const step = Math.PI / map.height;
  const near = [step, -step].flatMap((s) => [0, 1, 2].map((c) => direction.map((x, k) => (k === c ? x + s : x))));
  return Math.max(...[direction, ...near].map((d) => f(normalize(d as unknown as Vec3))));
}

class Judge {
  readonly #map: EnvironmentMap;
  readonly #pdf: (direction: Vec3) => number;
  readonly faults: string[] = [];

  constructor(map: EnvironmentMap) {
    this.#map = map;
    const pdf = densityOnMap(map);
    this.#pdf = (direction) => pdf(direction, ROTATION);
  }

  #expect(what: string, got: number, direction: Vec3, exact: (direction: Vec3) => number): void {
    const wanted = exact(direction);
    // The weight is 0 at a pole and the sine too: of their quotient the digits go that the place has lost.
    const sine = Math.hypot(direction[0], direction[2]);
    const quotient = 4e-7 / Math.min((sine * this.#map.height) / Math.PI, 1);
    const tolerance = (2e-5 + quotient) * wanted + placeError(this.#map) * steepness(this.#map, direction, exact);
    if (!(Math.abs(got - wanted) <= tolerance)) this.faults.push(`${what} ${got}, not ${wanted}, at ${direction}`);
  }

  density(what: string, got: number, direction: Vec3): void {
    if (Math.hypot(direction[0], direction[2]) > 1e-6) this.#expect(what, got, direction, this.#pdf);
    else if (!Number.isFinite(got) || got < 0) this.faults.push(`${what} ${got} at a pole`);
  }

  radiance(what: string, got: number, direction: Vec3, of: (color: readonly number[]) => number): void {
    // A pole itself has no azimuth.
    if (Math.hypot(direction[0], direction[2]) < 1e-9) {
      if (!Number.isFinite(got) || got < 0) this.faults.push(`${what} ${got} at a pole`);
    } else this.#expect(what, got, direction, (d) => SCALE * of(radianceOfMap(this.#map, d, ROTATION)));
  }
}

const vector = ([x, y, z]: Answer): Vec3 => [x, y, z];
const ask = (what: Question['ask'], u: readonly [number, number], direction: Vec3 = [0, 0, 1]): Question => ({
  ask: what,
  emitter: 0,
  point: ORIGIN,
  u,
  vector: direction,
});

/** i / n beside the digits of i turned round, in 24 bits. */
function hammersley(n: number): [number, number][] {
  return Array.from({ length: n }, (_, i) => {
    let inverse = 0;
    for (let [digits, place] = [i, 0.5]; digits > 0; [digits, place] = [digits >>> 1, place / 2])
      inverse += (digits & 1) * place;
    return [Math.floor(((i + 0.5) / n) * 2 ** 24) / 2 ** 24, inverse];
  });
}

/** Poles, seams and anything else. */
function hardDirections(count: number): Vec3[] {
  const random = seededRandom(95);
  const hard: Vec3[] = [[0, 1, 0], [0, -1, 0], [0, 0, -1], [0, 0, 1], [1, 0, 0], [-1, 0, 0]]; // biome-ignore format: short
  for (const h of [1, -1])
    for (let e = -12; e < 0; e++) hard.push([10 ** e, h, 0], [0, h, 10 ** e], [-(10 ** e), h, -(10 ** e)]);
  for (let e = -12; e < 0; e++) hard.push([10 ** e, 0.3, -1], [-(10 ** e), 0.3, -1]);
  while (hard.length < count) hard.push(randomDirection(random));
  return hard.map((d) => rounded(normalize(d)));
}

async function judge(probe: EmitterProbe, name: string, map: EnvironmentMap): Promise<EnvironmentReport> {
  const scene = sceneOf(map);
  const random = seededRandom(94);
  const number = () => Math.floor(random() * 2 ** 24) / 2 ** 24;
  const places = Array.from({ length: MOST_QUESTIONS }, () => [number(), number()] as const);
  const askAll = (what: Question['ask']) => probe.ask(scene, places.map((u) => ask(what, u))); // biome-ignore format: short
  const samples = await askAll(ASK.directionAndPdf);
  const even = await probe.ask(scene, hammersley(MOST_QUESTIONS).map((u) => ask(ASK.directionAndPdf, u))); // biome-ignore format: short
  const lights = await askAll(ASK.radianceAndDistance);
  const rays = await askAll(ASK.pdfOfSample);
  const directions = hardDirections(1024);
  const looked = await probe.ask(scene, directions.map((d) => ask(ASK.pdfOfDirection, [0, 0], d))); // biome-ignore format: short
  return verdictOn(`map ${name}`, [samples, even, lights, rays, looked], () =>
    verdict(name, map, { samples, even, lights, rays, directions, looked }),
  );
}

interface Asked {
  readonly samples: readonly Answer[];
  readonly even: readonly Answer[];
  readonly lights: readonly Answer[];
  readonly rays: readonly Answer[];
  readonly directions: readonly Vec3[];
  readonly looked: readonly Answer[];
}

function verdict(name: string, map: EnvironmentMap, asked: Asked): EnvironmentReport {
  const { samples, even, lights, rays, directions, looked } = asked;
  const told = new Judge(map);
  samples.forEach((sample, k) => {
    const direction = normalize(vector(sample));
    if (!(Math.abs(length(vector(sample)) - 1) < 1e-6)) told.faults.push(`length ${length(vector(sample))}`);
    told.density('density', sample[3], direction);
    told.density('density of the ray', rays[k]![0], direction);
    told.radiance('radiance', mean(lights[k]!.slice(0, 3)), direction, mean);
  });
  looked.forEach(([pdf, , radiance], k) => {
    told.density('density of a direction', pdf, directions[k]!);
    told.radiance('radiance of a direction', radiance, directions[k]!, (c) => Math.hypot(...c));
  });
  const zOf = distributionOn(map);
  return {
    name,
    z: zOf(samples),
    zOfEven: zOf(even),
    ...meanOf(map, samples, lights),
    ...summary(told.faults),
  };
}

const summary = (faults: readonly string[]) => ({ faults: faults.length, examples: faults.slice(0, 4) });

/** The power heuristic's share of light samples beside samples that are uniform: light sampling alone does not find all of a map. */
const share = (pdf: number): number => pdf ** 2 / (pdf ** 2 + 1 / (4 * Math.PI) ** 2);

/** The green channel's, as it is the least like the mean that is sampled. */
function meanOf(map: EnvironmentMap, samples: readonly Answer[], lights: readonly Answer[]) {
  const values = samples.map(({ 3: pdf }, k) => (pdf > 0 ? (share(pdf) * lights[k]![1]) / pdf : 0));
  const average = values.reduce((sum, value) => sum + value, 0) / values.length;
  const variance = values.reduce((sum, value) => sum + (value - average) ** 2, 0) / values.length ** 2;
  const pdfOf = densityOnMap(map);
  const [step, down] = [Math.min(map.width / 256, 1 / 2), Math.min(map.height / 256, 1)];
  let exact = 0;
  for (let y = down / 2; y < map.height; y += down) {
    const theta = (Math.PI * y) / map.height;
    for (let x = step / 2; x < map.width; x += step) {
      const phi = (2 * Math.PI * x) / map.width;
      const direction: Vec3 = [Math.sin(theta) * Math.sin(phi), Math.cos(theta), -Math.sin(theta) * Math.cos(phi)];
      exact += share(pdfOf(direction)) * SCALE * radianceOfMap(map, direction)[1] * Math.sin(theta);
    }
  }
  exact *= (2 * Math.PI ** 2 * step * down) / (map.width * map.height);
  return { error: average / exact - 1, noise: Math.sqrt(variance) / exact };
}

/** In bins of half texels, or of many texels. */
function distributionOn(map: EnvironmentMap): (samples: readonly Answer[]) => number {
  const [columns, rows] = [Math.min(2 * map.width, 32), Math.min(2 * map.height, 16)];
  const bin = ([x, y]: readonly [number, number]) =>
    Math.min(Math.floor((y / map.height) * rows), rows - 1) * columns +
    Math.min(Math.floor((x / map.width) * columns), columns - 1);
  const shares = new Array<number>(columns * rows).fill(0);
  const total = overMap(map, (place) => {
    const density = placeDensity(map, place);
    shares[bin(place)]! += density / 4;
    return density;
  });
  return (samples) => {
    const counts = new Array<number>(columns * rows).fill(0);
    for (const sample of samples) counts[bin(placeOnMap(map, normalize(vector(sample)), ROTATION))]!++;
    return chiSquareZ(counts, shares.map((share) => (share / total) * samples.length)); // biome-ignore format: one thought
  };
}

export function probeEnvironments(backend: GpuBackend): Promise<EnvironmentReport[]> {
  return withProbe(backend, async (probe) => {
    const reports: EnvironmentReport[] = [];
    for (const [name, map] of Object.entries(ENVIRONMENTS)) reports.push(await judge(probe, name, map));
    return reports;
  });
}
