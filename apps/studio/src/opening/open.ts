/** Opening what a person gives: files become the scene on show, pictures of all around its light. */
import { adoptScene, isSkyName, type Problem, type ReportEntry } from 'mirrorball';
import { refusedFile, show } from '../actions.ts';
import { takeSkyFile } from '../environment.ts';
import { readyToReport } from '../i18n.ts';
import { dismiss, notify, reasonOf } from '../notices.ts';
import { integrator } from '../state.ts';
import { TooManyFiles, UnreadableFolder } from './given-files.ts';
import type { Opened, OpenedEnvironment, PathFile, Phase } from './job.ts';
import { openInWorker, openSkyInWorker } from './open-in-worker.ts';
import { modelOf, rememberModel } from './opened-models.ts';
import { beginOpening, endOpening, opening } from './under-way.ts';

/** Opens what comes, once it is known; when it is broken, says all that is wrong and leaves the scene as it is. */
export async function openFiles(coming: Promise<readonly PathFile[]> | readonly PathFile[]): Promise<void> {
  const mine = beginOpening();
  dismiss('file');
  let name = '';
  try {
    const files = await coming;
    mine.signal.throwIfAborted();
    if (files.length === 0) return;
    name = nameOf(files);
    const words = readyToReport();
    opening.value = { name, phase: 'reading', share: 0 };
    if (files.every(({ path }) => isSkyName(path))) await openSky(files[0]!.file, words, mine.signal);
    else if (await openModel(files, words, mine.signal)) await openSkyBeside(files, words, mine.signal);
  } catch (error) {
    if (mine.signal.aborted) return;
    if (error instanceof TooManyFiles) notify('file', (t) => t.tooManyFiles);
    else if (error instanceof UnreadableFolder) notify('file', (t) => t.folderUnreadable);
    else notify('file', (t) => t.fileUnreadable(name, reasonOf(error)));
  } finally {
    endOpening(mine);
  }
}

/** Of files that come together the model's, not that of its numbers or textures. */
const IS_MODEL = /\.(json|gl(b|tf)|obj|ply|stl|zip)$/i;

/** The file's, or that of the folder in which all of them lie. */
function nameOf(files: readonly PathFile[]): string {
  const first = files.find(({ path }) => IS_MODEL.test(path)) ?? files[0]!;
  const folder = first.path.split('/')[0]!;
  return files.length > 1 && files.every(({ path }) => path.startsWith(`${folder}/`)) ? folder : first.file.name;
}

const tell = (phase: Phase, share: number): void => {
  const now = opening.peek();
  if (now) opening.value = { ...now, phase, share };
};

/** Whether it is on show. */
async function openModel(files: readonly PathFile[], words: Promise<void>, signal: AbortSignal): Promise<boolean> {
  const opened: Opened = await openInWorker(files, tell, signal);
  await words;
  if (!opened.ok) {
    refuse(opened.file, opened.problems);
    return false;
  }
  const { file, report, bytes } = opened;
  const scene = await adoptScene(opened.prepared);
  signal.throwIfAborted();
  try {
    const model = modelOf(scene.name || file, files);
    await show({ id: 'file', scene, original: scene, fileName: file, opened: model.key, report, bytes });
    rememberModel(model);
    return true;
  } catch (error) {
    // The scene is good; what draws it cannot.
    const message = reasonOf(error);
    refuse(file, [{ path: '', found: 'what cannot be drawn here', allowed: 'what can be', message }]);
    return false;
  }
}

/** A scene file names its own light. A model cannot, so one picture of all around that came with it is meant to be it. */
async function openSkyBeside(files: readonly PathFile[], words: Promise<void>, signal: AbortSignal): Promise<void> {
  const skies = files.filter(({ path }) => isSkyName(path));
  if (skies.length === 1 && !files.some(({ path }) => /\.json$/i.test(path)))
    await openSky(skies[0]!.file, words, signal);
}

async function openSky(file: File, words: Promise<void>, signal: AbortSignal): Promise<void> {
  const opened: OpenedEnvironment = await openSkyInWorker(file, tell, signal);
  await words;
  if (!opened.ok) return refuse(opened.file, opened.problems);
  takeSkyFile(opened.file, opened.map);
  const waits = integrator.peek() !== 'path';
  const notes = opened.notes.map((message): ReportEntry => ({ kind: 'changed', what: opened.file, message, places: [], count: 1 })); // biome-ignore format: one entry
  if (waits || notes.length > 0)
    notify('file', (t) => [...notes.map(t.reportEntry), ...(waits ? [t.skyWaits] : [])].join('\n'));
}

function refuse(name: string, problems: readonly Problem[]): void {
  refusedFile.value = { name, problems };
}
