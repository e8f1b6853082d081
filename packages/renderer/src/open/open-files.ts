/** Files that came together, by a drop or a choice, or in an archive → the scene that they stand for. */
import type { ReportEntry } from '../gltf/report.ts';
import type { Problem } from '../scene-file/problem.ts';
import { quote, sentence } from '../scene-file/problem.ts';
import { endingOf, FileSet, type GivenFile, nameOf, readGiven } from './file-set.ts';
import { chooseMain } from './main-file.ts';
import { type OpenedModel, type OpenOptions, openModel } from './open-model.ts';
import { readZip, ZipError } from './zip.ts';

/** What was opened, and the name of the file that it was. */
export type OpenedFiles = OpenedModel & { readonly file: string };

const KINDS = 'a .glb or .gltf model, a .ply, .obj or .stl file, a scene.json, or a .zip archive with one of these';

/** Endings of models that other programs read, and can write as glTF. */
const FOREIGN_MODELS = new Set('3dm 3ds 3mf abc blend c4d dae fbx iges igs max mb ma skp step stp usd usda usdc usdz wrl x3d'.split(' ')); // biome-ignore format: one list

/** Rejects with the signal's reason when that is aborted, and never for what files have. */
export async function openFiles(
  given: Iterable<GivenFile>,
  options: Omit<OpenOptions, 'readFile'> = {},
): Promise<OpenedFiles> {
  const all = [...given];
  const archive = chooseMain(all) === null ? all.find(({ path }) => endingOf(path) === 'zip') : undefined;
  if (archive === undefined) return openChosen(all, nameOf(all[0]?.path ?? ''), options);
  const name = nameOf(archive.path);
  let files: GivenFile[];
  try {
    files = readZip(await readGiven(archive));
  } catch (error) {
    if (!(error instanceof ZipError)) return unreadable(name, error);
    return refused(name, `an archive that cannot be opened: ${error.message}`, 'a whole .zip archive', `${quote(name)} cannot be opened: ${sentence(error.message)}`); // biome-ignore format: one sentence
  }
  options.signal?.throwIfAborted();
  return openChosen(files, name, options);
}

/** `name`: of what came, should nothing in it be what can be opened. */
async function openChosen(
  files: readonly GivenFile[],
  name: string,
  options: Omit<OpenOptions, 'readFile'>,
): Promise<OpenedFiles> {
  const chosen = chooseMain(files);
  if (chosen === null) return nothingToOpen(files, name);
  const { main, others } = chosen;
  const file = nameOf(main.path);
  const set = new FileSet(files);
  let bytes: Uint8Array;
  try {
    bytes = await readGiven(main);
  } catch (error) {
    return unreadable(file, error);
  }
  const opened = await openModel(bytes, main.path, {
    ...options,
    readFile: (path) => set.readBeside(main.path, path),
  });
  return { ...(opened.ok ? withOthers(opened, file, others) : opened), file };
}

function nothingToOpen(files: readonly GivenFile[], name: string): OpenedFiles {
  const kinds = `What can be opened is this: ${KINDS}.`;
  const foreign = files.find(({ path }) => FOREIGN_MODELS.has(endingOf(path)));
  if (foreign) {
    const message = `${quote(nameOf(foreign.path))} cannot be opened as it is: export it as glTF (.glb) from the program that it was made with. ${kinds}`;
    return refused(name, `a model of another kind (.${endingOf(foreign.path)})`, KINDS, message);
  }
  const many = files.length === 0 ? 'no file' : `${files.length} files of other kinds`;
  const found = files.length === 1 ? 'a file of another kind' : many;
  const isArchive = endingOf(name) === 'zip';
  const what = files.length === 1 ? `${quote(name)} is` : 'These are';
  return refused(
    name,
    found,
    KINDS,
    `${isArchive || files.length === 0 ? `${quote(name)} has` : what} ${found}. ${kinds}`,
  );
}

/** What could have been opened instead is told. */
function withOthers<Opened extends OpenedModel & { readonly ok: true }>(
  opened: Opened,
  file: string,
  others: readonly GivenFile[],
): Opened {
  if (others.length === 0) return opened;
  const names = others.slice(0, 5).map(({ path }) => quote(nameOf(path))).join(', '); // biome-ignore format: short
  const more = others.length > 5 ? ` and ${others.length - 5} more` : '';
  const message = `Several files could be opened; this is ${quote(file)}. The others are left out: ${names}${more}.`;
  const entry: ReportEntry = { kind: 'unused', what: 'file', message, places: [], count: others.length };
  return { ...opened, report: { ...opened.report, entries: [...opened.report.entries, entry] } };
}

function unreadable(file: string, error: unknown): OpenedFiles {
  const reason = error instanceof Error ? error.message : String(error);
  return refused(file, `a file that cannot be read (${reason})`, 'a file that can be read', `${quote(file)} cannot be read: ${sentence(reason)}`); // biome-ignore format: one sentence
}

function refused(file: string, found: string, allowed: string, message: string): OpenedFiles {
  const problem: Problem = { path: '', found, allowed, message };
  return { ok: false, file, problems: [problem] };
}
