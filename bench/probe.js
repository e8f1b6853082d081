// Goes into every measured page before its own scripts. It finds the first picture, and can hold the page's animation
// frames to run them one by one. It changes nothing else about the page.
(() => {
  const nextFrame = window.requestAnimationFrame.bind(window);
  /** @type {Map<number, FrameRequestCallback>} */
  const waiting = new Map();
  let lastId = 1e6;
  let holding = false;
  let scheduled = false;
  /** @type {(() => void)[]} */
  const whenWaiting = [];
  /** What drew last. @type {{ canvas: HTMLCanvasElement, gl: WebGL2RenderingContext | null } | null} */
  let drawn = null;
  /** @type {Set<GPUQueue>} */
  const queues = new Set();

  // ── animation frames
  function runFrames(/** @type {number} */ time) {
    const callbacks = [...waiting.values()];
    waiting.clear();
    for (const callback of callbacks) callback(time);
  }
  function schedule() {
    for (const wake of whenWaiting.splice(0)) wake();
    if (holding || scheduled || waiting.size === 0) return;
    scheduled = true;
    nextFrame((time) => {
      scheduled = false;
      if (!holding) runFrames(time);
    });
  }
  window.requestAnimationFrame = (callback) => {
    waiting.set(++lastId, callback);
    schedule();
    return lastId;
  };
  window.cancelAnimationFrame = (id) => void waiting.delete(id);

  // ── pixels
  function readGl(/** @type {WebGL2RenderingContext} */ gl, /** @type {number} */ width, /** @type {number} */ height) {
    const framebuffer = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    const packBuffer = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const bytes = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, packBuffer);
    return bytes;
  }
  /** Bottom row first, as WebGL reads. Right only in the task that drew. */
  function pixels() {
    if (!drawn) return null;
    const { canvas, gl } = drawn;
    const { width, height } = canvas;
    if (gl) return { width, height, bytes: readGl(gl, width, height) };
    const copy = document.createElement('canvas');
    Object.assign(copy, { width, height });
    const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext('2d', { willReadFrequently: true }));
    context.setTransform(1, 0, 0, -1, 0, height);
    context.drawImage(canvas, 0, 0);
    return { width, height, bytes: new Uint8Array(context.getImageData(0, 0, width, height).data.buffer) };
  }
  /** A picture has at least 8 coarse colours on a grid of 64 × 64 points, and more than 2 % of them are not black. */
  function isPicture() {
    const read = pixels();
    if (!read) return false;
    const colours = new Set();
    let lit = 0;
    for (let k = 0; k < 4096; k++) {
      const x = Math.floor((((k & 63) + 0.5) * read.width) / 64);
      const y = Math.floor((((k >> 6) + 0.5) * read.height) / 64);
      const [r = 0, g = 0, b = 0] = read.bytes.subarray((y * read.width + x) * 4);
      colours.add(((r >> 3) << 10) | ((g >> 3) << 5) | (b >> 3));
      if (r + g + b > 24) lit++;
    }
    return colours.size >= 8 && lit > 4096 * 0.02;
  }

  // ── drawing: each draw is followed by a look, at the end of the code that drew, until there is a picture
  let looking = false;
  function look() {
    if (probe.firstPicture !== null || looking) return;
    looking = true;
    queueMicrotask(() => {
      looking = false;
      if (isPicture()) probe.firstPicture = performance.now();
    });
  }
  for (const name of /** @type {const} */ (['drawArrays', 'drawElements', 'drawArraysInstanced'])) {
    const draw = /** @type {any} */ (WebGL2RenderingContext.prototype[name]);
    /** @type {any} */ (WebGL2RenderingContext.prototype)[name] = function (/** @type {unknown[]} */ ...args) {
      draw.apply(this, args);
      if (this.canvas instanceof HTMLCanvasElement) drawn = { canvas: this.canvas, gl: this };
      look();
    };
  }
  if (window.GPUQueue) {
    const currentTexture = GPUCanvasContext.prototype.getCurrentTexture;
    GPUCanvasContext.prototype.getCurrentTexture = function () {
      if (this.canvas instanceof HTMLCanvasElement) drawn = { canvas: this.canvas, gl: null };
      return currentTexture.call(this);
    };
    const submit = GPUQueue.prototype.submit;
    GPUQueue.prototype.submit = function (buffers) {
      queues.add(this);
      submit.call(this, buffers);
      look();
    };
  }

  // ── single steps
  async function finished() {
    await Promise.all([...queues].map((queue) => queue.onSubmittedWorkDone()));
    if (drawn?.gl) readGl(drawn.gl, 1, 1);
  }
  const frameWaits = () =>
    waiting.size > 0
      ? Promise.resolve()
      : new Promise((resolve) => {
          whenWaiting.push(() => resolve(undefined));
          setTimeout(resolve, 3000);
        });
  function base64(/** @type {Uint8Array} */ bytes) {
    let text = '';
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(text);
  }
  const probe = {
    /** Milliseconds from the start of navigation. @type {number | null} */
    firstPicture: null,
    hold() {
      holding = true;
    },
    /** Runs one frame; `before` prepares it. Gives the milliseconds until the GPU is done. */
    async step(/** @type {() => void} */ before) {
      await frameWaits();
      before();
      const start = performance.now();
      runFrames(start);
      await finished();
      return performance.now() - start;
    },
    /** Runs one frame and gives its pixels, bottom row first, as base64. */
    async stepAndRead(/** @type {() => void} */ before) {
      await frameWaits();
      before();
      runFrames(performance.now());
      return base64(pixels()?.bytes ?? new Uint8Array());
    },
    /** A film of linear radiance, row 0 on top, as `stepAndRead` gives a canvas: clipped, sRGB bytes, bottom row first. */
    encode(/** @type {{ width: number, height: number, pixels: Float32Array }} */ { width, height, pixels: film }) {
      const bytes = new Uint8Array(width * height * 4).fill(255);
      for (let y = 0; y < height; y++)
        for (let x = 0; x < width; x++)
          for (let c = 0; c < 3; c++) {
            const linear = Math.min(Math.max(film[(y * width + x) * 4 + c] ?? 0, 0), 1);
            const curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
            bytes[((height - 1 - y) * width + x) * 4 + c] = Math.round(curve * 255);
          }
      return base64(bytes);
    },
  };
  /** @type {any} */ (window).benchProbe = probe;
})();
