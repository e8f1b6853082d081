import type * as SceneTools from './scene-tools.ts';

/** They come when they are first asked for, and stay. */
export const loadSceneTools = (): Promise<typeof SceneTools> => import('./scene-tools.ts');
