import { batch } from '@preact/signals';
import type { Renderer, Scene } from 'mirrorball';
import { takeScene, tellCannotCompare } from './actions.ts';
import { mountApp } from './app.tsx';
import { builtInScene, sceneIds } from './built-in-scenes.ts';
import { followScene } from './environment.ts';
import { dictionary, startLanguage } from './i18n.ts';
import { notify, reasonOf } from './notices.ts';
import { followModel } from './opening/lost-model.ts';
import { followPointers } from './pointer-gestures.ts';
import { drawnImageSamples, followRenderer, followState, openSession } from './session.ts';
import { followKeys } from './shortcuts.ts';
import { followStageSize } from './stage.ts';
import * as state from './state.ts';
import { followTheme, prefersReducedMotion } from './theme.ts';
import { readParameters, type UrlParameters } from './url-parameters.ts';

declare global {
  interface Window {
    /** For the console: `mirrorball.renderer` is what draws at this moment. */
    mirrorball: { readonly renderer: Renderer | null };
    /** For benchmarks: samples drawn so far for each pixel of the canvas. */
    benchSamples: () => number;
  }
}

/** The first picture comes first: the scene is under way before the controls are built. */
function start(): void {
  const parameters = readParameters(location.search, sceneIds);
  startLanguage(parameters.lang);
  followTheme();
  followStageSize(parameters.size);
  takeScene(throughLens(builtInScene(parameters.scene), parameters));
  takeParameters(parameters);

  const session = openSession(parameters.backend);
  window.mirrorball = {
    get renderer() {
      return state.renderer.peek();
    },
  };
  window.benchSamples = drawnImageSamples;

  followState();
  followRenderer();
  followScene();
  followModel();
  followKeys();
  followPointers(document.getElementById('stage')!);
  if (parameters.ui) mountAfter(session);
  session.catch((error: unknown) => {
    const reason = reasonOf(error);
    document.getElementById('loading')?.replaceChildren(parameters.ui ? '' : dictionary.peek().noticeNothing(reason));
    notify('error', (t) => t.noticeNothing(reason));
  });
}

/** The lens becomes the scene's own, so that it stays when the view is moved and taken back. */
function throughLens(shown: { readonly id: string; readonly scene: Scene }, given: UrlParameters): state.Shown {
  const { aperture, focus } = given;
  if (aperture === null && focus === null) return { ...shown, original: shown.scene };
  const lens = { ...(aperture !== null && { aperture }), ...(focus !== null && { focusDistance: focus }) };
  const scene = { ...shown.scene, camera: { ...shown.scene.camera, ...lens } };
  return { ...shown, scene, original: scene };
}

/** On a page this low, such as a phone on its side, the panel would hide too much: it starts folded. */
const LOW_PAGE = 480;

function takeParameters(given: UrlParameters): void {
  batch(() => {
    state.reflections.value = given.reflections ?? state.reflections.value;
    state.lightSamples.value = given.samples ?? state.lightSamples.value;
    state.exposure.value = given.exposure ?? state.exposure.value;
    state.integrator.value = given.integrator ?? state.integrator.value;
    state.shownView.value = given.view ?? state.shownView.value;
    state.maxDepth.value = given.depth ?? state.maxDepth.value;
    state.toneMapping.value = given.tone ?? state.toneMapping.value;
    state.resolutionScale.value = given.scale ?? state.resolutionScale.value;
    state.adaptive.value = given.adaptive ?? state.adaptive.value;
    state.seed.value = given.seed ?? state.seed.value;
    state.comparisonMode.value = given.compare ?? state.comparisonMode.value;
    state.time.value = given.time ?? 0;
    state.playing.value = !(given.paused ?? prefersReducedMotion());
    state.controlsShown.value = given.ui;
    state.panelOpen.value = given.ui && !state.isPhone.value && innerHeight > LOW_PAGE;
  });
  if (given.compare && given.compare !== 'off') tellCannotCompare();
  const { problems, unknown } = given;
  if (problems.length + unknown.length === 0) return;
  notify('parameters', (t) => {
    const refused = problems.length > 0 ? [t.noticeParameters(problems.join('; '))] : [];
    const strangers = unknown.length > 0 ? [t.noticeUnknownParameters(unknown.join('; '))] : [];
    return [...refused, ...strangers].join('\n');
  });
}

/** Builds the controls once the first frame is asked for, or when that takes long. */
function mountAfter(session: Promise<Renderer>): void {
  const late = new Promise((resolve) => setTimeout(resolve, 400));
  const mount = (): void => mountApp(document.getElementById('ui')!);
  Promise.race([session, late]).then(mount, mount);
}

start();
