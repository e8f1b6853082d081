import { useRef } from 'preact/hooks';
import { Button } from '../controls/button.tsx';
import { Menu } from '../controls/menu.tsx';
import { Slider } from '../controls/slider.tsx';
import {
  chooseEnvironment,
  type EnvironmentKind,
  environmentKind,
  environmentStrength,
  environmentTurn,
  hasPicture,
  skyFile,
  strengthenEnvironment,
  turnEnvironment,
} from '../environment.ts';
import { dictionary } from '../i18n.ts';
import { chosenFiles } from '../opening/given-files.ts';
import { openFiles } from '../opening/open.ts';
import { integrator, isStill } from '../state.ts';
import { Section } from './section.tsx';

/** The strength goes in equal ratios, a doubling each ten steps. */
const toStep = (factor: number): number => Math.round(10 * Math.log2(Math.max(factor, 2 ** -5)));
const toFactor = (step: number): number => 2 ** (step / 10);

/** The light around the scene. */
export function EnvironmentSection() {
  const t = dictionary.value;
  const picker = useRef<HTMLInputElement>(null);
  const idle = integrator.value !== 'path' || isStill.value ? t.onlyPath : null;
  const file = skyFile.value;
  const options: { value: EnvironmentKind; label: string }[] = [
    { value: 'scene', label: t.environmentOwn },
    { value: 'studio', label: t.environmentStudio },
    { value: 'sky', label: t.environmentSky },
    ...(file ? [{ value: 'file' as const, label: file.name }] : []),
  ];
  return (
    <Section id="environment" title={t.environment}>
      <Menu
        id="environment-kind"
        label={t.environmentKind}
        options={options}
        value={environmentKind.value}
        onChange={chooseEnvironment}
        idle={idle}
      />
      <Slider
        id="environment-strength"
        label={t.strength}
        min={-50}
        max={50}
        step={1}
        value={toStep(environmentStrength.value)}
        text={t.times(environmentStrength.value.toPrecision(2))}
        onInput={(step) => strengthenEnvironment(toFactor(step))}
        idle={idle}
      />
      <Slider
        id="environment-turn"
        label={t.turn}
        min={-180}
        max={180}
        step={1}
        value={environmentTurn.value}
        text={t.degrees(environmentTurn.value)}
        onInput={turnEnvironment}
        idle={idle ?? (hasPicture.value ? null : t.turnNeedsPicture)}
      />
      <input
        ref={picker}
        id="environment-file"
        type="file"
        aria-label={t.openEnvironment}
        tabIndex={-1}
        hidden
        onChange={({ currentTarget }) => {
          void openFiles(chosenFiles(currentTarget.files ?? []));
          currentTarget.value = '';
        }}
      />
      <Button id="open-environment" icon="open" onClick={() => picker.current?.click()} idle={idle}>
        {t.openEnvironment}
      </Button>
    </Section>
  );
}
