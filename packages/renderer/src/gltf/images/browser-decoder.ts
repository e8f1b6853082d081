/** Images by the browser. The one place of glTF that knows a canvas; runs in workers too. */
import type { ImagePixels } from '../../scene/textures.ts';
import type { ImageDecoder } from './decoder.ts';
import { readImageHead } from './image-head.ts';
import { unturned } from './unturned.ts';

const TYPES = ['image/png', 'image/jpeg', 'image/webp', 'image/avif'];

/** Null where there is no browser. */
export function browserDecoder(): ImageDecoder | null {
  if (typeof createImageBitmap !== 'function' || typeof OffscreenCanvas !== 'function') return null;
  return { canDecode: (type) => TYPES.includes(type), decode };
}

async function decode(bytes: Uint8Array, type: string): Promise<ImagePixels> {
  const blob = new Blob([unturned(bytes) as Uint8Array<ArrayBuffer>], { type });
  const options = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' } as const;
  const bitmap = await createImageBitmap(blob, options).catch(() => {
    throw new Error('this browser cannot decode it');
  });
  try {
    // A 2D canvas multiplies with alpha and loses what lies under transparent pixels.
    const opaque = readImageHead(bytes)?.alpha === false;
    return (opaque ? null : readByTexture(bitmap)) ?? readByCanvas(bitmap);
  } finally {
    bitmap.close();
  }
}

function readByCanvas(bitmap: ImageBitmap): ImagePixels {
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser gives no canvas of its size');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  return { width, height, rgba: new Uint8Array(data.buffer) };
}

/** By way of a WebGL2 texture, which keeps the numbers as they are; null where that is not to be had. */
function readByTexture(bitmap: ImageBitmap): ImagePixels | null {
  const { width, height } = bitmap;
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (!gl) return null;
  try {
    if (Math.max(width, height) > gl.getParameter(gl.MAX_TEXTURE_SIZE)) return null;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const rgba = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    return gl.getError() === gl.NO_ERROR ? { width, height, rgba } : null;
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}
