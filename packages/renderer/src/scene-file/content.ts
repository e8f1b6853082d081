/**
 * Content that no text can hold, the sky's map and the triangles of meshes: taken out of a scene that a program made while its form is
 * checked, and put back.
 */
import { shadedMesh } from '../mesh-file/shaded-mesh.ts';
import { type EnvironmentMap, environmentFault } from '../scene/environment.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import type { LoadedMesh, MeshSource } from '../scene/mesh.ts';
import { crowdFault, meshFault } from '../scene/mesh-fault.ts';
import type { Scene, Sky } from '../scene/scene.ts';
import type { ImageSource } from '../scene/textures.ts';
import { withMap, withMeshes, withThings } from './trusted-scenes.ts';

/** Any names will do while the form of the scene is checked. */
const NO_IMAGE = 'memory.hdr';
const NO_MESH = 'memory.ply';
const NO_PICTURE = 'memory.png';

type Thing = Readonly<Record<string, unknown>>;
const isThing = (value: unknown): value is Thing =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** What `parseScene` reads: without content, and with names of files for what has content and none. */
export function asInText(given: unknown): unknown {
  if (!isThing(given)) return given;
  const { sky, meshes, images, models } = given;
  return {
    ...given,
    ...(isThing(sky) ? { sky: withoutContent(sky, 'map', 'image', NO_IMAGE) } : {}),
    ...(isThing(images) ? { images: mapValues(images, (i) => withoutContent(i, 'data', 'file', NO_PICTURE)) } : {}),
    ...(isThing(models) ? { models: withoutLoaded(models) } : {}),
    ...(isThing(meshes) ? { meshes: mapValues(meshes, (m) => withoutContent(m, 'data', 'file', NO_MESH)) } : {}),
  };
}

/** What has been loaded is among the scene's things, which are read as its own. */
function withoutLoaded(models: Thing): Thing | undefined {
  const rest = Object.entries(models).filter(([, model]) => !isThing(model) || model.things === undefined);
  return rest.length > 0 ? Object.fromEntries(rest) : undefined;
}

function withoutContent(thing: unknown, content: string, file: string, instead: string): unknown {
  if (!isThing(thing) || thing[content] === undefined) return thing;
  const { [content]: _, ...others } = thing;
  return { ...others, [file]: thing[file] ?? instead };
}

const mapValues = <From, To>(things: Readonly<Record<string, From>>, change: (thing: From, name: string) => To) =>
  Object.fromEntries(Object.entries(things).map(([name, thing]) => [name, change(thing, name)] as const));

/**
 * The scene that `parseScene` made of `asInText(given)`, with the content of `given`. Throws a TypeError when that is none that can be
 * used.
 */
export function withContent(scene: Scene, given: Scene): Scene {
  // One colour is a list, which has a `map` of its own.
  const hasMap = isThing(given.sky) && given.sky.map !== undefined;
  const mapped = hasMap ? attachMap(scene, given.sky) : scene;
  const drawn = hasContent(given.images)
    ? withThings(mapped, { images: imagesOf(mapped.images!, given.images!) }, true)
    : mapped;
  return hasContent(given.meshes) ? withMeshes(drawn, meshesOf(drawn.meshes ?? {}, given.meshes!), true) : drawn;
}

const hasContent = (things: Readonly<Record<string, { readonly data?: unknown }>> = {}): boolean =>
  Object.values(things).some(({ data }) => data !== undefined);

function imagesOf(read: Meshes<ImageSource>, given: Meshes<ImageSource>): Meshes<ImageSource> {
  return mapValues(read, (image, name): ImageSource => {
    const { data, file } = given[name] ?? {};
    if (data === undefined) return image;
    const { width, height, rgba } = data;
    const isSide = (side: number) => Number.isInteger(side) && side >= 1 && side <= SCENE_LIMITS.imageSide;
    if (!isSide(width) || !isSide(height) || rgba?.length !== width * height * 4)
      throw new TypeError(
        `This is no scene.\n/images/${name}/data: the image has ${rgba?.length} bytes for ${width} × ${height} pixels.`,
      );
    return file === undefined ? { data } : { file, data };
  });
}

function attachMap(scene: Scene, { map, image }: Sky): Scene {
  const fault = isThing(map) ? environmentFault(map as unknown as EnvironmentMap) : 'no content';
  if (fault !== null) throw new TypeError(`This is no scene.\n/sky/map: the map has ${fault}.`);
  const { image: _, ...others } = scene.sky;
  const sky = image === undefined ? others : { ...others, image };
  return withMap({ ...scene, sky }, map!, true);
}

type Meshes<Source> = Readonly<Record<string, Source>>;

/** The meshes as they were read, with the content that was given, shaded as they say. */
function meshesOf(read: Meshes<MeshSource>, given: Meshes<MeshSource>): Meshes<MeshSource> {
  const meshes = mapValues(read, ({ file, ...mesh }, name): MeshSource => {
    const { data, file: givenFile } = given[name]!;
    if (data === undefined) return { ...mesh, file };
    const fault = meshFault(data);
    if (fault !== null) throw new TypeError(`This is no scene.\n/meshes/${name}/data: the mesh has ${fault}.`);
    const named = givenFile === undefined ? mesh : { ...mesh, file };
    return { ...named, data: shadedMesh(data, mesh.shading) };
  });
  const crowd = crowdFault(Object.values(meshes).filter((mesh): mesh is LoadedMesh => mesh.data !== undefined));
  if (crowd !== null) throw new TypeError(`This is no scene.\n/meshes: the meshes have ${crowd}.`);
  return meshes;
}
