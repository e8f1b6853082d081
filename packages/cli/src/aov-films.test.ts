import type { FilmJob, FilmTracer } from 'mirrorball/headless';
import { expect, test } from 'vitest';
import { AccumulatedFilm } from './accumulated-film.ts';
import { aovSamples, firstOf, traceAovs } from './aov-films.ts';
import { aovFile, checkAovs, checkErrorKnown, mayBeHalf } from './aov-pictures.ts';

test('the first samples of some ranges', () => {
  const ranges = [
    { first: 3, last: 5 },
    { first: 8, last: 20 },
  ];
  expect(firstOf(ranges, 2)).toEqual([{ first: 3, last: 4 }]);
  expect(firstOf(ranges, 3)).toEqual([{ first: 3, last: 5 }]);
  expect(firstOf(ranges, 5)).toEqual([
    { first: 3, last: 5 },
    { first: 8, last: 9 },
  ]);
  expect(firstOf(ranges, 99)).toEqual(ranges);
});

test('progress is counted in the samples of all films together, and never goes back', async () => {
  const film = new AccumulatedFilm(1);
  for (const first of [0, 32]) film.put(first, Float32Array.of(1, 1, 1, 32));
  const told: number[] = [];
  const tracer = {
    description: '',
    begin: async () => {},
    trace: async (...[, count, onto, options]: Parameters<FilmTracer['trace']>) => {
      options?.onProgress?.(count / 2);
      return Float32Array.of(1, 1, 1, (onto?.[3] ?? 0) + count, 0, 0, 0, 0).subarray(0, 4);
    },
    dispose: () => {},
  };
  const names = ['depth', 'albedo', 'indirect'] as const;
  const job = { settings: { integrator: 'path', maxDepth: -1 } } as FilmJob;
  const progress = { update: (samples: number) => void told.push(samples), stop: () => {} };
  await traceAovs(names, tracer, job, film, new AbortController().signal, progress);
  expect(told).toEqual([...told].sort((a, b) => a - b));
  expect([aovSamples(names, film), told.at(-1)]).toEqual([192, 192]);
  expect(aovSamples(['samples'], film)).toBe(0);
});

test('a file of its own for each, and frames keep their number', () => {
  expect(aovFile('a.b/out.png', 'albedo')).toBe('a.b/out.albedo.png');
  expect(aovFile('out.0007.npy', 'primitive-id')).toBe('out.0007.primitive-id.npy');
});

test('what a format cannot hold is refused with what can', () => {
  expect(() => checkAovs(['albedo', 'direct'], 'x.png', false)).not.toThrow();
  expect(() => checkAovs(['albedo', 'depth', 'normal'], 'x.png', false)).toThrow(
    'PNG holds colours from 0 to 1 only. Write .exr, .npy or .pfm for these AOVs: depth, normal.',
  );
  expect(() => checkAovs(['position'], 'x.hdr', false)).toThrow('HDR holds colours only');
  for (const file of ['x.exr', 'x.npy', 'x.pfm'])
    expect(() => checkAovs(['depth', 'position', 'error'], file, false)).not.toThrow();
  expect(() => checkAovs(['depth'], 'x.part', true)).toThrow('A part file holds no AOVs');
  expect(() => checkAovs(['depth'], undefined, false)).toThrow('--aov needs -o');
});

test('an error needs two blocks of samples', () => {
  expect(() => checkErrorKnown(['error'], { first: 0, last: 31 })).toThrow('--spp 64');
  expect(() => checkErrorKnown(['error'], { first: 0, last: 32 })).not.toThrow();
  expect(() => checkErrorKnown(['error'], { first: 256, last: 511 })).toThrow('all others blocks of 256');
  expect(() => checkErrorKnown(['error'], { first: 256, last: 512 })).not.toThrow();
  expect(() => checkErrorKnown(['depth'], { first: 0, last: 0 })).not.toThrow();
});

test('16 bits are for colours and normals alone', () => {
  expect(['R', 'albedo.G', 'N.X', 'Ng.Z', 'direct.B'].every(mayBeHalf)).toBe(true);
  expect(['depth.Z', 'P.X', 'primitiveId.Y', 'materialId.Y', 'samples.Y'].some(mayBeHalf)).toBe(false);
});
