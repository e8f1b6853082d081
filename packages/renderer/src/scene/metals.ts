import type { Color } from './scene.ts';

/**
 * Complex indices of refraction of pure metals, measured spectra averaged for red, green and blue: the values that RGB renderers
 * such as Mitsuba and appleseed share. Measured by Johnson and Christy 1972 and 1974; aluminium by Rakić 1995.
 */
export const METALS = {
  aluminium: { eta: [1.3456, 0.9654, 0.6172], k: [7.4746, 6.3995, 5.3031] },
  chromium: { eta: [3.1071, 3.1812, 2.323], k: [3.3314, 3.3291, 3.135] },
  copper: { eta: [0.2004, 0.924, 1.1022], k: [3.9129, 2.4528, 2.1421] },
  gold: { eta: [0.1431, 0.3749, 1.4424], k: [3.9831, 2.3857, 1.6032] },
  iron: { eta: [2.9114, 2.9497, 2.5845], k: [3.0893, 2.9318, 2.767] },
  silver: { eta: [0.1552, 0.1167, 0.1383], k: [4.8283, 3.1222, 2.147] },
} as const satisfies Record<string, { eta: Color; k: Color }>;
