import { DeviceError, type GlslSource } from '../device.ts';

/**
 * Compiles and links without blocking where KHR_parallel_shader_compile is there. Its `DeviceError` carries the compiler's log. `fragment`: the
 * text of that stage.
 */
export async function compileProgram(
  gl: WebGL2RenderingContext,
  source: GlslSource,
  fragment: string,
): Promise<WebGLProgram> {
  const parallel = gl.getExtension('KHR_parallel_shader_compile');
  const program = gl.createProgram();
  const shaders = [
    shader(gl, gl.VERTEX_SHADER, source.glsl.vertex),
    shader(gl, gl.FRAGMENT_SHADER, withSwitches(fragment, source.switches ?? {})),
  ];
  for (const s of shaders) gl.attachShader(program, s);
  gl.linkProgram(program);
  if (parallel) {
    while (!gl.isContextLost() && !gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR))
      await new Promise((resolve) => setTimeout(resolve, 4));
  }
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    if (gl.isContextLost()) throw new DeviceError('The WebGL2 context was lost while compiling.');
    const log = [gl.getProgramInfoLog(program), ...shaders.map((s) => gl.getShaderInfoLog(s))]
      .filter(Boolean)
      .join('\n');
    throw new DeviceError(`The WebGL2 program "${source.label}" does not compile:\n${log}`);
  }
  for (const s of shaders) gl.deleteShader(s);
  return program;
}

function shader(gl: WebGL2RenderingContext, type: number, text: string): WebGLShader {
  const s = gl.createShader(type);
  if (!s) throw new DeviceError('The WebGL2 context is lost.');
  gl.shaderSource(s, text);
  gl.compileShader(s);
  return s;
}

/** scripts/shaders.ts writes a switch as a constant; in a built page there may be no spaces around the `=`. */
function withSwitches(glsl: string, switches: Readonly<Record<string, boolean>>): string {
  let text = glsl;
  for (const [name, on] of Object.entries(switches))
    text = text.replace(new RegExp(`\\bconst bool ${name} ?= ?(true|false);`), `const bool ${name}=${on};`);
  return text;
}
