import { isSolid } from '../scene/affine.ts';
import { isClear } from '../scene/layered.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import type { Camera, Light, Material, Matrix4, Scene, Shape, Vec3 } from '../scene/scene.ts';
import { SHAPE_TYPES } from '../scene/shape-types.ts';
import { cameraFault, isDirection, spansPlane } from '../scene/well-formed.ts';
import { checkClips } from './check-clips.ts';
import { checkModels } from './check-models.ts';
import { checkNodes } from './check-nodes.ts';
import { checkReferences } from './check-references.ts';
import type { FaultyPlaces } from './faulty-places.ts';
import { type Path, type ProblemList, quote } from './problem.ts';

/** The parts of a scene that refer to one another, or that tracks point into. */
export type Sections = Omit<Scene, 'version' | 'name' | 'description' | 'animation' | 'render'>;

/** Checks what a scene must keep beyond the form of its parts; passes over parts that are faulty in themselves. */
export function checkScene(scene: Sections, faulty: FaultyPlaces, problems: ProblemList): void {
  if (!faulty.touches('camera')) checkCamera(['camera'], scene.camera, problems);
  for (const [name, camera] of Object.entries(scene.cameras ?? {}))
    if (!faulty.has('cameras', name)) checkCamera(['cameras', name], camera, problems);
  if (!faulty.touches('shapes') && !faulty.touches('lights') && !scene.models) checkNotEmpty(scene, problems);
  const shapes = Object.entries(scene.shapes).filter(([name]) => !faulty.has('shapes', name));
  checkCounts(shapes, problems);
  if (!faulty.touches('lights')) checkLightCount(scene, problems);
  checkReferences(scene, faulty, problems);
  checkNodes(scene, faulty, problems);
  checkClips(scene, faulty, problems);
  checkModels(scene, faulty, problems);
  for (const [name, shape] of shapes) {
    checkForm(name, shape, problems);
    if (shape.type !== 'plane' || faulty.has('materials') || faulty.has('materials', shape.material)) continue;
    const material = Object.hasOwn(scene.materials, shape.material) ? scene.materials[shape.material] : undefined;
    if (material) checkPlaneMaterial(name, shape.material, material, problems);
  }
  for (const [name, light] of Object.entries(scene.lights))
    if (!faulty.has('lights', name)) checkLight(name, light, problems);
}

function checkCamera(path: Path, camera: Camera, problems: ProblemList): void {
  const fault = cameraFault(camera);
  if (fault === 'target') {
    const message = 'The camera looks at the point where it stands; please move "eye" and "target" apart.';
    problems.add([...path, 'target'], 'the place of the eye', 'a point at least 1e-6 metres from "eye"', message);
  }
  if (fault === 'up') {
    const message = 'The camera\'s "up" is zero or lies along its line of sight, so that no side of the picture is up.';
    const allowed = 'a direction across the line from "eye" to "target"';
    problems.add([...path, 'up'], `[${camera.up.join(', ')}]`, allowed, message);
  }
}

function checkNotEmpty({ shapes, lights }: Sections, problems: ProblemList): void {
  if (Object.keys(shapes).length > 0 || Object.values(lights).some((light) => 'visible' in light && light.visible))
    return;
  const message = 'There is nothing to see: a scene needs at least one shape or a visible light.';
  problems.add(['shapes'], 'no shape, and no visible light', 'at least one shape or a visible light', message);
}

function checkCounts(shapes: readonly (readonly [string, Shape])[], problems: ProblemList): void {
  for (const type of SHAPE_TYPES) {
    const count = shapes.filter(([, shape]) => shape.type === type).length;
    const most = SCENE_LIMITS[type];
    if (count > most) problems.add(['shapes'], `${count} shapes of type "${type}"`, `at most ${most} of this type`);
  }
}

function checkLightCount({ lights }: Sections, problems: ProblemList): void {
  const count = Object.values(lights).filter(({ type }) => type === 'sphere' || type === 'quad').length;
  const most = SCENE_LIMITS.surfaceLight;
  if (count > most)
    problems.add(['lights'], `${count} lights of the types "sphere" and "quad"`, `at most ${most} of these types`);
}

function checkForm(name: string, shape: Shape, problems: ProblemList): void {
  if (shape.type === 'plane') checkDirection(['shapes', name, 'normal'], shape.normal, problems);
  if (shape.type === 'quad') checkSides(['shapes', name], `The quad ${quote(name)}`, shape, problems);
  if (shape.type === 'mesh' && shape.matrix) checkMatrix(name, shape.matrix, problems);
}

const LAST_ROW = [0, 0, 0, 1];

function checkMatrix(name: string, matrix: Matrix4, problems: ProblemList): void {
  const path = ['shapes', name, 'matrix'];
  const last = matrix.slice(12);
  if (last.some((x, column) => x !== LAST_ROW[column])) {
    const message = `The last row of the matrix of ${quote(name)} is ${last.join(' ')}, where it must be 0 0 0 1; the matrix is given row by row.`;
    problems.add(path, `the last row ${last.join(' ')}`, 'the last row 0 0 0 1', message);
  } else if (!isSolid(matrix)) {
    const message = `The matrix of ${quote(name)} makes the mesh flat: its first three columns are zero or lie in one plane.`;
    problems.add(path, 'columns that lie in one plane', 'three columns that do not lie in one plane', message);
  }
}

function checkLight(name: string, light: Light, problems: ProblemList): void {
  if ('direction' in light) checkDirection(['lights', name, 'direction'], light.direction, problems);
  if (light.type === 'quad') checkSides(['lights', name], `The quad light ${quote(name)}`, light, problems);
}

function checkDirection(path: Path, direction: Vec3, problems: ProblemList): void {
  if (!isDirection(direction)) problems.add(path, `[${direction.join(', ')}]`, 'a direction of length 1e-6 or more');
}

function checkSides(path: Path, what: string, { u, v }: { u: Vec3; v: Vec3 }, problems: ProblemList): void {
  if (spansPlane(u, v)) return;
  const found = `u = [${u.join(', ')}] and v = [${v.join(', ')}], which span no area`;
  const message = `${what} has no area: its sides "u" and "v" are zero or point the same way.`;
  problems.add([...path, 'v'], found, 'a side that is not along "u", both at least 1e-6 metres long', message);
}

/** Planes have no end, so light from one cannot be sampled, and let nothing through: docs/classic.md, "Where a ray starts". */
function checkPlaneMaterial(plane: string, name: string, material: Material, problems: ProblemList): void {
  const { type, emission } = material;
  const path = ['shapes', plane, 'material'];
  const isGlass = type === 'dielectric';
  if (isGlass || isClear(material)) {
    const message = `The plane ${quote(plane)} is made of ${quote(name)}, which light goes through, but a plane lets nothing through; please use a box or a quad.`;
    problems.add(
      path,
      `the ${isGlass ? 'dielectric' : 'transparent'} material ${quote(name)}`,
      isGlass
        ? 'a material of another type than "dielectric"'
        : 'a material without "transmission" and "diffuseTransmission"',
      message,
    );
  }
  if (emission.some((channel) => channel > 0)) {
    const message = `The plane ${quote(plane)} is made of ${quote(name)}, which shines, but a lamp must have an end; please use a quad.`;
    problems.add(path, `the shining material ${quote(name)}`, 'a material without "emission"', message);
  }
}
