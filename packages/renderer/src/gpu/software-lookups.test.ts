import { describe, expect, it } from 'vitest';
import { glslForSoftware, wgslForSoftware } from './software-lookups.ts';

describe('glslForSoftware', () => {
  it('leaves the level of detail to the sampler, and gives each texture its step once', () => {
    const glsl =
      '#version 300 es\nprecision highp float;\nvoid main(){a=texelFetch(film,ivec2(at),0);b=texelFetch(film, ivec2(f(x, y[z]), 1), 0);}';
    expect(glslForSoftware(glsl, ['film', 'data'])).toBe(
      '#version 300 es\nuniform highp vec2 filmStep;\nprecision highp float;\nvoid main(){' +
        'a=texture(film,(vec2(ivec2(at))+0.5)*filmStep);b=texture(film,(vec2(ivec2(f(x, y[z]), 1))+0.5)*filmStep);}',
    );
  });

  it('changes lookups within lookups', () => {
    const glsl = '#version 300 es\ntexelFetch(a,ivec2(texelFetch(b,p,0).xy),0)';
    expect(glslForSoftware(glsl, ['a', 'b'])).toContain(
      'texture(a,(vec2(ivec2(texture(b,(vec2(p)+0.5)*bStep).xy))+0.5)*aStep)',
    );
  });

  it('leaves textures alone that it is not told of', () => {
    const glsl = '#version 300 es\ntexelFetch(other,p,0)';
    expect(glslForSoftware(glsl, ['film'])).toBe(glsl);
  });
});

describe('wgslForSoftware', () => {
  it('leaves the level of detail to the sampler, and says that this is meant', () => {
    expect(wgslForSoftware('a = textureSampleLevel(table, nearest, vec2f(f(x), y), 0.0);')).toBe(
      'diagnostic(off,derivative_uniformity);\na = textureSample(table,nearest,vec2f(f(x), y));',
    );
  });

  it('leaves a text alone that has a compute pass too, which must name the level', () => {
    const wgsl = 'fn f() { textureSampleLevel(t, s, p, 0.0); } @compute @workgroup_size(1) fn g() { f(); }';
    expect(wgslForSoftware(wgsl)).toBe(wgsl);
  });

  it('leaves a text without lookups alone', () => {
    expect(wgslForSoftware('fn f() {}')).toBe('fn f() {}');
  });
});
