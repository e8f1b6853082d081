import { strToU8, zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { readZip, ZIP_LIMITS } from './zip.ts';

const archive = () =>
  zipSync({
    fox: { 'fox.gltf': strToU8('{"asset":{}}'), 'tex ä.bin': [new Uint8Array(1000).fill(7), { level: 0 }] },
    __MACOSX: { '._fox.gltf': strToU8('note') },
    empty: {},
  });
/** Where the archive's last record begins, and the first of its list. */
const endOf = (zip: Uint8Array) => zip.length - 22;
const viewOf = (zip: Uint8Array) => new DataView(zip.buffer, zip.byteOffset);
const listOf = (zip: Uint8Array) => viewOf(zip).getUint32(endOf(zip) + 16, true);

test('gives the files of an archive, packed and as they are, without notes and folders', async () => {
  const files = readZip(archive());
  expect(files.map(({ path, size }) => [path, size])).toEqual([
    ['fox/fox.gltf', 12],
    ['fox/tex ä.bin', 1000],
  ]);
  expect(new TextDecoder().decode(await files[0]!.read())).toBe('{"asset":{}}');
  expect(await files[1]!.read()).toEqual(new Uint8Array(1000).fill(7));
});

test('an archive of more files than anybody needs is refused before its list is read', () => {
  const zip = zipSync({ a: new Uint8Array(1) });
  viewOf(zip).setUint16(endOf(zip) + 10, ZIP_LIMITS.entries + 1, true);
  expect(() => readZip(zip)).toThrow('at most 10000 are read');
});

test('claims are held against limits, and nothing is made of them', () => {
  const zip = zipSync({ 'bomb.bin': new Uint8Array(1000) });
  viewOf(zip).setUint32(listOf(zip) + 24, 2 ** 30, true);
  expect(() => readZip(zip)).toThrow('where at most');
  viewOf(zip).setUint32(listOf(zip) + 24, 2 ** 31, true);
  expect(() => readZip(zip)).toThrow('has 2147483648 bytes');
});

test('a file that is larger or smaller than it says is damaged', async () => {
  for (const claimed of [999, 1001]) {
    const zip = zipSync({ a: new Uint8Array(1000) });
    viewOf(zip).setUint32(listOf(zip) + 24, claimed, true);
    await expect(readZip(zip)[0]!.read()).rejects.toThrow('it is damaged in the archive');
  }
});

test('content that does not fit its check sum is damaged', async () => {
  const zip = zipSync({ a: new Uint8Array(1000) });
  viewOf(zip).setUint32(listOf(zip) + 16, 1, true);
  await expect(readZip(zip)[0]!.read()).rejects.toThrow('check sum');
});

test.each(['../a.glb', '/a.glb', 'a/../../b.glb', 'C:\\a.glb', '\\a.glb'])('the path %s is refused', (path) => {
  expect(() => readZip(zipSync({ [path]: new Uint8Array(1) }))).toThrow('leads out of the archive');
});

test.each([
  ['an encrypted file', 8, 1, 'is encrypted'],
  ['another method', 10, 14, 'only deflate'],
])('%s is told by name', (_, at, value, message) => {
  const zip = zipSync({ 'a.glb': new Uint8Array(1) });
  viewOf(zip).setUint16(listOf(zip) + at, value, true);
  expect(() => readZip(zip)).toThrow(message);
  expect(() => readZip(zip)).toThrow('"a.glb"');
});

test('cut off anywhere, or changed at random (seed 11), an archive is read or refused, and nothing else happens', async () => {
  const whole = archive();
  const broken = Array.from({ length: whole.length }, (_, length) => whole.slice(0, length));
  const random = seededRandom(11);
  for (let i = 0; i < 2000; i++) {
    const changed = whole.slice();
    for (let k = 0; k < 3; k++) changed[Math.floor(random() * changed.length)] = Math.floor(random() * 256);
    broken.push(changed);
  }
  let refused = 0;
  for (const zip of broken) {
    try {
      for (const file of readZip(zip)) await file.read();
    } catch (error) {
      expect((error as Error).message).toMatch(/^(it |its |one of its )/);
      refused++;
    }
  }
  expect(refused).toBeGreaterThan(whole.length);
});
