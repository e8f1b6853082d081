import { expect, test } from 'vitest';
import { type DataBuffer, type Device, DeviceError, noRoom } from './gpu/device.ts';
import type { PackedTextures } from './packed-scene/pack-textures.ts';
import { createBlock } from './packed-scene/write-struct.ts';
import { TexelBuffer } from './texel-buffer.ts';

/** Keeps what is written, and knows how many buffers there are. */
class FakeDevice {
  alive = 0;
  writes = 0;
  words = new Uint32Array();
  most = Infinity;

  createData(rows: number, what: string): DataBuffer {
    if (rows > this.most) throw noRoom(what, 'maxBufferSize', this.most * 16, rows * 16);
    this.alive++;
    const words = new Uint32Array(rows * 4);
    this.words = words;
    return {
      rows,
      write: (row, given) => {
        this.writes++;
        words.set(given, row * 4);
      },
      destroy: () => {
        this.alive--;
      },
    };
  }
}
const held = () => {
  const device = new FakeDevice();
  return { device, buffer: new TexelBuffer(device as unknown as Device) };
};

function packed(rgba: Uint8Array, number: number): PackedTextures {
  const uses = createBlock(32);
  uses.u32[0] = number;
  const rows = 2 + Math.ceil(rgba.length / 16);
  return { uses, images: [{ pixels: { width: rgba.length / 4, height: 1, rgba }, row: 2 }], rows };
}

test('an image goes up as it is, wherever it lies in memory and whatever its size', () => {
  for (const length of [4, 16, 20, 64, 4 * 1_000_003])
    for (const offset of [0, 1, 4]) {
      const bytes = Uint8Array.from({ length: length + offset }, (_, i) => (i * 7) % 251);
      const { device, buffer } = held();
      buffer.hold(packed(bytes.subarray(offset), 5));
      const there = new Uint8Array(device.words.buffer, 32, length);
      expect(
        there.every((byte, i) => byte === bytes[offset + i]),
        `${length} bytes from ${offset} on`,
      ).toBe(true);
      expect(device.words[0]).toBe(5);
    }
});

test('images go up once, what they are used for each time', () => {
  const { device, buffer } = held();
  const rgba = new Uint8Array(64);
  const first = packed(rgba, 1);
  buffer.hold(first);
  const before = device.writes;
  buffer.hold({ ...packed(rgba, 2), images: first.images });
  expect([device.writes - before, device.words[0], device.alive]).toEqual([1, 2, 1]);
  buffer.hold(packed(new Uint8Array(64), 3));
  expect([device.words[0], device.alive]).toEqual([3, 1]);
});

test('too many of them are refused with the limit, and what was there stays', () => {
  const { device, buffer } = held();
  buffer.hold(packed(new Uint8Array(64), 1));
  const kept = buffer.buffer;
  device.most = 100;
  const tooLarge = () => buffer.hold(packed(new Uint8Array(16 * 200), 1));
  expect(tooLarge).toThrow(DeviceError);
  expect(tooLarge).toThrow('The textures of this scene need 0.0 MiB');
  expect(buffer.buffer).toBe(kept);
});
