// ?size=512&hits=10: the square picture's pixels along a side, and how many surfaces a path may meet.
const query = new URLSearchParams(location.search);
const size = Number(query.get('size') ?? 512);
const hits = Number(query.get('hits') ?? 10);

const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('canvas'));
canvas.width = canvas.height = size;
const gl = canvas.getContext('webgl2', { antialias: false, alpha: false });
if (!gl) throw new Error('This browser has no WebGL2.');

/**
 * @param {WebGL2RenderingContext} gl
 * @param {string} fragmentSource
 */
function link(gl, fragmentSource) {
  const vertexSource = `#version 300 es
    void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;
  const program = gl.createProgram();
  for (const [kind, source] of /** @type {const} */ ([
    [gl.VERTEX_SHADER, vertexSource],
    [gl.FRAGMENT_SHADER, fragmentSource],
  ])) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? '');
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? '');
  return program;
}

const program = link(gl, await (await fetch('room.frag.glsl')).text());
gl.useProgram(program);
gl.uniform1f(gl.getUniformLocation(program, 'side'), size);
gl.uniform1i(gl.getUniformLocation(program, 'hitLimit'), hits);
const eye = gl.getUniformLocation(program, 'eye');
let frames = 0;

// The eye sways a little, as it would in use, so that no frame equals the one before.
function draw() {
  gl?.uniform3f(eye, 0.02 * Math.sin(0.1 * frames++), 1.4, 2.8);
  gl?.drawArrays(gl.TRIANGLES, 0, 3);
  requestAnimationFrame(draw);
}
// For bench/frame-cost.mjs: the next frame is as the first.
Object.assign(window, { restartFrames: () => (frames = 0) });
requestAnimationFrame(draw);
