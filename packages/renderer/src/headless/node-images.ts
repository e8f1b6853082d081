/** `mirrorball/node-images`: images of models where there is no browser. */
import { type ImageDecoder, pngDecoder, withKtx2 } from '../gltf/images/decoder.ts';
import { readImageHead } from '../gltf/images/image-head.ts';
import { GLTF_LIMITS } from '../gltf/limits.ts';

const JPEG_LIMITS = { maxResolutionInMP: GLTF_LIMITS.imageSide ** 2 / 1e6, maxMemoryUsageInMB: 4096 };

/** Eight pixels square take two bits at least in each scan of each channel. */
const MOST_PIXELS_A_BYTE = 256;

const withJpeg: ImageDecoder = {
  canDecode: (type) => type === 'image/jpeg' || pngDecoder.canDecode(type),
  decode: async (bytes, type) => {
    if (type !== 'image/jpeg') return pngDecoder.decode(bytes, type);
    const head = readImageHead(bytes);
    if (head === null || head.width * head.height > bytes.length * MOST_PIXELS_A_BYTE)
      throw new Error('it has too few bytes for as many pixels as it claims');
    const { decode } = await import('jpeg-js');
    const options = { useTArray: true, formatAsRGBA: true, tolerantDecoding: false, ...JPEG_LIMITS } as const;
    try {
      const { width, height, data } = decode(bytes, options);
      return { width, height, rgba: data };
    } catch (error) {
      // It stumbles over what is not there, and says so in words of its code.
      const says = error instanceof Error && !(error instanceof TypeError || error instanceof RangeError);
      throw new Error(says ? error.message : 'it is damaged', { cause: error });
    }
  },
};

/** For `importGltf` under Node: PNG, JPEG and KTX2. WebP and AVIF are left to browsers, and told. */
export const nodeDecoder = (): ImageDecoder => withKtx2(withJpeg);
