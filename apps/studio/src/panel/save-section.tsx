import { Button } from '../controls/button.tsx';
import { dictionary } from '../i18n.ts';
import type { SavedAs } from '../saving/job.ts';
import { cancelSaving, save, saving } from '../saving/save.ts';
import { isStill, shownView } from '../state.ts';
import { Section } from './section.tsx';

/** The picture and the scene as files. */
export function SaveSection() {
  const t = dictionary.value;
  const share = saving.value;
  const busy = share === null ? null : t.saving;
  const isPicture = shownView.value === 'picture' || isStill.value;
  const button = (as: SavedAs, idle: string | null = null) => (
    <Button id={`save-${as}`} icon="save" onClick={() => void save(as)} idle={busy ?? idle}>
      {t.saveAs[as]}
    </Button>
  );
  return (
    <Section id="save" title={t.save} foldable>
      <div class="buttons">
        {button('png', isPicture ? null : t.savePicture)}
        {button('exr')}
        {button('glb')}
        {button('mitsuba')}
      </div>
      {share !== null && (
        <div id="saving" class="saving" role="status">
          <progress aria-label={t.saving} value={share || undefined} max={1} />
          <Button id="cancel-saving" icon="close" onClick={cancelSaving}>
            {t.cancel}
          </Button>
        </div>
      )}
    </Section>
  );
}
