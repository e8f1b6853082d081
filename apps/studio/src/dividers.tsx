import { fitDividers, moveDivider, stripValues } from './comparison.ts';
import { dictionary } from './i18n.ts';
import { chosenDividers, comparing, dividers, stageHeight, stageWidth, textShare, visibleShare } from './state.ts';

const percent = (share: number): string => `${share * 100}%`;

/** Keyboard step, as a share of the width; with Shift ten times as far. */
const STEP = 0.01;

/** The comparison view's two dividers and the names of its strips, over the picture. */
export function Dividers() {
  const mode = comparing.value;
  if (mode === 'off') return null;
  const t = dictionary.value;
  const [first, second] = dividers.value;
  const edges = [0, first, second, 1];
  return (
    <section
      class="comparison"
      aria-label={t.compareWhat}
      style={{ width: `${stageWidth.value}px`, height: `${stageHeight.value}px` }}
    >
      {stripValues[mode].map((value, i) => (
        <Label
          key={value}
          left={edges[i]!}
          right={Math.min(edges[i + 1]!, textShare.value)}
          text={mode === 'reflections' ? t.panelReflections(value) : t.panelSamples(value)}
        />
      ))}
      <Divider index={0} />
      <Divider index={1} />
    </section>
  );
}

/** A strip's name, in the middle of what can be seen of it; gone when there is no room for it. */
function Label({ left, right, text }: { left: number; right: number; text: string }) {
  if ((right - left) * stageWidth.value < 56) return null;
  return (
    <div class="strip" style={{ left: percent(left), width: percent(right - left) }}>
      <span class="strip-name">{text}</span>
    </div>
  );
}

function Divider({ index }: { index: 0 | 1 }) {
  const [first, second] = dividers.value;
  const at = dividers.value[index];
  const moveTo = (share: number): void =>
    void (chosenDividers.value = fitDividers(moveDivider(dividers.peek(), index, share), visibleShare.peek()));
  const dragged = (event: PointerEvent): void => {
    const element = event.currentTarget as HTMLElement;
    if (element.hasPointerCapture(event.pointerId)) moveTo(event.clientX / stageWidth.peek());
  };
  const pressed = (event: KeyboardEvent): void => {
    const step = event.shiftKey ? STEP * 10 : STEP;
    if (event.key === 'ArrowLeft') moveTo(at - step);
    else if (event.key === 'ArrowRight') moveTo(at + step);
    else if (event.key === 'Home') moveTo(0);
    else if (event.key === 'End') moveTo(1);
    else return;
    event.preventDefault();
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: hr cannot be moved; this is ARIA's movable separator.
    <div
      id={`divider-${index + 1}`}
      class="divider"
      role="separator"
      tabIndex={0}
      aria-orientation="vertical"
      aria-label={dictionary.value.divider(index + 1)}
      aria-valuemin={index === 0 ? 0 : Math.round(first * 100)}
      aria-valuemax={Math.round((index === 0 ? second : visibleShare.value) * 100)}
      aria-valuenow={Math.round(at * 100)}
      style={{ left: percent(at) }}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={dragged}
      onKeyDown={pressed}
    />
  );
}
