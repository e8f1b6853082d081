import { expect, test } from 'vitest';
import { contentOf, tamePicture } from '../../../../tests/fixtures/pictures.ts';
import { colourOnly, fromInterleaved, interleave } from './float-picture.ts';
import { formatOf, PICTURE_FORMATS } from './formats.ts';
import { ImageError } from './image-error.ts';

test('a format is known by its ending, in letters of any size', () => {
  expect(['out.exr', 'a.b.PNG', 'x.Pfm', 'dir.exr/y.npy', '.hdr'].map((name) => formatOf(name).name)).toEqual([
    ...['EXR', 'PNG', 'PFM', 'NPY', 'HDR'],
  ]);
});

test.each(['out.jpg', 'exr', 'out', 'exr.', ''])('%j is no picture file that can be written', (name) => {
  expect(() => formatOf(name)).toThrow(ImageError);
  expect(() => formatOf(name)).toThrow('expected .exr, .png, .pfm, .npy, .hdr.');
});

test.each(PICTURE_FORMATS)(
  '$name: what the table says of texts and channels holds',
  ({ write, read, texts, channels }) => {
    const picture = { ...tamePicture(81, 3, 2, ['R', 'G', 'B']), texts: { scene: '{}' } };
    expect(read(write(picture)).texts?.scene).toBe(texts ? '{}' : undefined);
    const layers = tamePicture(82, 3, 2, ['R', 'G', 'B', 'depth.Z', 'id.Z']);
    if (channels === 'colour') expect(() => write(layers)).toThrow(ImageError);
    else expect(read(write(layers)).channels).toHaveLength(5);
  },
);

test('a view into a larger buffer is read as well, seed 83', () => {
  for (const { write, read } of PICTURE_FORMATS) {
    const file = write(tamePicture(83, 9, 4, ['R', 'G', 'B']));
    const buffer = new Uint8Array(file.length + 8).fill(255);
    buffer.set(file, 3);
    expect(contentOf(read(buffer.subarray(3, file.length + 3)))).toEqual(contentOf(read(file)));
  }
});

test('pixels with a fourth value that is left out', () => {
  const film = [1, 2, 3, 16, 4, 5, 6, 16];
  const picture = fromInterleaved(2, 1, ['R', 'G', 'B'], film, 4);
  expect(Array.from(interleave(picture))).toEqual([1, 2, 3, 4, 5, 6]);
});

test('colours are put in their order', () => {
  const picture = tamePicture(84, 1, 1, ['B', 'A', 'G', 'R']);
  expect(colourOnly('PNG', picture, [3, 4]).channels.map(({ name }) => name)).toEqual(['R', 'G', 'B', 'A']);
});
