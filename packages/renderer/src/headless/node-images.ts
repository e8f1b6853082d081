/** `mirrorball/node-images`: images of models where there is no browser. */
import { type ImageDecoder, pngDecoder, withKtx2 } from '../gltf/images/decoder.ts';
import { GLTF_LIMITS } from '../gltf/limits.ts';

const JPEG_LIMITS = { maxResolutionInMP: GLTF_LIMITS.imageSide ** 2 / 1e6, maxMemoryUsageInMB: 4096 };

const withJpeg: ImageDecoder = {
  canDecode: (type) => type === 'image/jpeg' || pngDecoder.canDecode(type),
  decode: async (bytes, type) => {
    if (type !== 'image/jpeg') return pngDecoder.decode(bytes, type);
    const { decode } = await import('jpeg-js');
    const options = { useTArray: true, formatAsRGBA: true, tolerantDecoding: false, ...JPEG_LIMITS } as const;
    const { width, height, data } = decode(bytes, options);
    return { width, height, rgba: data };
  },
};

/** For `importGltf` under Node: PNG, JPEG and KTX2. WebP and AVIF are left to browsers, and told. */
export const nodeDecoder = (): ImageDecoder => withKtx2(withJpeg);
