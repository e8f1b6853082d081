import { goToTime, sceneDuration, stepTime, togglePlaying } from '../actions.ts';
import { Button } from '../controls/button.tsx';
import { Choice } from '../controls/choice.tsx';
import { Slider } from '../controls/slider.tsx';
import { dictionary } from '../i18n.ts';
import { isStill, moves, panelOpen, playing, shown, speed, time } from '../state.ts';
import { Section } from './section.tsx';

const speeds = [0.25, 0.5, 1, 2, 4].map((value) => ({ value, label: `${value}×` }));

export function PlayButton() {
  const t = dictionary.value;
  return (
    <Button
      id="play"
      icon={playing.value ? 'pause' : 'play'}
      kind="primary"
      name={playing.value ? t.pause : t.play}
      onClick={togglePlaying}
      idle={whyIdle()}
    />
  );
}

/** Why nothing plays. */
function whyIdle(): string | null {
  const t = dictionary.value;
  if (!moves.value) return t.nothingMoves;
  return isStill.value ? t.stillDoesNotPlay : null;
}

export function MotionSection() {
  const t = dictionary.value;
  const duration = shown.value ? sceneDuration(shown.value.scene) : 10;
  if (!moves.value)
    return (
      <Section id="motion" title={t.motion}>
        <p class="idle">{t.nothingMoves}</p>
      </Section>
    );
  return (
    <Section id="motion" title={t.motion}>
      <div class="transport">
        {/* Folded, the panel has it in its head. */}
        {panelOpen.value && <PlayButton />}
        <Button id="step" icon="step" name={t.step} onClick={stepTime} />
        <Slider
          id="time"
          label={t.time}
          min={0}
          max={duration}
          step={1 / 60}
          value={time.value % duration}
          text={t.seconds(time.value.toFixed(2))}
          onInput={goToTime}
        />
      </div>
      <Choice
        id="speed"
        label={t.speed}
        options={speeds}
        value={speed.value}
        onChange={(value) => (speed.value = value)}
        idle={isStill.value ? t.stillDoesNotPlay : null}
      />
    </Section>
  );
}
