import { decode } from 'fast-png';
import { TONE_MAPPINGS } from '../../packages/renderer/src/scene/tone-mappings.ts';
import { backends, expect, test } from './fixtures.ts';

/** The canvas shows what the same steps in TypeScript make of the film: exposure, tone mapping, sRGB curve. */
const SIZE = [64, 48] as const;

for (const backend of backends)
  for (const toneMapping of TONE_MAPPINGS)
    test(`${toneMapping} on ${backend} = TypeScript, to one step of 255`, async ({ harness }) => {
      for (const exposure of [0, -3, 2]) {
        const bytes = await harness.evaluate(([b, look, [w, h]]) => window.harness.displayed(b, look, w, h), [
          backend,
          { exposure, toneMapping },
          SIZE,
        ] as const);
        const { data, width, height, channels } = decode(await harness.locator(`#displayed-${backend}`).screenshot());
        expect([width, height]).toEqual(SIZE);
        let largest = 0;
        for (let pixel = 0; pixel < width * height; pixel++)
          for (let c = 0; c < 3; c++)
            largest = Math.max(largest, Math.abs(data[pixel * channels + c]! - bytes[pixel * 4 + c]!));
        expect.soft(largest, `exposure ${exposure}: largest difference`).toBeLessThanOrEqual(1);
      }
    });
