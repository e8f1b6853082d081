import { useRef } from 'preact/hooks';
import { chooseScene } from '../actions.ts';
import { builtInScene, sceneIds } from '../built-in-scenes.ts';
import { Button } from '../controls/button.tsx';
import { Choice } from '../controls/choice.tsx';
import { dictionary, sceneName } from '../i18n.ts';
import { chosenFiles } from '../opening/given-files.ts';
import { openFiles } from '../opening/open.ts';
import { openedModels } from '../opening/opened-models.ts';
import { opening } from '../opening/under-way.ts';
import { shown } from '../state.ts';
import { Section } from './section.tsx';

/** A phone's browser has no folders to choose, and nothing to drag from. */
const isDesk = matchMedia('(pointer: fine)').matches;

export function SceneSection() {
  const t = dictionary.value;
  const options = sceneIds.map((id) => ({ value: id, label: sceneName(id, builtInScene(id).scene.name) }));
  const models = openedModels.value;
  options.push(...models.map(({ key, name }) => ({ value: `file ${key}`, label: name })));
  const now = shown.value;
  // Drawn anew when a model has been read or not, so that the scene on show is the one that is marked.
  void opening.value?.name;
  const choose = (value: string): void => {
    const model = models.find(({ key }) => value === `file ${key}`);
    if (model) void openFiles(model.files);
    else chooseScene(value);
  };
  return (
    <Section id="scene" title={t.scene}>
      <Choice
        id="scene"
        label={t.scene}
        options={options}
        value={now?.id === 'file' ? `file ${now.opened}` : (now?.id ?? null)}
        onChange={choose}
        stacked
      />
      <div class="buttons">
        <Picker id="scene-file" label={t.openFile} />
        {isDesk && <Picker id="scene-folder" label={t.openFolder} folder />}
      </div>
      <p class="idle">{isDesk ? t.openHint : t.openHintTouch}</p>
    </Section>
  );
}

/** A button that opens the browser's own dialog. Any file may be chosen: what cannot be opened is told why. */
function Picker({ id, label, folder = false }: { id: string; label: string; folder?: boolean }) {
  const picker = useRef<HTMLInputElement>(null);
  const picked = (input: HTMLInputElement): void => {
    void openFiles(chosenFiles(input.files ?? []));
    // So that the same files can be chosen again once they are mended.
    input.value = '';
  };
  return (
    <>
      <input
        ref={picker}
        id={id}
        type="file"
        multiple
        // @ts-expect-error: not in the types, though in all browsers
        webkitdirectory={folder}
        aria-label={label}
        tabIndex={-1}
        hidden
        onChange={(event) => picked(event.currentTarget)}
      />
      <Button id={folder ? 'open-folder' : 'open-file'} icon="open" onClick={() => picker.current?.click()}>
        {label}
      </Button>
    </>
  );
}
