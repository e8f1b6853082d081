import { computed, signal } from '@preact/signals';
import type {
  Backend,
  FrameStats,
  ImportReport,
  Integrator,
  Renderer,
  RendererSettings,
  Scene,
  ToneMapping,
  ViewName,
} from 'mirrorball';
import { type ComparisonMode, comparisonFor, type Dividers, evenDividers, fitDividers } from './comparison.ts';
import { framingFor } from './framing.ts';

/** Everything the page knows. Components read it; `actions.ts` and its neighbours write it. */

/** What draws; null until the first one is ready. */
export const renderer = signal<Renderer | null>(null);
/** Whether what draws makes one picture, and does not play. */
export const isStill = computed(() => renderer.value?.backend === 'cpu');
export interface Shown {
  /** A built-in scene's, or 'file'. */
  readonly id: string;
  readonly scene: Scene;
  /** As it was opened, before anything of it was chosen otherwise. */
  readonly original: Scene;
  readonly fileName?: string;
  /** Of a file: its key among `openedModels`. */
  readonly opened?: number;
  /** Of a file: what was not taken as it stands, and how much there is. */
  readonly report?: ImportReport;
  /** Of a file: what its meshes, trees and pictures take. */
  readonly bytes?: number;
}
/** The scene on show. */
export const shown = signal<Shown | null>(null);
/** Whether it has meshes, which only paths find on a GPU. */
export const hasTriangles = computed(() =>
  Object.values(shown.value?.scene.shapes ?? {}).some(({ type }) => type === 'mesh'),
);
/** Whether time changes anything in it. */
export const moves = computed(() => {
  const scene = shown.value?.scene;
  return scene === undefined || scene.animation.length > 0 || scene.clip !== undefined;
});
/** Whether the view is the person's own and no longer the scene's. */
export const viewMoved = signal(false);
/** The backend being started to take over, if any. */
export const switchingTo = signal<Backend | null>(null);
/** Figures of the last frame, taken four times a second. */
export const stats = signal<FrameStats | null>(null);

/** Whether what draws waits for its program, and a sketch or the picture before stands in. Taken with the figures. */
export const compiling = signal(false);

/** The lens of the camera in use, and where it is sharp; taken with the figures. */
export const lens = signal({ aperture: 0, focus: 0, panorama: false });

// Settings of the renderer
export const reflections = signal(10);
export const lightSamples = signal(9);
export const exposure = signal(0);
export const toneMapping = signal<ToneMapping>('none');
export const integrator = signal<Integrator>('classic');
/** The picture, or what is known of each pixel; a CPU still is always the picture. */
export const shownView = signal<ViewName>('picture');
/** Segments of a path; −1: no limit. */
export const maxDepth = signal(-1);
export const resolutionScale = signal(1);
export const adaptive = signal(true);
export const targetFps = signal<30 | 60>(60);
export const seed = signal(0);
export const comparisonMode = signal<ComparisonMode>('off');
/** Where the person put the dividers; null: evenly over what can be seen. */
export const chosenDividers = signal<Dividers | null>(null);

// Motion
export const playing = signal(true);
export const speed = signal(1);
export const time = signal(0);

// The page
export const panelOpen = signal(true);
export const helpOpen = signal(false);
export const pageWidth = signal(0);
export const pageHeight = signal(0);
export const stageWidth = signal(0);
export const stageHeight = signal(0);
/** False: nothing but the picture. */
export const controlsShown = signal(true);
/** What the sheet at the bottom of a phone takes of the page's height; at first, what its head takes. */
export const sheetHeight = signal(60);
export const dragOver = signal(false);

/** At most this wide, the panel is a sheet at the bottom. The same number stands in styles/panel.css. */
export const PHONE_WIDTH = 640;
/** What the open panel takes of the stage's width, its margins included. */
const PANEL_WIDTH = 320;
/** What the figures at the top of a phone take. */
const PHONE_STATUS_HEIGHT = 54;

export const isPhone = computed(() => pageWidth.value <= PHONE_WIDTH);

/** Share of the stage's width, from the left, that lies left of `pixels` at the page's right edge. */
const shareLeftOf = (pixels: number): number => Math.min((pageWidth.value - pixels) / Math.max(stageWidth.value, 1), 1);

/** What no panel covers of the picture's width. */
export const visibleShare = computed(() => shareLeftOf(isPhone.value || !panelOpen.value ? 0 : PANEL_WIDTH));
/** As far as texts at the top may reach: clear of the panel, or of the button that is left of it. */
export const textShare = computed(() => (isPhone.value || panelOpen.value ? visibleShare.value : shareLeftOf(68)));
export const dividers = computed<Dividers>(() =>
  chosenDividers.value ? fitDividers(chosenDividers.value, visibleShare.value) : evenDividers(visibleShare.value),
);

/** What controls cover along the stage's edges. */
const room = computed(() => {
  const [width, height] = [stageWidth.value, stageHeight.value];
  const sheet = controlsShown.value && isPhone.value;
  const top = sheet ? PHONE_STATUS_HEIGHT : 0;
  const bottom = sheet ? Math.max(sheetHeight.value - (pageHeight.value - height), 0) : 0;
  return { width, height, top, right: width * (1 - visibleShare.value), bottom };
});

/** The picture's middle is where it can be seen, and nothing that matters is cropped. */
const framing = computed(() => framingFor(room.value));

/** Shares of the picture's width and height, from its left and top, that no panel covers. */
export const openShares = computed(() => {
  const { width, height, right, bottom } = room.value;
  return [1 - right / Math.max(width, 1), 1 - bottom / Math.max(height, 1)] as const;
});

/** Why nothing can be compared now, by the text that says so: only pictures can be, by what the classic integrator knows. */
export const cannotCompare = computed<'compareClassic' | 'comparePicture' | null>(() => {
  if (integrator.value !== 'classic') return 'compareClassic';
  return shownView.value === 'picture' || isStill.value ? null : 'comparePicture';
});
/** What is compared now. */
export const comparing = computed<ComparisonMode>(() => (cannotCompare.value ? 'off' : comparisonMode.value));

/** What the renderer is to be set to. */
export const wantedSettings = computed<Omit<RendererSettings, 'maxSamples' | 'pixelFilter' | 'independentSamples'>>(
  () => ({
    integrator: integrator.value,
    view: shownView.value,
    maxDepth: maxDepth.value,
    maxReflections: reflections.value,
    lightSamples: lightSamples.value,
    exposure: exposure.value,
    toneMapping: toneMapping.value,
    resolutionScale: resolutionScale.value,
    adaptive: adaptive.value,
    targetFps: targetFps.value,
    seed: seed.value,
    comparison: comparisonFor(
      comparing.value,
      { maxReflections: reflections.value, lightSamples: lightSamples.value },
      dividers.value,
    ),
    framing: framing.value,
  }),
);
