/** Lights of KHR_lights_punctual, and cameras: things that look along −Z of their nodes. */
import { wholeCamera } from '../../scene/camera.ts';
import type { Camera, DirectionalLight, PointLight, SpotLight, Vec3 } from '../../scene/scene.ts';
import { subtract } from '../../scene/vec3.ts';
import type { ExportReport } from '../export-report.ts';
import type { GltfFile, Json } from './gltf-file.ts';
import { across, isIdentity, lookingAlong, type NodeWriter } from './nodes.ts';

const LIGHTS = 'KHR_lights_punctual';
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Writes a thing on its node, or on a new one where it stands elsewhere. */
function place(
  nodes: NodeWriter,
  node: string | undefined,
  name: string,
  matrix: readonly number[],
  kind: string,
): Json {
  return isIdentity(matrix) && node !== undefined ? nodes.carrier(node, kind, name) : nodes.child(node, name, matrix);
}

/** Lights in the list that the extension has in the root of the file. */
export class LightWriter {
  readonly list: Json[] = [];
  /** Place in the list, by name. */
  readonly places = new Map<string, number>();
  readonly #file: GltfFile;
  readonly #nodes: NodeWriter;
  readonly #report: ExportReport;

  constructor(file: GltfFile, nodes: NodeWriter, report: ExportReport) {
    this.#file = file;
    this.#nodes = nodes;
    this.#report = report;
  }

  write(name: string, light: PointLight | SpotLight | DirectionalLight): void {
    const thing = `light "${name}"`;
    const json: Json = { name, type: light.type };
    const direction: Vec3 = light.type === 'point' ? [0, 0, -1] : light.direction;
    const position: Vec3 = light.type === 'directional' ? [0, 0, 0] : light.position;
    json.intensity = light.type === 'directional' ? light.irradiance : light.intensity;
    // The format has colours up to 1.
    const most = Math.max(1, ...light.color);
    if (most > 1) json.intensity *= most;
    json.color = light.color.map((x) => x / most);
    if (light.type === 'spot')
      json.spot = { innerConeAngle: radians(light.innerAngle), outerConeAngle: radians(light.outerAngle) };
    if (light.type === 'directional' && light.angle > 0)
      this.#report.add('lost', 'Light of glTF comes from one direction: a sun has no disc.', thing);
    this.places.set(name, this.list.push(json) - 1);
    const matrix = lookingAlong(position, direction, across(direction));
    const upright = direction[0] === 0 && direction[1] === 0 && direction[2] < 0 && position.every((x) => x === 0);
    const node = upright && light.node !== undefined ? this.#free(light.node, name) : place(this.#nodes, light.node, name, matrix, '-'); // biome-ignore format: one choice
    this.#file.extend(node, LIGHTS).light = this.places.get(name);
  }

  /** A node carries one light. */
  #free(node: string, name: string): Json {
    const own = this.#nodes.json(this.#nodes.place(node));
    return own.extensions?.[LIGHTS] === undefined ? own : this.#nodes.child(node, name);
  }
}

export function writeCamera(
  file: GltfFile,
  nodes: NodeWriter,
  name: string,
  given: Camera,
  report: ExportReport,
): number | null {
  const { eye, target, up, node, projection, verticalFov, viewHeight, aperture } = { ...wholeCamera(given) };
  const thing = `camera "${name}"`;
  if (projection === 'equirectangular') {
    report.add('lost', 'glTF has no equirectangular camera.', thing);
    return null;
  }
  if (aperture > 0) report.add('lost', 'Cameras of glTF have no lens: everything is sharp.', thing);
  const half = viewHeight / 2;
  const place = file.add(
    'cameras',
    projection === 'perspective'
      ? { name, type: 'perspective', perspective: { yfov: radians(verticalFov), znear: 1e-3 } }
      : { name, type: 'orthographic', orthographic: { xmag: half, ymag: half, znear: 0, zfar: 1e6 } },
  );
  const matrix = lookingAlong(eye, subtract(target, eye), up);
  const carrier = isIdentity(matrix) && node !== undefined ? nodes.carrier(node, 'camera', name) : nodes.child(node, name, matrix); // biome-ignore format: one choice
  carrier.camera = place;
  return place;
}
