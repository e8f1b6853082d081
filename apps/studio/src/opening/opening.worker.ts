/** Opens files away from the page, which stays alive. It takes one job after the other; ending one is `terminate()`. */
import { buffersOf, type GivenFile, type GltfProgress, openEnvironment, openFiles, prepareScene } from 'mirrorball';
import type { OpeningJob, OpeningMessage, PathFile, Phase } from './job.ts';

const PHASE_OF: Readonly<Record<GltfProgress['step'], Phase>> = {
  files: 'reading',
  numbers: 'geometry',
  meshes: 'geometry',
  images: 'images',
};

const post = (message: OpeningMessage, transfer: Transferable[] = []) => self.postMessage(message, { transfer });

const given = ({ path, file }: PathFile): GivenFile => ({
  path,
  size: file.size,
  read: async () => new Uint8Array(await file.arrayBuffer()),
});

async function openModel(files: readonly PathFile[]): Promise<void> {
  const opened = await openFiles(files.map(given), {
    camera: 'frame',
    onProgress: ({ step, done, total }) => post({ phase: PHASE_OF[step], share: total > 0 ? done / total : 0 }),
  });
  if (!opened.ok) return post({ opened });
  post({ phase: 'trees', share: 0 });
  const prepared = await prepareScene(opened.scene, (share) => post({ phase: 'trees', share }));
  const { file, report } = opened;
  const buffers = buffersOf(prepared);
  const bytes = buffers.reduce((sum, { byteLength }) => sum + byteLength, 0);
  post({ opened: { ok: true, file, prepared, report, bytes } }, buffers);
}

async function openSky(file: File): Promise<void> {
  const environment = { ...(await openEnvironment(given({ path: file.name, file }))), file: file.name };
  post({ environment }, environment.ok ? buffersOf(environment.map) : []);
}

self.onmessage = ({ data }: MessageEvent<OpeningJob>) => {
  post({ phase: 'reading', share: 0 });
  const work = data.kind === 'model' ? openModel(data.files) : openSky(data.file);
  work.catch((error: unknown) => post({ failed: error instanceof Error ? error.message : String(error) }));
};
