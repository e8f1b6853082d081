/** The models of this session, to go back to: not what was made of them, only which files they were. The browser reads those again. */
import { signal } from '@preact/signals';
import type { PathFile } from './job.ts';

export interface OpenedModel {
  readonly key: number;
  readonly name: string;
  readonly files: readonly PathFile[];
}

/** The last ones, in the order in which they came first. */
export const openedModels = signal<readonly OpenedModel[]>([]);

const MOST = 6;
let keys = 0;

const isSame = (a: readonly PathFile[], b: readonly PathFile[]): boolean =>
  a.length === b.length &&
  a.every(({ path, file }, i) => {
    const other = b[i]!;
    return path === other.path && file.size === other.file.size && file.lastModified === other.file.lastModified;
  });

/** The one of these files, or a new one, which is listed once it is remembered. */
export function modelOf(name: string, files: readonly PathFile[]): OpenedModel {
  const known = openedModels.peek().find((model) => isSame(model.files, files));
  return { key: known?.key ?? ++keys, name, files };
}

export function rememberModel(model: OpenedModel): void {
  const now = openedModels.peek();
  const isKnown = now.some(({ key }) => key === model.key);
  openedModels.value = isKnown ? now.map((one) => (one.key === model.key ? model : one)) : [...now, model].slice(-MOST);
}
