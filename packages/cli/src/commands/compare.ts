/** `mirrorball compare a b`: numbers that say how far a picture is from a reference. */
import { comparePictures, ImageError } from 'mirrorball/picture-files';
import { usage } from '../exit-codes.ts';
import { flip } from '../flip.ts';
import { readMeasured } from '../picture-file.ts';
import type { Terminal } from '../terminal.ts';

export async function compare(a: string, b: string, terminal: Terminal): Promise<void> {
  const [ours, reference] = [await readMeasured(a), await readMeasured(b)];
  const { blocks, ...numbers } = measure(a, ours, reference);
  const flipMean = await flip(ours.mean, reference.mean);
  terminal.event('compared', { a, b, ...numbers, blocks: blocks.length, flip: flipMean });
  const worst = blocks.reduce((most, block) => (Math.abs(block.z[3]) > Math.abs(most.z[3]) ? block : most));
  const percentage = (share: number) => `${(share * 100).toPrecision(3)} %`;
  const lines = [
    ['relMSE', `${numbers.relMse.toPrecision(4)} (without the worst 0.1 %: ${numbers.trimmedRelMse.toPrecision(4)})`],
    ['MAE', numbers.mae.toPrecision(4)],
    ['mean', `${percentage(numbers.bias[3])} ± ${percentage(numbers.biasError[3])}`],
    [
      'z of blocks',
      `RMS ${numbers.rmsZ.toPrecision(3)}, ${percentage(numbers.beyond3)} beyond 3, worst ${numbers.worstZ.toPrecision(3)} at ${worst.x},${worst.y}`,
    ],
    ['FLIP', flipMean === null ? 'not known: pip install flip-evaluator numpy' : flipMean.toPrecision(4)],
    ...(numbers.nonFinitePixels > 0 ? [['NaN or Inf', `${numbers.nonFinitePixels} pixels`]] : []),
    ...(numbers.negativePixels > 0 ? [['negative', `${numbers.negativePixels} pixels`]] : []),
  ];
  for (const [name, value] of lines) terminal.result(`${name!.padEnd(12)} ${value}`);
}

type Measured = Awaited<ReturnType<typeof readMeasured>>;

function measure(a: string, ours: Measured, reference: Measured) {
  try {
    const mask = reference.mask ?? ours.mask;
    return comparePictures(ours, reference, mask ? { mask } : {});
  } catch (error) {
    if (error instanceof ImageError) throw usage(`${a}: ${error.message}`);
    throw error;
  }
}
