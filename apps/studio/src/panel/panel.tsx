import { useLayoutEffect, useRef } from 'preact/hooks';
import { Button } from '../controls/button.tsx';
import { dictionary, sceneName } from '../i18n.ts';
import { isPhone, panelOpen, sheetHeight, shown } from '../state.ts';
import { ComparisonSection } from './comparison-section.tsx';
import { EnvironmentSection } from './environment-section.tsx';
import { LightSection } from './light-section.tsx';
import { ModelSection } from './model-section.tsx';
import { MotionSection, PlayButton } from './motion-section.tsx';
import { PageSection } from './page-section.tsx';
import { QualitySection } from './quality-section.tsx';
import { SaveSection } from './save-section.tsx';
import { SceneSection } from './scene-section.tsx';
import { ViewSection } from './view-section.tsx';

const toggle = (): void => void (panelOpen.value = !panelOpen.peek());

/** All controls: a card at the right, or a sheet at the bottom of a phone. Folded, its head remains. */
export function Panel() {
  const open = panelOpen.value;
  const element = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      sheetHeight.value = Math.round(entry!.borderBoxSize[0]!.blockSize);
    });
    observer.observe(element.current!);
    return () => observer.disconnect();
  }, []);
  return (
    <aside ref={element} id="panel" class={open ? 'panel open' : 'panel'} aria-label={dictionary.value.controls}>
      {isPhone.value ? <SheetHead /> : <CardHead />}
      <div id="panel-body" class="panel-body" hidden={!open}>
        <SceneSection />
        <ModelSection />
        <MotionSection />
        <LightSection />
        <ComparisonSection />
        <ViewSection />
        <EnvironmentSection />
        <SaveSection />
        <QualitySection />
        <PageSection />
      </div>
    </aside>
  );
}

function CardHead() {
  const t = dictionary.value;
  const open = panelOpen.value;
  return (
    <header class="panel-head">
      {open && <h1>Mirrorball</h1>}
      <Button
        id="panel-toggle"
        icon={open ? 'fold' : 'sliders'}
        kind="round"
        name={open ? t.foldPanel : t.unfoldPanel}
        expanded={open}
        controls="panel-body"
        onClick={toggle}
      />
      {!open && <PlayButton />}
    </header>
  );
}

function SheetHead() {
  const t = dictionary.value;
  const open = panelOpen.value;
  const now = shown.value;
  return (
    <header class="sheet-head">
      <button
        id="panel-toggle"
        type="button"
        class="handle"
        aria-expanded={open}
        aria-controls="panel-body"
        onClick={toggle}
      >
        <span class="grip" />
        <span class="handle-text">
          <strong>{now ? sceneName(now.id, now.scene.name) : 'Mirrorball'}</strong>
          <small>{open ? t.foldPanel : t.unfoldPanel}</small>
        </span>
      </button>
      {!open && <PlayButton />}
    </header>
  );
}
