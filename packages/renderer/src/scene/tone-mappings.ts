import type { ToneMapping } from './scene.ts';

/** All ways of tone mapping; the position of each is its number in the display's shader, tone_map.wesl. */
export const TONE_MAPPINGS = ['none', 'aces', 'agx', 'neutral'] as const satisfies readonly ToneMapping[];
