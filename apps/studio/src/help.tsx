import { builtInScenes } from 'mirrorball';
import { Dialog } from './controls/dialog.tsx';
import { type Dictionary, dictionary } from './i18n.ts';
import { helpOpen } from './state.ts';

const keyRows = (t: Dictionary): readonly (readonly [readonly string[], string])[] => [
  [[t.keyNames.space], t.keys.play],
  [['.'], t.keys.step],
  [builtInScenes.map((_, i) => String(i + 1)), t.keys.scene],
  [['[', ']'], t.keys.reflections],
  [['C'], t.keys.compare],
  [[t.keyNames.arrows, 'A', 'D'], t.keys.orbit],
  [[t.keyNames.shiftArrows], t.keys.pan],
  [['+', '−', 'W', 'S'], t.keys.dolly],
  [['O'], t.keys.focus],
  [['R'], t.keys.reset],
  [['F'], t.keys.frame],
  [['X'], t.keys.fullScreen],
  [['P'], t.keys.panel],
  [['H', '?'], t.keys.help],
];

/** Every key and gesture. */
export function Help() {
  const open = helpOpen.value;
  return (
    <Dialog id="help" title={dictionary.value.help} open={open} onClose={() => (helpOpen.value = false)}>
      {open && <HelpBody />}
    </Dialog>
  );
}

function HelpBody() {
  const t = dictionary.value;
  return (
    <>
      <h3>{t.keysTitle}</h3>
      <dl class="keys">
        {keyRows(t).map(([keys, what]) => (
          <div key={what}>
            <dt>
              {keys.map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dt>
            <dd>{what}</dd>
          </div>
        ))}
      </dl>
      <h3>{t.gesturesTitle}</h3>
      <dl class="keys gestures">
        {Object.values(t.gestures).map(([gesture, what]) => (
          <div key={gesture}>
            <dt>{gesture}</dt>
            <dd>{what}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}
