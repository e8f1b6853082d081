/** Compiles every generated shader for real: naga's word is not enough. */
type Texts = Record<string, string>;

const glsl = import.meta.glob<string>(
  ['../../../packages/renderer/src/shading/generated/*.glsl', './generated/*.glsl'],
  {
    query: '?raw',
    import: 'default',
    eager: true,
  },
);
const wgsl = import.meta.glob<string>(
  ['../../../packages/renderer/src/shading/generated/*.wgsl', './generated/*.wgsl'],
  {
    query: '?raw',
    import: 'default',
    eager: true,
  },
);

const nameOf = (path: string) => path.split('/').at(-1)!;

/** What WebGPU says of each module, '' when nothing. */
async function compileWgsl(): Promise<Texts> {
  const adapter = await navigator.gpu.requestAdapter();
  const device = await adapter!.requestDevice();
  const said: Texts = {};
  for (const [path, code] of Object.entries(wgsl)) {
    device.pushErrorScope('validation');
    const { messages } = await device.createShaderModule({ code }).getCompilationInfo();
    const error = await device.popErrorScope();
    const texts = messages.map((m) => `${m.type} at ${m.lineNum}:${m.linePos}: ${m.message}`);
    said[nameOf(path)] = [...texts, error?.message ?? ''].join('');
  }
  device.destroy();
  return said;
}

const PASS_THROUGH_VERTEX = '#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n';

function compile(gl: WebGL2RenderingContext, type: number, text: string): { shader: WebGLShader; log: string } {
  const shader = gl.createShader(type)!;
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  const failed = gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? '' : 'does not compile: ';
  return { shader, log: failed + (gl.getShaderInfoLog(shader) ?? '') };
}

/** What WebGL2 says of each shader, '' when nothing. Fragment shaders without inputs are linked as well. */
function compileGlsl(): Texts {
  const gl = document.createElement('canvas').getContext('webgl2')!;
  const said: Texts = {};
  for (const [path, text] of Object.entries(glsl)) {
    const isVertex = text.includes('gl_Position');
    const { shader, log } = compile(gl, isVertex ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER, text);
    said[nameOf(path)] = log;
    if (isVertex || /^\s*(smooth |flat )?in /m.test(text)) continue;
    const program = gl.createProgram();
    gl.attachShader(program, shader);
    gl.attachShader(program, compile(gl, gl.VERTEX_SHADER, PASS_THROUGH_VERTEX).shader);
    gl.linkProgram(program);
    const linked = gl.getProgramParameter(program, gl.LINK_STATUS) ? '' : 'does not link: ';
    said[nameOf(path)] += linked + (gl.getProgramInfoLog(program) ?? '');
  }
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return said;
}

export const compileAll = async () => ({ wgsl: await compileWgsl(), glsl: compileGlsl() });
