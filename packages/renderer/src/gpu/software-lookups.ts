/**
 * Programs for SwiftShader, the software rasteriser of browsers, with texels looked up in the way that is quickest there. A lookup that names
 * a level of detail, as texelFetch and textureSampleLevel do, works out for each of four pixels by itself which level that is; and texelFetch
 * compares its place with the size of the texture. One that leaves the level to the sampler does neither where a texture has a single level
 * and the sampler takes the nearest texel. What it finds is the same. A GPU would work out differences to the pixels beside it, which loops and
 * branches do not allow everywhere; so this is for software alone.
 */

/** Where a texel's step is added up to a place in GLSL: a uniform of each texture, 1 / its width and height. */
export const stepOf = (texture: string): string => `${texture}Step`;

/** `textures`: those whose lookups change; each then needs its uniform. */
export function glslForSoftware(glsl: string, textures: readonly string[]): string {
  const changed = new Set<string>();
  const text = replaceCalls(glsl, 'texelFetch', ([texture, place, ...rest]) => {
    if (!textures.includes(texture!)) return `texelFetch(${[texture, place, ...rest].join(',')})`;
    changed.add(texture!);
    return `texture(${texture},(vec2(${place})+0.5)*${stepOf(texture!)})`;
  });
  const steps = [...changed].map((texture) => `uniform highp vec2 ${stepOf(texture)};\n`).join('');
  // Behind the line that names the version.
  return text.replace(/^#version .*\n/, (line) => line + steps);
}

/** Of the entry of a fragment stage. A module that has a compute pass too stays as it is: such passes must name the level. */
export function wgslForSoftware(wgsl: string): string {
  if (/@compute\b/.test(wgsl)) return wgsl;
  const text = replaceCalls(wgsl, 'textureSampleLevel', ([texture, sampler, place]) => {
    return `textureSample(${texture},${sampler},${place})`;
  });
  return text === wgsl ? wgsl : `diagnostic(off,derivative_uniformity);\n${text}`;
}

/** Every call of a function by what `write` makes of its arguments, in which calls of it are replaced as well. */
function replaceCalls(text: string, name: string, write: (given: readonly string[]) => string): string {
  const call = `${name}(`;
  let written = '';
  let at = 0;
  for (let begin = text.indexOf(call); begin >= 0; begin = text.indexOf(call, at)) {
    const given: string[] = [];
    let from = begin + call.length;
    for (let i = from, depth = 0; depth >= 0; i++) {
      const letter = text[i];
      if (letter === undefined) throw new Error(`A call of ${name} does not end.`);
      if (letter === '(' || letter === '[') depth++;
      else if (letter === ')' || letter === ']') depth--;
      if (depth < 0 || (depth === 0 && letter === ',')) {
        given.push(replaceCalls(text.slice(from, i), name, write).trim());
        from = i + 1;
      }
    }
    written += text.slice(at, begin) + write(given);
    at = from;
  }
  return written + text.slice(at);
}
