/** FLIP (Andersson et al. 2020, 2021), the visible difference, by NVIDIA's own program where Python has it. */
import { execFile } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type FloatPicture, writePfm } from 'mirrorball/picture-files';

/** Reads PFM by itself: the package's own reader would need more packages. */
const PROGRAM = `
import sys, numpy, flip_evaluator
def read(path):
    with open(path, 'rb') as file:
        kind, size, scale = file.readline(), file.readline().split(), float(file.readline())
        count = 3 if kind.strip() == b'PF' else 1
        data = numpy.frombuffer(file.read(), '<f4' if scale < 0 else '>f4').reshape(int(size[1]), int(size[0]), count)
        return numpy.ascontiguousarray(numpy.repeat(data[::-1], 3 // count, 2), dtype=numpy.float32)
print('flip', float(flip_evaluator.evaluate(read(sys.argv[1]), read(sys.argv[2]), 'HDR')[1]))
`;

/** The mean over the picture, 0 … 1; null where flip-evaluator is not installed. */
export async function flip(picture: FloatPicture, reference: FloatPicture): Promise<number | null> {
  const folder = await mkdtemp(join(tmpdir(), 'mirrorball-flip-'));
  try {
    const files = [join(folder, 'reference.pfm'), join(folder, 'picture.pfm')];
    await writeFile(files[0]!, writePfm(colours(reference)));
    await writeFile(files[1]!, writePfm(colours(picture)));
    return await new Promise((resolve) => {
      execFile(process.platform === 'win32' ? 'python' : 'python3', ['-c', PROGRAM, ...files], (error, stdout) => {
        const value = /^flip (.+)$/m.exec(stdout)?.[1];
        resolve(error || value === undefined ? null : Number(value));
      });
    });
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

const colours = (picture: FloatPicture): FloatPicture => ({
  ...picture,
  channels: picture.channels.filter(({ name }) => name !== 'A'),
});
