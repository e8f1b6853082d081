import type * as Files from './write-in-worker.ts';

export const loadWritten = (): Promise<typeof Files> => import('./write-in-worker.ts');
