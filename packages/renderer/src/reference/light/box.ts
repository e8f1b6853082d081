/** Glowing boxes: uniform on the area of the faces that the point sees; from inside they fill all directions. */
import type { Vec3 } from '../../scene/scene.ts';
import { addScaled, dot, length, negate, scale, subtract } from '../../scene/vec3.ts';
import { coneDirection, wholeSphere } from './cone.ts';
import type { BoxEmitter, LightSample, Meeting, Square } from './emitter.ts';

interface Face {
  /** Unit, outwards. */
  readonly normal: Vec3;
  readonly center: Vec3;
  /** Half the sides. */
  readonly s: Vec3;
  readonly t: Vec3;
  readonly area: number;
}

function facesOf({ center, halfSize, axes }: BoxEmitter): Face[] {
  return [0, 1, 2].flatMap((k) => {
    const [a, b] = [(k + 1) % 3, (k + 2) % 3];
    const [s, t] = [scale(axes[a]!, halfSize[a]!), scale(axes[b]!, halfSize[b]!)];
    const area = 4 * halfSize[a]! * halfSize[b]!;
    return [axes[k]!, negate(axes[k]!)].map((normal) => {
      return { normal, center: addScaled(center, normal, halfSize[k]!), s, t, area };
    });
  });
}

const facesSeen = (e: BoxEmitter, point: Vec3): Face[] =>
  facesOf(e).filter(({ normal, center }) => dot(normal, subtract(point, center)) > 0);

const areaOf = (faces: readonly Face[]) => faces.reduce((sum, { area }) => sum + area, 0);

export function metBox(e: BoxEmitter, origin: Vec3, direction: Vec3): Meeting | null {
  let met: Meeting | null = null;
  const seen = facesSeen(e, origin);
  for (const { normal, center, s, t } of seen.length > 0 ? seen : facesOf(e)) {
    const distance = dot(subtract(center, origin), normal) / dot(direction, normal);
    if (!(distance > 0) || !Number.isFinite(distance)) continue;
    const onFace = subtract(addScaled(origin, direction, distance), center);
    if (Math.abs(dot(onFace, s)) > dot(s, s) || Math.abs(dot(onFace, t)) > dot(t, t)) continue;
    if (met === null || distance < met.distance) met = { distance, normal };
  }
  return met;
}

export function boxPdf(e: BoxEmitter, point: Vec3, direction: Vec3, { distance, normal }: Meeting): number {
  const seen = facesSeen(e, point);
  if (seen.length === 0) return 1 / (4 * Math.PI);
  return distance ** 2 / (areaOf(seen) * Math.abs(dot(direction, normal)));
}

export function sampleBox(e: BoxEmitter, point: Vec3, u: Square): LightSample {
  const faces = facesSeen(e, point);
  return {
    ...(faces.length === 0 ? fromInside(e, point, u) : onFaces(faces, point, u)),
    radiance: e.radiance,
    delta: false,
  };
}

type Ray = Pick<LightSample, 'direction' | 'distance' | 'pdf'>;

function fromInside(e: BoxEmitter, point: Vec3, u: Square): Ray {
  const { direction, pdf } = coneDirection(wholeSphere, u);
  return { direction, pdf, distance: metBox(e, point, direction)?.distance ?? 0 };
}

function onFaces(faces: readonly Face[], point: Vec3, [u1, u2]: Square): Ray {
  let rest = u1 * areaOf(faces);
  const face = faces.find(({ area }) => (rest -= area) < 0) ?? faces.at(-1)!;
  const within = Math.min(Math.max(1 + rest / face.area, 0), 1);
  const onFace = addScaled(addScaled(face.center, face.s, 2 * within - 1), face.t, 2 * u2 - 1);
  const toLight = subtract(onFace, point);
  const distance = length(toLight);
  const direction = scale(toLight, 1 / distance);
  const pdf = distance ** 2 / (areaOf(faces) * Math.abs(dot(direction, face.normal)));
  return { direction, distance, pdf };
}
