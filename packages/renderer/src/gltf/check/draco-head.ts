/** What a Draco stream says of itself: github.com/google/draco, src/draco/compression, bitstream 2.2. */

export interface DracoHead {
  readonly faces: number;
  /** Edge-breaker streams tell the vertices of the connectivity, of which attributes may have more. */
  readonly points: number;
}

const MAGIC = [0x44, 0x52, 0x41, 0x43, 0x4f]; // "DRACO"
const MESH = 1;
const HAS_METADATA = 0x8000;

/** The counts; 'unknown' for versions and parts that are not looked through; null for what is no Draco mesh. */
export function readDracoHead(bytes: Uint8Array): DracoHead | 'unknown' | null {
  if (bytes.length < 12 || MAGIC.some((byte, i) => bytes[i] !== byte)) return null;
  const [major, minor, type, method] = [bytes[5]!, bytes[6]!, bytes[7]!, bytes[8]!];
  const flags = bytes[9]! | (bytes[10]! << 8);
  if (type !== MESH || method > 1) return null;
  if (major !== 2 || minor !== 2 || flags & HAS_METADATA) return 'unknown';
  let at = 11;
  const varint = (): number => {
    let value = 0;
    for (let shift = 0; shift < 35; shift += 7) {
      const byte = bytes[at++];
      if (byte === undefined) return Number.NaN;
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
    return Number.NaN;
  };
  if (method === 1) at++; // which edge-breaker
  const [first, second] = [varint(), varint()];
  if (Number.isNaN(first + second)) return null;
  // Sequential streams begin with the faces, edge-breaker with the vertices.
  return method === 1 ? { points: first, faces: second } : { faces: first, points: second };
}
