/** The program beside the XML: renders it, and adds to Mitsuba what it has not. */
export const pythonProgram = (
  name: string,
): string => `"""Renders ${name.replace(/["\\]/g, '')}.xml with Mitsuba 3, made by Mirrorball.

    pip install mitsuba numpy
    python ${name}.py -o out.exr
    python ${name}.py --batches 16 --spp 64 -o out.npz   # "mean" and "se", the standard error by the scatter of batches

What Mitsuba lacks is here. Two BSDFs: GGX with the height-correlated masking of glTF (Heitz 2014), as metal, as glTF's
metallic-roughness material with its normal map and as rough glass, and a mirror layer over a base. Three textures: a product of a colour,
a texture and the colours of vertices; a texture by the second set of coordinates; and how much of a surface is there.
"""
import argparse
import os

import drjit as dr
import mitsuba as mi

parser = argparse.ArgumentParser()
parser.add_argument('-o', '--output', default='${name}.exr')
parser.add_argument('--variant', default='llvm_ad_rgb', help='llvm_ad_rgb or cuda_ad_rgb')
parser.add_argument('--spp', type=int, default=64, help='samples a pixel of each batch')
parser.add_argument('--batches', type=int, default=1)
parser.add_argument('--seed', type=int, default=0)
options = parser.parse_args()
mi.set_variant(options.variant)


def color(text):
    return mi.Color3f([float(x) for x in text.split(',')])


def vectors(text):
    x = [float(x) for x in text.split(',')]
    return [mi.Vector3f(*x[i : i + 3]) for i in range(0, len(x), 3)]


def given(props, name, default=None):
    return props[name] if name in props else default


class Product(mi.Texture):
    """factor · map · colors"""

    def __init__(self, props):
        mi.Texture.__init__(self, props)
        self.factor, self.map, self.colors = color(props['factor']), given(props, 'map'), given(props, 'colors')
        self.varies = not given(props, 'sampled_by_area', False)

    def eval(self, si, active=True):
        value = mi.Color3f(self.factor)
        for part in (self.map, self.colors):
            if part is not None:
                value *= part.eval(si, active)
        return value

    def eval_3(self, si, active=True):
        return self.eval(si, active)

    def is_spatially_varying(self):
        return self.varies

    def to_string(self):
        return 'mirrorball_product[]'


class SecondSet(mi.Texture):
    """map, at the place that another set of coordinates says"""

    def __init__(self, props):
        mi.Texture.__init__(self, props)
        self.map, self.place = props['map'], props['place']

    def moved(self, si, active):
        uv = self.place.eval_3(si, active)
        there = mi.SurfaceInteraction3f(si)
        there.uv = mi.Point2f(uv.x, uv.y)
        return there

    def eval(self, si, active=True):
        return self.map.eval(self.moved(si, active), active)

    def eval_1(self, si, active=True):
        return self.map.eval_1(self.moved(si, active), active)

    def eval_3(self, si, active=True):
        return self.map.eval_3(self.moved(si, active), active)

    def is_spatially_varying(self):
        return True

    def to_string(self):
        return 'mirrorball_second_set[]'


class Presence(mi.Texture):
    """factor · map · colors, or whether that is at least cutoff; and perhaps nothing from behind"""

    def __init__(self, props):
        mi.Texture.__init__(self, props)
        self.factor, self.cutoff = float(props['factor']), float(props['cutoff'])
        self.one_sided = bool(props['one_sided'])
        self.map, self.colors = given(props, 'map'), given(props, 'colors')

    def eval_1(self, si, active=True):
        there = mi.Float(self.factor)
        for part in (self.map, self.colors):
            if part is not None:
                there *= part.eval_1(si, active)
        if self.cutoff >= 0:
            there = dr.select(there >= self.cutoff, mi.Float(1), mi.Float(0))
        if self.one_sided:
            there = dr.select(dr.dot(si.n, si.to_world(si.wi)) > 0, there, 0)
        return there

    def eval(self, si, active=True):
        return mi.Color3f(self.eval_1(si, active))

    def is_spatially_varying(self):
        return True

    def to_string(self):
        return 'mirrorball_presence[]'


def valid_normal(g, o, n):
    """Turned towards g until o, mirrored, leaves the surface, as in Cycles; all to one side."""
    oz = dr.maximum(dr.dot(o, g), 0)
    least = dr.minimum(0.9 * oz, 0.01)
    across = n - dr.dot(n, g) * g
    x = across * dr.rsqrt(dr.maximum(dr.squared_norm(across), 1e-20))
    ox = dr.dot(o, x)
    a = dr.maximum(ox * ox + oz * oz, 1e-20)
    b = 2 * (a + oz * least)
    c = dr.square(least + oz)
    root = dr.safe_sqrt(b * b - 4 * a * c)
    z2 = dr.clip(0.25 * dr.select(ox < 0, b + root, b - root) / a, 0, 1)
    raised = dr.sqrt(1 - z2) * x + dr.sqrt(z2) * g
    return dr.select(dr.dot(g, 2 * dr.dot(n, o) * n - o) >= least, n, raised)


def density(h, alpha):
    """GGX: facets around the half vector h."""
    slope = (dr.square(h.x) + dr.square(h.y)) / (alpha * alpha) + dr.square(h.z)
    return dr.inv_pi / (alpha * alpha * dr.square(dr.maximum(slope, 1)))


def stretched(w, alpha):
    return dr.sqrt(dr.square(w.z) + alpha * alpha * (dr.square(w.x) + dr.square(w.y)))


def visible_normal(w, alpha, u):
    """Dupuy and Benyoub 2023: a normal that w (w.z > 0) sees."""
    v = dr.normalize(mi.Vector3f(alpha * w.x, alpha * w.y, w.z))
    phi = dr.two_pi * u.x
    z = dr.fma(1 - u.y, 1 + v.z, -v.z)
    s = dr.safe_sqrt(1 - z * z)
    h = mi.Vector3f(s * dr.cos(phi), s * dr.sin(phi), z) + v
    return dr.normalize(mi.Vector3f(alpha * h.x, alpha * h.y, dr.maximum(h.z, 1e-7)))


def normal_pdf(w, h, alpha):
    return density(h, alpha) * 2 * dr.dot(w, h) / (w.z + stretched(w, alpha))


def masking(a, b, alpha):
    """Both shadowed and masked, height-correlated: 1 / (1 + L(a) + L(b))."""
    x, y = dr.abs(a.z), dr.abs(b.z)
    return 2 * x * y / (stretched(a, alpha) * y + stretched(b, alpha) * x)


def schlick(f0, cosine, f90=1):
    return f0 + (f90 - f0) * dr.power(dr.maximum(1 - cosine, 0), 5)


def conductor(cosine, eta, k):
    """Vacuum over metal (Born and Wolf, 14.2)."""
    cosine2 = cosine * cosine
    sine2 = 1 - cosine2
    difference = eta * eta - k * k - sine2
    root = dr.sqrt(difference * difference + 4 * eta * eta * k * k)
    a2 = 0.5 * (root + difference)
    a = dr.safe_sqrt(a2)
    across = (root - 2 * a * cosine + cosine2) / (root + 2 * a * cosine + cosine2)
    far, near = root * cosine2 + sine2 * sine2, 2 * a * cosine * sine2
    return 0.5 * across * (1 + (far - near) / (far + near))


class Here:
    """The numbers of an opaque surface at a point, and the frame there."""


class Opaque(mi.BSDF):
    """reflectivity · mirror + (1 - reflectivity) · base, from both sides alike."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.kind = props['kind']
        base = props['base_color']
        self.base, self.base_map = (color(base), None) if isinstance(base, str) else (None, base)
        self.eta, self.k = color(props['eta']), color(props['k'])
        self.alpha, self.metallic = float(props['alpha']), float(props['metallic'])
        self.metallic_roughness = given(props, 'metallic_roughness')
        self.mirror = float(props['reflectivity'])
        ior = float(props['ior'])
        self.f0 = 1.0 if ior == 0 else ((ior - 1) / (ior + 1)) ** 2
        self.weight, self.weight_map = float(given(props, 'specular_weight', 1)), given(props, 'specular_weight_map')
        self.tint, self.tint_map = color(given(props, 'specular_color', '1, 1, 1')), given(props, 'specular_color_map')
        self.normal_map = given(props, 'normal_map')
        if self.normal_map is not None:
            self.normal_scale = float(props['normal_scale'])
            self.turn = vectors(props['normals_into_world'])
            self.own = [props['own_normal'], props['own_tangent'], props['own_hand']]
        self.smooth = self.kind != 'diffuse' and self.alpha < 1e-3
        # How often the facets are sampled rather than the diffuse part.
        self.share = {'diffuse': 0.0, 'gltf': 0.5}.get(self.kind, 1.0)
        if self.kind == 'gltf' and self.metallic == 1 and self.metallic_roughness is None:
            self.share = 1.0
        sides = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        lobes = []
        if self.mirror > 0 or self.smooth:
            lobes.append(mi.BSDFFlags.DeltaReflection | sides)
        if self.kind == 'diffuse' or not self.smooth or self.share < 1:
            lobes.append(mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.DiffuseReflection | sides)
        flags = lobes[0]
        for lobe in lobes[1:]:
            flags = flags | lobe
        self.m_components = lobes
        self.m_flags = flags

    def at(self, si, active):
        here = Here()
        here.base = mi.Color3f(self.base) if self.base_map is None else self.base_map.eval(si, active)
        here.alpha, here.metallic = mi.Float(self.alpha), mi.Float(self.metallic)
        if self.metallic_roughness is not None:
            texel = self.metallic_roughness.eval_3(si, active)
            here.metallic *= texel.z
            if not self.smooth:
                here.alpha = dr.maximum(here.alpha * texel.y * texel.y, 1e-3)
        here.f90 = mi.Float(self.weight)
        if self.weight_map is not None:
            here.f90 *= self.weight_map.eval_1(si, active)
        here.f0 = mi.Color3f(self.f0 * self.tint)
        if self.tint_map is not None:
            here.f0 *= self.tint_map.eval(si, active)
        here.f0 = dr.minimum(here.f0, 1) * here.f90
        here.frame = si.sh_frame if self.normal_map is None else self.bent(si, active)
        here.n = si.n
        here.i = si.to_world(si.wi)
        here.side = dr.select(dr.dot(here.frame.n, here.i) < 0, mi.Float(-1), mi.Float(1))
        here.wi = self.inside(here, here.i)
        return here

    def bent(self, si, active):
        """The frame of the normal map, worked out in the space of the mesh as MikkTSpace wants it."""
        bump = 2 * mi.Vector3f(self.normal_map.eval_3(si, active)) - 1
        bump.x *= self.normal_scale
        bump.y *= self.normal_scale
        normal, tangent = (mi.Vector3f(part.eval_3(si, active)) for part in self.own[:2])
        hand = dr.select(self.own[2].eval_1(si, active) < 0, mi.Float(-1), mi.Float(1))
        bitangent = hand * dr.cross(normal, tangent)
        turned = lambda v: mi.Vector3f(dr.dot(self.turn[0], v), dr.dot(self.turn[1], v), dr.dot(self.turn[2], v))
        front = dr.select(dr.dot(turned(normal), si.n) < 0, mi.Float(-1), mi.Float(1))
        mapped = turned(bump.x * tangent + bump.y * bitangent + bump.z * normal) * front
        mapped = dr.select(dr.squared_norm(mapped) > 0, dr.normalize(mapped), si.sh_frame.n)
        o = si.to_world(si.wi)
        side = dr.select(dr.dot(si.n, o) < 0, mi.Float(-1), mi.Float(1))
        n = side * valid_normal(side * si.n, o, side * mapped)
        flat = (bump.x == 0) & (bump.y == 0) & (bump.z == 1)
        return mi.Frame3f(dr.select(flat, si.sh_frame.n, n))

    @staticmethod
    def inside(here, w):
        """Out of the world, above the surface as it is seen."""
        local = here.frame.to_local(w)
        return mi.Vector3f(local.x, local.y, local.z * here.side)

    def fresnel(self, here, cosine):
        if self.kind == 'conductor':
            return conductor(cosine, self.eta, self.k)
        if self.kind == 'tint':
            return here.base
        return dr.lerp(schlick(here.f0, cosine, here.f90), schlick(here.base, cosine), here.metallic)

    def diffuse(self, here, cosine):
        if self.kind == 'diffuse':
            return here.base
        if self.kind != 'gltf':
            return mi.Color3f(0)
        return (1 - here.metallic) * (1 - dr.max(schlick(here.f0, cosine, here.f90))) * here.base

    def scattered(self, here, wo):
        """Value times cosine, and density, of what is no delta; both above."""
        wi = here.wi
        h = dr.normalize(wi + wo)
        cosine = dr.dot(wi, h)
        value = self.diffuse(here, cosine) * (dr.inv_pi * wo.z)
        pdf = (1 - self.share) * dr.inv_pi * wo.z
        if not self.smooth and self.share > 0:
            facets = density(h, here.alpha)
            value += self.fresnel(here, cosine) * (facets * masking(wi, wo, here.alpha) / (4 * wi.z))
            pdf += self.share * facets / (2 * (wi.z + stretched(wi, here.alpha)))
        good = (wi.z > 0) & (wo.z > 0)
        return dr.select(good, value * (1 - self.mirror), 0), dr.select(good, pdf * (1 - self.mirror), 0)

    @staticmethod
    def stays(here, out):
        """What is opaque lets no light through, even where a normal says that it comes from the front."""
        return (dr.dot(here.n, here.i) > 0) == (dr.dot(here.n, out) > 0)

    def sample(self, ctx, si, u1, u2, active=True):
        here = self.at(si, active)
        wi = here.wi
        reflected = mi.Vector3f(-wi.x, -wi.y, wi.z)
        base = u1 >= self.mirror
        u = dr.clip((u1 - self.mirror) / max(1 - self.mirror, 1e-20), 0, 1)
        facet = u < self.share
        delta = ~base | (facet if self.smooth else mi.Bool(False))
        disc = mi.warp.square_to_cosine_hemisphere(u2)
        if self.smooth or self.share == 0:
            wo = disc
        else:
            h = visible_normal(wi, here.alpha, u2)
            wo = dr.select(facet, 2 * dr.dot(wi, h) * h - wi, disc)
        value, pdf = self.scattered(here, wo)
        weight = dr.select(pdf > 0, value / pdf, 0)
        if self.smooth:
            # The mirror layer and a smooth base send light the same way, so they are one.
            both = (1 - self.mirror) * self.fresnel(here, wi.z)
            chance = self.mirror + (1 - self.mirror) * self.share
            straight, straight_pdf = (self.mirror + both) / chance, chance
        else:
            straight, straight_pdf = mi.Color3f(1), self.mirror
        wo = dr.select(delta, reflected, wo)
        out = here.frame.to_world(mi.Vector3f(wo.x, wo.y, wo.z * here.side))
        bs = mi.BSDFSample3f()
        bs.wo = si.to_local(out)
        bs.pdf = dr.select(delta, straight_pdf, pdf)
        bs.eta = 1.0
        bs.sampled_component = mi.UInt32(0)
        bs.sampled_type = dr.select(delta, mi.UInt32(+mi.BSDFFlags.DeltaReflection), mi.UInt32(+mi.BSDFFlags.GlossyReflection))
        good = active & (wi.z > 0) & (delta | (wo.z > 0)) & self.stays(here, out)
        return bs, dr.select(good, dr.select(delta, straight, weight), 0)

    def both(self, si, wo, active):
        here = self.at(si, active)
        out = si.to_world(wo)
        value, pdf = self.scattered(here, self.inside(here, out))
        good = active & self.stays(here, out)
        return dr.select(good, value, 0), dr.select(good, pdf, 0)

    def eval(self, ctx, si, wo, active=True):
        return self.both(si, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self.both(si, wo, active)[1]

    def eval_pdf(self, ctx, si, wo, active=True):
        return self.both(si, wo, active)

    def traverse(self, callback):
        pass

    def to_string(self):
        return 'mirrorball_opaque[]'


class Glass(mi.BSDF):
    """Rough dielectric after Walter et al. 2007."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.alpha, self.ior = float(props['alpha']), float(props['ior'])
        sides = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        lobes = [
            mi.BSDFFlags.GlossyReflection | sides,
            mi.BSDFFlags.GlossyTransmission | sides | mi.BSDFFlags.NonSymmetric,
        ]
        self.m_components = lobes
        self.m_flags = lobes[0] | lobes[1]

    def parts(self, si):
        side = dr.select(si.wi.z < 0, mi.Float(-1), mi.Float(1))
        ratio = dr.select(si.wi.z < 0, 1 / self.ior, mi.Float(self.ior))
        return side, ratio, mi.Vector3f(si.wi.x, si.wi.y, si.wi.z * side)

    @staticmethod
    def reflected_share(cosine, ratio):
        inside2 = (ratio - 1) * (ratio + 1) + dr.square(cosine)
        inside = dr.safe_sqrt(inside2)
        across = (cosine - inside) / (cosine + inside)
        along = (ratio * ratio * cosine - inside) / (ratio * ratio * cosine + inside)
        return dr.select(inside2 > 0, 0.5 * (dr.square(across) + dr.square(along)), 1)

    def scattered(self, si, wo_given):
        side, ratio, wi = self.parts(si)
        wo = mi.Vector3f(wo_given.x, wo_given.y, wo_given.z * side)
        reflects = wo.z > 0
        h = dr.normalize(dr.select(reflects, wi + wo, wi + ratio * wo))
        h = dr.select(h.z < 0, -h, h)
        ih, oh = dr.dot(wi, h), dr.dot(wo, h)
        good = (wi.z > 0) & (ih > 0) & (oh * wo.z > 0)
        share = self.reflected_share(ih, ratio)
        facets = density(h, self.alpha) * masking(wi, wo, self.alpha)
        normals = normal_pdf(wi, h, self.alpha)
        bend = dr.square(ih + ratio * oh)
        value = dr.select(reflects, share * facets / (4 * wi.z), (1 - share) * facets * ih * dr.abs(oh) / (wi.z * bend))
        pdf = dr.select(reflects, share * normals / (4 * ih), (1 - share) * normals * ratio * ratio * dr.abs(oh) / bend)
        return dr.select(good, value, 0), dr.select(good, pdf, 0)

    def sample(self, ctx, si, u1, u2, active=True):
        side, ratio, wi = self.parts(si)
        h = visible_normal(wi, self.alpha, u2)
        cosine = dr.dot(wi, h)
        reflects = u1 < self.reflected_share(cosine, ratio)
        inside = dr.safe_sqrt((ratio - 1) * (ratio + 1) + dr.square(cosine))
        wo = dr.select(reflects, 2 * cosine * h - wi, ((cosine - inside) * h - wi) / ratio)
        out = mi.Vector3f(wo.x, wo.y, wo.z * side)
        value, pdf = self.scattered(si, out)
        good = active & (pdf > 0) & dr.select(reflects, wo.z > 0, wo.z < 0)
        bs = mi.BSDFSample3f()
        bs.wo, bs.pdf = out, pdf
        bs.eta = dr.select(reflects, 1, ratio)
        bs.sampled_component = dr.select(reflects, mi.UInt32(0), mi.UInt32(1))
        bs.sampled_type = dr.select(reflects, mi.UInt32(+mi.BSDFFlags.GlossyReflection), mi.UInt32(+mi.BSDFFlags.GlossyTransmission))
        return bs, dr.select(good, mi.Color3f(value / pdf), 0)

    def eval(self, ctx, si, wo, active=True):
        return dr.select(active, mi.Color3f(self.scattered(si, wo)[0]), 0)

    def pdf(self, ctx, si, wo, active=True):
        return dr.select(active, self.scattered(si, wo)[1], 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        value, pdf = self.scattered(si, wo)
        return dr.select(active, mi.Color3f(value), 0), dr.select(active, pdf, 0)

    def traverse(self, callback):
        pass

    def to_string(self):
        return 'mirrorball_glass[]'


mi.register_texture('mirrorball_product', Product)
mi.register_texture('mirrorball_second_set', SecondSet)
mi.register_texture('mirrorball_presence', Presence)
mi.register_bsdf('mirrorball_opaque', Opaque)
mi.register_bsdf('mirrorball_glass', Glass)

scene = mi.load_file(os.path.join(os.path.dirname(os.path.abspath(__file__)), '${name}.xml'))
if options.batches == 1 and not options.output.endswith('.npz'):
    mi.Bitmap(mi.render(scene, spp=options.spp, seed=options.seed)).write(options.output)
else:
    import numpy as np

    pictures = [np.array(mi.render(scene, spp=options.spp, seed=options.seed * options.batches + i)) for i in range(options.batches)]
    error = np.std(pictures, axis=0, ddof=1) / len(pictures) ** 0.5 if len(pictures) > 1 else np.full_like(pictures[0], np.inf)
    np.savez(options.output, mean=np.mean(pictures, axis=0).astype(np.float32), se=error.astype(np.float32))
`;
