import { useSignal, useSignalEffect } from '@preact/signals';
import type { ViewName } from 'mirrorball';
import { resetView, toggleFullScreen } from '../actions.ts';
import { Button } from '../controls/button.tsx';
import { Menu } from '../controls/menu.tsx';
import { en } from '../en.ts';
import { dictionary } from '../i18n.ts';
import { helpOpen, isStill, shownView } from '../state.ts';
import { LensControls } from './lens-controls.tsx';
import { Section } from './section.tsx';

const viewNames = Object.keys(en.viewNames) as readonly ViewName[];

export function ViewSection() {
  const t = dictionary.value;
  return (
    <Section id="view" title={t.view}>
      <Menu
        id="show"
        label={t.show}
        options={viewNames.map((value) => ({ value, label: t.viewNames[value] }))}
        value={isStill.value ? 'picture' : shownView.value}
        onChange={(view) => (shownView.value = view)}
        idle={isStill.value ? t.stillShowsPicture : null}
      />
      <LensControls />
      <div class="buttons">
        <Button id="reset-view" icon="reset" onClick={resetView}>
          {t.resetView}
        </Button>
        {document.fullscreenEnabled && <FullScreenButton />}
        <Button id="show-help" icon="keys" onClick={() => (helpOpen.value = true)}>
          {t.help}
        </Button>
      </div>
    </Section>
  );
}

function FullScreenButton() {
  const t = dictionary.value;
  const full = useSignal(document.fullscreenElement !== null);
  useSignalEffect(() => {
    const follow = (): void => void (full.value = document.fullscreenElement !== null);
    document.addEventListener('fullscreenchange', follow);
    return () => document.removeEventListener('fullscreenchange', follow);
  });
  return (
    <Button id="full-screen" icon={full.value ? 'smallScreen' : 'fullScreen'} onClick={() => void toggleFullScreen()}>
      {full.value ? t.leaveFullScreen : t.fullScreen}
    </Button>
  );
}
