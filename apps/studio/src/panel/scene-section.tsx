import { useRef } from 'preact/hooks';
import { chooseScene, openSceneFiles } from '../actions.ts';
import { Button } from '../controls/button.tsx';
import { Choice } from '../controls/choice.tsx';
import { dictionary, sceneName } from '../i18n.ts';
import { builtInScene, sceneIds } from '../scene-files.ts';
import { shown } from '../state.ts';
import { Section } from './section.tsx';

export function SceneSection() {
  const t = dictionary.value;
  const picker = useRef<HTMLInputElement>(null);
  const options = sceneIds.map((id) => ({ value: id, label: sceneName(id, builtInScene(id).scene.name) }));
  const now = shown.value;
  if (now?.id === 'file') options.push({ value: 'file', label: now.scene.name || now.fileName || 'scene.json' });

  const picked = (input: HTMLInputElement): void => {
    void openSceneFiles([...(input.files ?? [])]);
    // So that the same files can be chosen again once they are mended.
    input.value = '';
  };
  return (
    <Section id="scene" title={t.scene}>
      <Choice
        id="scene"
        label={t.scene}
        options={options}
        value={now?.id ?? null}
        onChange={(id) => id !== 'file' && chooseScene(id)}
        stacked
      />
      <input
        ref={picker}
        id="scene-file"
        type="file"
        accept=".json,application/json,.hdr,.exr,.npy,.pfm,.ply,.obj,.stl"
        multiple
        aria-label={t.openFile}
        tabIndex={-1}
        hidden
        onChange={(event) => picked(event.currentTarget)}
      />
      <Button id="open-file" icon="open" onClick={() => picker.current?.click()}>
        {t.openFile}
      </Button>
    </Section>
  );
}
