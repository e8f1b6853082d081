/** Puts finished 8-bit pictures on a canvas, stretched over it. */
import { DeviceError } from './gpu/device.ts';
import { webGl2Context } from './gpu/webgl2/webgl2-device.ts';

export type ShowStill = (picture: ImageData) => void;

/**
 * By the canvas's 2D context; or, when a WebGL2 that turned out too weak to trace has the canvas already, by that one's copying,
 * which needs no shader. Rejects with `DeviceError` when the canvas belongs to something else.
 */
export async function openStillScreen(canvas: HTMLCanvasElement): Promise<ShowStill> {
  const context = canvas.getContext('2d');
  if (context) return (picture) => drawStill(context, picture);
  const gl = await webGl2Context(canvas);
  if (gl) return (picture) => blitStill(gl, picture);
  throw new DeviceError('The canvas gives no 2D context; it may have been used with another one before.');
}

function drawStill(context: CanvasRenderingContext2D, picture: ImageData): void {
  const { width, height } = picture;
  const small = Object.assign(context.canvas.ownerDocument.createElement('canvas'), { width, height });
  small.getContext('2d')!.putImageData(picture, 0, 0);
  context.drawImage(small, 0, 0, context.canvas.width, context.canvas.height);
}

function blitStill(gl: WebGL2RenderingContext, { width, height, data }: ImageData): void {
  const texture = gl.createTexture();
  const framebuffer = gl.createFramebuffer();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, data);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
  const { drawingBufferWidth: w, drawingBufferHeight: h } = gl;
  gl.blitFramebuffer(0, 0, width, height, 0, h, w, 0, gl.COLOR_BUFFER_BIT, gl.LINEAR);
  gl.deleteFramebuffer(framebuffer);
  gl.deleteTexture(texture);
}
