// Goes into the measured page before its own scripts: notes when the canvas changes, and how large what the page asks of the GPU is.
(() => {
  const SIDE = 32;
  /** @type {{ time: number, small: Uint8ClampedArray }[]} */
  const looks = [];
  let looking = false;
  let queued = false;
  const small = new OffscreenCanvas(SIDE, SIDE).getContext('2d', { willReadFrequently: true });
  /** In the task that drew, as a canvas may forget its picture afterwards. @param {HTMLCanvasElement} canvas */
  function look(canvas) {
    if (!looking || queued || !small) return;
    queued = true;
    queueMicrotask(() => {
      queued = false;
      small.clearRect(0, 0, SIDE, SIDE);
      small.drawImage(canvas, 0, 0, SIDE, SIDE);
      looks.push({ time: performance.now(), small: small.getImageData(0, 0, SIDE, SIDE).data });
    });
  }

  const { drawArrays } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
    drawArrays.call(this, mode, first, count);
    if (this.getParameter(this.DRAW_FRAMEBUFFER_BINDING) === null) look(/** @type {HTMLCanvasElement} */ (this.canvas));
  };
  /** Bytes of each buffer and texture of more than a megabyte that exists. @type {Map<object, number>} */
  const bytes = new Map();
  const LEAST = 2 ** 20;
  const { texStorage2D, deleteTexture } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.texStorage2D = function (target, levels, format, width, height) {
    texStorage2D.call(this, target, levels, format, width, height);
    const size = width * height * 16;
    const texture = this.getParameter(this.TEXTURE_BINDING_2D);
    // Of what has four numbers of 32 bits a texel, integers are data; pictures are floats.
    if (format === this.RGBA32UI && size >= LEAST) bytes.set(texture, size);
  };
  WebGL2RenderingContext.prototype.deleteTexture = function (texture) {
    deleteTexture.call(this, texture);
    if (texture) bytes.delete(texture);
  };
  if (window.GPUQueue) {
    /** @type {HTMLCanvasElement | null} */
    let canvas = null;
    const { getCurrentTexture } = GPUCanvasContext.prototype;
    GPUCanvasContext.prototype.getCurrentTexture = function () {
      canvas = /** @type {HTMLCanvasElement} */ (this.canvas);
      return getCurrentTexture.call(this);
    };
    const { submit } = GPUQueue.prototype;
    GPUQueue.prototype.submit = function (buffers) {
      submit.call(this, buffers);
      if (canvas) look(canvas);
      canvas = null;
    };
    const { createBuffer } = GPUDevice.prototype;
    GPUDevice.prototype.createBuffer = function (wish) {
      const buffer = createBuffer.call(this, wish);
      if (wish.usage & GPUBufferUsage.STORAGE && wish.size >= LEAST) bytes.set(buffer, wish.size);
      return buffer;
    };
    const { createTexture } = GPUDevice.prototype;
    GPUDevice.prototype.createTexture = function (wish) {
      const texture = createTexture.call(this, wish);
      const size = texture.width * texture.height * 16;
      // Data that shaders only read; a film is drawn into.
      const data =
        wish.format === 'rgba32float' &&
        !(wish.usage & (GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.STORAGE_BINDING));
      if (data && size >= LEAST) bytes.set(texture, size);
      return texture;
    };
    for (const kind of [GPUBuffer, GPUTexture]) {
      const { destroy } = kind.prototype;
      kind.prototype.destroy = function () {
        destroy.call(this);
        bytes.delete(this);
      };
    }
  }

  const difference = (/** @type {Uint8ClampedArray} */ a, /** @type {Uint8ClampedArray} */ b) =>
    a.reduce((sum, x, i) => sum + Math.abs(x - (b[i] ?? 0)), 0) / a.length;
  const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));

  /** @type {any} */ (window).sizeProbe = {
    /** Bytes of each large buffer. */
    data: () => [...bytes.values()],
    /**
     * Opens what the page's own file input was given; resolves when the path tracer has drawn it. All times in milliseconds since then.
     * @param {string} name the scene's
     */
    async watch(/** @type {string} */ name) {
      looks.length = 0;
      const input = /** @type {HTMLInputElement} */ (document.getElementById('scene-file'));
      await new Promise((resolve) => input.addEventListener('change', resolve, { once: true, capture: true }));
      const start = performance.now();
      const mirrorball = /** @type {any} */ (window).mirrorball;
      /** @type {Record<string, number>} */
      const phases = {};
      let shown = 0;
      let compiled = 0;
      for (;;) {
        const { renderer } = mirrorball;
        const now = performance.now() - start;
        const text = document
          .getElementById('opening')
          ?.textContent?.replace(/[\d.,%…]+/g, '')
          .trim();
        if (text && !(text in phases)) phases[text] = now;
        if (!shown && renderer?.scene?.name === name) [shown, looking] = [now, true];
        if (shown && !compiled && !renderer.compiling) compiled = now;
        // What is drawn from now on is traced.
        if (compiled && (looks.at(-1)?.time ?? 0) - start > compiled && renderer.stats.samples > 0) break;
        if (now > 120_000) throw new Error('There was no picture within two minutes.');
        await nextFrame();
      }
      looking = false;
      const last = looks.at(-1);
      if (!last) throw new Error('Nothing has been drawn.');
      // Means of a sketch's bytes differ by two or three of 255 from the picture's; those of the scene before, shown once more, by thirty.
      const first = looks.find(({ small }) => difference(small, last.small) < 10);
      const traced = last.time - start;
      return {
        phases,
        shown,
        compiled,
        sketch: (first?.time ?? Number.NaN) - start,
        traced,
      };
    },
  };
})();
