import type * as Files from './written.ts';

export const loadWritten = (): Promise<typeof Files> => import('./written.ts');
