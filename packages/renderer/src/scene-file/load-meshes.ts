/** The meshes of a scene: from the bytes of files to triangles. */
import type { MeshContent, MeshFile } from '../mesh-file/mesh-file.ts';
import { shadedMesh } from '../mesh-file/shaded-mesh.ts';
import { type LoadedMesh, lacksData, type Mesh, type MeshSource } from '../scene/mesh.ts';
import { crowdFault } from '../scene/mesh-fault.ts';
import { listOfNames } from './check-references.ts';
import { nearest, type ProblemList, quote, sentence } from './problem.ts';
import type { ReadFile } from './read-file.ts';
import { meshFileRule } from './shape-schema.ts';

/** Several meshes may be parts of one file, or the same with another shading: it is read once, also when it cannot be had. */
class MeshFiles {
  readonly #readFile: ReadFile;
  readonly #notes: string[];
  readonly #asked = new Map<string, Promise<MeshFile>>();

  constructor(readFile: ReadFile, notes: string[]) {
    this.#readFile = readFile;
    this.#notes = notes;
  }

  read(file: string, asOne: boolean): Promise<MeshFile> {
    const key = `${asOne} ${file}`;
    const asked = this.#asked.get(key) ?? this.#load(file, asOne);
    this.#asked.set(key, asked);
    return asked;
  }

  async #load(file: string, asOne: boolean): Promise<MeshFile> {
    const bytes = await this.#readFile(file);
    const { readMeshFile } = await import('../mesh-file/mesh-file.ts');
    const content = readMeshFile(bytes, file, { asOne });
    if (content.ok) this.#notes.push(...content.notes.map((note) => `The mesh file ${quote(file)}: ${note}`));
    return content;
  }
}

/** The meshes with their content; those that cannot be had are left out, with problems. Adds to `notes` what was changed. */
export async function loadMeshes(
  meshes: Readonly<Record<string, MeshSource>>,
  readFile: ReadFile,
  problems: ProblemList,
  notes: string[],
): Promise<Record<string, MeshSource>> {
  const files = new MeshFiles(readFile, notes);
  const loaded: Record<string, MeshSource> = {};
  for (const [name, source] of Object.entries(meshes)) {
    const data = lacksData(source) ? await loadMesh(name, source, files, problems) : source.data;
    if (data) loaded[name] = { ...source, data: shadedMesh(data, source.shading) };
  }
  const fault = crowdFault(Object.values(loaded) as LoadedMesh[]);
  if (fault !== null) problems.add(['meshes'], fault, 'fewer of them', `The meshes have ${fault}.`);
  return loaded;
}

async function loadMesh(
  name: string,
  source: MeshSource,
  files: MeshFiles,
  problems: ProblemList,
): Promise<Mesh | null> {
  const { file = '', part } = source;
  const refuse = (reason: string, message: string) =>
    problems.add(['meshes', name, 'file'], `the file ${quote(file)}, which cannot be used (${reason})`, meshFileRule, message); // biome-ignore format: one sentence
  try {
    const content = await files.read(file, part === undefined);
    if (content.ok) return partOf(content, name, source, problems);
    for (const { line, byte, found, message } of content.problems) {
      const place = line !== undefined ? `line ${line}: ` : byte !== undefined ? `byte ${byte}: ` : '';
      refuse(`${place}${found}`, `The mesh ${quote(name)} cannot be used. ${message}`);
    }
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    refuse(
      reason.replace(/\.$/, ''),
      `The mesh ${quote(name)} cannot be read from ${quote(file)}: ${sentence(reason)}`,
    );
  }
  return null;
}

/** Null, and a problem, when the file has none of that name. */
function partOf({ parts }: MeshContent, name: string, { file, part }: MeshSource, problems: ProblemList): Mesh | null {
  const found = part === undefined ? parts[0] : parts.find((one) => one.name === part);
  if (found) return found.mesh;
  const names = parts.map((one) => one.name).filter((one) => one !== '');
  const listed = names.length === 0 ? 'no "part", as the file has none' : listOfNames(names, '');
  const meant = nearest(part!, names);
  const hint = meant === null ? '' : ` Did you mean ${quote(meant)}?`;
  const message = `The mesh ${quote(name)} is the part ${quote(part!)} of ${quote(file!)}, which has no such part; expected ${listed}.${hint}`;
  problems.add(['meshes', name, 'part'], `the name ${quote(part!)}`, listed, message);
  return null;
}
