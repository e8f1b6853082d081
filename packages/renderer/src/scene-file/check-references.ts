/** Whether what things of a scene name is there. */
import type { Sections } from './check-scene.ts';
import { usesIn } from './complete-names.ts';
import type { FaultyPlaces } from './faulty-places.ts';
import { nearest, type Path, type ProblemList, quote } from './problem.ts';

/** Sections whose things are named, and what one of them is called. */
const KINDS = {
  materials: 'material',
  meshes: 'mesh',
  nodes: 'node',
  skins: 'skin',
  images: 'image',
  textures: 'texture',
  shapes: 'shape',
  clips: 'clip',
} as const;
type Section = keyof typeof KINDS;

/**
 * Tells of names that lead nowhere; passes over sections that could not be read. A thing that has another mistake is looked at all the
 * same, as it stands in the file: so everything in it may be missing or be anything.
 */
export class References {
  readonly #scene: Sections;
  readonly #faulty: FaultyPlaces;
  readonly #problems: ProblemList;

  constructor(scene: Sections, faulty: FaultyPlaces, problems: ProblemList) {
    this.#scene = scene;
    this.#faulty = faulty;
    this.#problems = problems;
  }

  /** `path`: where the name stands; `who`: what has it, such as `The shape "ball"`. */
  check(path: Path, who: string, section: Section, wanted: unknown): void {
    const things = this.#scene[section] ?? {};
    if (typeof wanted !== 'string' || this.#faulty.has(section) || Object.hasOwn(things, wanted)) return;
    if (this.#faulty.isAt(path)) return;
    const kind = KINDS[section];
    const names = Object.keys(things);
    const listed = listOfNames(names, `a${kind === 'image' ? 'n' : ''} ${kind}`);
    const meant = nearest(wanted, names);
    const hint = meant === null ? '' : ` Did you mean ${quote(meant)}?`;
    const message = `${who} uses the ${kind} ${quote(wanted)}, which this scene does not have; expected ${listed}.${hint}`;
    this.#problems.add(path, `the name ${quote(wanted)}`, listed, message);
  }

  /** Each thing of a section, as far as it could be read. */
  each(section: keyof Sections, check: (name: string, thing: Readonly<Record<string, unknown>>) => void): void {
    if (this.#faulty.has(section)) return;
    for (const [name, thing] of Object.entries(this.#scene[section] ?? {}))
      if (typeof thing === 'object' && thing !== null) check(name, thing as Readonly<Record<string, unknown>>);
  }
}

/** In words what may stand where one of these names is wanted. */
export function listOfNames(names: readonly string[], one: string): string {
  if (names.length === 0) return `${one}; this scene has none yet`;
  if (names.length === 1) return quote(names[0]!);
  const more = names.length > 8 ? ` and ${names.length - 8} more` : '';
  return `one of ${names.slice(0, 8).map((name) => quote(name)).join(', ')}${more}`; // biome-ignore format: one phrase
}

export function checkReferences(scene: Sections, faulty: FaultyPlaces, problems: ProblemList): void {
  const references = new References(scene, faulty, problems);
  const carried = (path: Path, who: string, thing: { readonly node?: unknown }) =>
    references.check([...path, 'node'], who, 'nodes', thing.node);
  references.each('shapes', (name, shape) => {
    const [path, who] = [['shapes', name], `The shape ${quote(name)}`];
    references.check([...path, 'material'], who, 'materials', shape.material);
    carried(path, who, shape);
    if (shape.type !== 'mesh') return;
    if (shape.material === undefined && !faulty.isAt([...path, 'material'])) {
      const allowed =
        'the name of a material; a mesh that is all of a file has its own, when it stands there once and by no matrix';
      problems.add([...path, 'material'], 'nothing', allowed);
    }
    references.check([...path, 'mesh'], who, 'meshes', shape.mesh);
    references.check([...path, 'skin'], who, 'skins', shape.skin);
  });
  references.each('lights', (name, light) => carried(['lights', name], `The light ${quote(name)}`, light));
  references.each('cameras', (name, camera) => carried(['cameras', name], `The camera ${quote(name)}`, camera));
  references.each('models', (name, model) => carried(['models', name], `The model ${quote(name)}`, model));
  if (!faulty.has('camera')) carried(['camera'], 'The camera', scene.camera);
  references.each('skins', (name, { joints }) => {
    for (const [i, joint] of Array.isArray(joints) ? joints.entries() : [])
      references.check(['skins', name, 'joints', i], `The skin ${quote(name)}`, 'nodes', joint);
  });
  references.each('textures', (name, texture) =>
    references.check(['textures', name, 'image'], `The texture ${quote(name)}`, 'images', texture.image),
  );
  if (!faulty.has('materials'))
    for (const { texture, path } of usesIn(scene.materials))
      references.check(['materials', ...path], `The material ${quote(path[0]!)}`, 'textures', texture);
  references.each('variants', (name, variant) => {
    for (const [shape, material] of Object.entries(variant)) {
      const [path, who] = [['variants', name, shape], `The variant ${quote(name)}`];
      references.check(path, who, 'shapes', shape);
      references.check(path, who, 'materials', material);
    }
  });
}
