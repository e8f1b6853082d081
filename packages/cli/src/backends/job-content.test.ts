import { expect, test } from 'vitest';
import { attach, createArray, detachArrays, detachContents, kindOf } from './job-content.ts';

test('contents leave a job and come back, also through JSON; one that is there twice is one', () => {
  const rock = { positions: Float32Array.of(1, 2.5), indices: Uint32Array.of(4e9), uvs: [Float32Array.of(0.5)], skin: { joints: Uint16Array.of(7) } }; // biome-ignore format: one thing
  const map = { width: 1, height: 1, data: Float32Array.of(1, 2, 3) };
  const job = {
    scene: { sky: { map, scale: 2 }, meshes: { a: { data: rock }, b: { data: rock, file: 'b.ply' } } },
    seed: 3,
  };
  const contents: object[] = [];
  const numberOf = (content: object) =>
    contents.includes(content) ? contents.indexOf(content) : contents.push(content) - 1;
  const sent = JSON.parse(JSON.stringify(detachContents(job, numberOf)));
  expect(contents).toEqual([map, rock]);
  const received = contents.map((content) => {
    const { frame, arrays } = detachArrays(content);
    const copies = arrays.map((array) => {
      const copy = createArray(kindOf(array), array.length);
      copy.set(array);
      return copy;
    });
    return attach(JSON.parse(JSON.stringify(frame)), (number) => copies[number]!);
  });
  const back = attach(sent, (number) => received[number]!);
  expect(back).toEqual(job);
  expect(back.scene.meshes.a.data).toBe(back.scene.meshes.b.data);
});
