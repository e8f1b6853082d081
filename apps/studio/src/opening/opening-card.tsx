import { Button } from '../controls/button.tsx';
import { dictionary } from '../i18n.ts';
import { compiling, hasTriangles, renderer } from '../state.ts';
import { PHASES } from './job.ts';
import { cancelOpening, opening } from './under-way.ts';

/** How far opening is, and the way out; afterwards that the picture's program is being compiled. */
export function OpeningCard() {
  const t = dictionary.value;
  const now = opening.value;
  // Without triangles a coarser program draws meanwhile, and nothing has to be said.
  if (!now) return compiling.value && hasTriangles.value ? <Compiling /> : null;
  const share = (PHASES.indexOf(now.phase) + now.share) / PHASES.length;
  return (
    <div id="opening" class="opening" role="status">
      <p>
        <strong>{t.opening(now.name)}</strong>
        <span>{t.phases[now.phase]}</span>
      </p>
      <progress aria-label={t.opening(now.name)} value={share} max={1} />
      <Button id="cancel-opening" icon="close" onClick={cancelOpening}>
        {t.cancel}
      </Button>
    </div>
  );
}

function Compiling() {
  const t = dictionary.value;
  return (
    <div id="compiling" class="opening" role="status">
      <p>
        <strong>{t.compiling}</strong>
        <span>{t.compilingFor(t.backendNames[renderer.value?.backend ?? 'webgl2'])}</span>
      </p>
      <progress aria-label={t.compiling} />
    </div>
  );
}
