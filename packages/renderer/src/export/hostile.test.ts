/** Files that are cut off or changed: an ImageError or a picture, and nothing else. */
import { readFileSync } from 'node:fs';
import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { tamePicture } from '../../../../tests/fixtures/pictures.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { readExr, writeExr } from './exr.ts';
import type { FloatPicture } from './float-picture.ts';
import { formatOf, PICTURE_FORMATS } from './formats.ts';
import { ImageError } from './image-error.ts';
import { arrayAsPicture, writeNpy } from './npy.ts';
import { readNpz } from './npz.ts';
import { joinChunks, readChunks } from './png/chunks.ts';
import { readPng, writePng } from './png.ts';

const fixture = (name: string): Uint8Array =>
  Uint8Array.from(readFileSync(new URL(`../../../../tests/fixtures/images/${name}`, import.meta.url)));
const picture: FloatPicture = { ...tamePicture(71, 10, 5, ['R', 'G', 'B']), texts: { scene: 'Übung 场' } };
const readMean = (bytes: Uint8Array): FloatPicture => arrayAsPicture(readNpz(bytes).read('mean'));

interface Subject {
  readonly name: string;
  readonly file: Uint8Array;
  read(bytes: Uint8Array): FloatPicture;
}
const SUBJECTS: Subject[] = [
  ...PICTURE_FORMATS.map(({ name, write, read }) => ({ name, file: write(picture), read })),
  { name: 'EXR of halves', file: writeExr(picture, { half: true }), read: readExr },
  { name: 'EXR with RLE', file: fixture('rle-layer.exr'), read: readExr },
  { name: 'EXR with PIZ', file: fixture('piz-half.exr'), read: readExr },
  { name: 'NPZ', file: zipSync({ 'mean.npy': writeNpy(picture) }), read: readMean },
];

/** "error", or "picture"; anything else fails the test. No picture may be larger than what the bytes can hold. */
function outcome({ read }: Subject, bytes: Uint8Array): string {
  try {
    const { width, height, channels } = read(bytes);
    expect(width * height * channels.length).toBeLessThanOrEqual(bytes.length * 1100);
    return 'picture';
  } catch (error) {
    if (error instanceof ImageError && error.message.length < 400) return 'error';
    throw error;
  }
}

test.each(SUBJECTS)('$name: no beginning of a file passes for one', (subject) => {
  const step = Math.max(1, Math.floor(subject.file.length / 1000));
  for (let length = 0; length < subject.file.length; length += step)
    expect(outcome(subject, subject.file.subarray(0, length))).toBe('error');
  expect(outcome(subject, subject.file)).toBe('picture');
});

test.each(SUBJECTS)('$name: bytes changed at random, seed 72', (subject) => {
  const random = seededRandom(72);
  const { length } = subject.file;
  for (let round = 0; round < 400; round++) {
    const bytes = subject.file.slice();
    const reach = round % 2 ? length : Math.min(length, 400); // heads are where mistakes hurt
    for (let k = Math.floor(random() * 4); k >= 0; k--)
      bytes[Math.floor(random() * reach)] = random() < 0.3 ? 255 : random() * 256;
    outcome(subject, bytes);
  }
});

test.each(SUBJECTS)('$name: its beginning, then noise, seed 73', (subject) => {
  const random = seededRandom(73);
  for (let round = 0; round < 100; round++) {
    const kept = Math.floor(random() * subject.file.length);
    outcome(subject, subject.file.map((byte, i) => (i < kept ? byte : random() * 256))); // biome-ignore format: one call
  }
});

test('PNG with right check sums but changed insides, seed 74', () => {
  const random = seededRandom(74);
  const subject = { name: 'PNG', file: writePng(picture), read: readPng };
  for (let round = 0; round < 300; round++) {
    const chunks = readChunks(subject.file).map(({ type, data }) => ({ type, data: data.slice() }));
    const { data } = chunks[Math.floor(random() * chunks.length)]!;
    if (data.length > 0) data[Math.floor(random() * data.length)] = random() * 256;
    outcome(subject, joinChunks(chunks));
  }
});

test('an error names the part, what was found and what is allowed', () => {
  expect.assertions(3);
  try {
    formatOf('a.PFM').read(Uint8Array.from([80, 70, 10]));
  } catch (error) {
    expect(error).toBeInstanceOf(ImageError);
    const { part, found, allowed, message } = error as ImageError;
    expect({ part, found, allowed }).toEqual({
      part: 'PFM line of sizes',
      found: '0 bytes left',
      allowed: 'the 1 byte that it needs',
    });
    expect(message).toBe('The PFM line of sizes has 0 bytes left; expected the 1 byte that it needs.');
  }
});
