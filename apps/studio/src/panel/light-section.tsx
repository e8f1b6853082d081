import { useSignal } from '@preact/signals';
import { Choice } from '../controls/choice.tsx';
import { Slider } from '../controls/slider.tsx';
import { dictionary } from '../i18n.ts';
import {
  comparing,
  exposure,
  hasTriangles,
  integrator,
  isStill,
  lightSamples,
  maxDepth,
  reflections,
  toneMapping,
} from '../state.ts';
import { Section } from './section.tsx';

const toneMappings = ['none', 'aces', 'agx', 'neutral'] as const;
const integrators = ['classic', 'path'] as const;
const depths: readonly number[] = [1, 2, 3, 5, 12, -1];
const presets = [1, 9, 16, 64];
const signed = (n: number): string => (n > 0 ? '+' : n < 0 ? '−' : '') + Math.abs(n).toFixed(1);

export function LightSection() {
  const t = dictionary.value;
  return (
    <Section id="light" title={t.light}>
      <Choice
        id="integrator"
        label={t.integrator}
        options={integrators.map((value) => ({ value, label: t.integratorNames[value] }))}
        value={integrator.value}
        onChange={(kind) => (integrator.value = kind)}
        idle={hasTriangles.value && !isStill.value ? t.classicHasNoMeshes : null}
      />
      {integrator.value === 'classic' ? <ClassicControls /> : <PathControls />}
      <Slider
        id="exposure"
        label={t.exposure}
        min={-10}
        max={10}
        step={0.1}
        value={exposure.value}
        text={t.stops(signed(exposure.value))}
        onInput={(value) => (exposure.value = value)}
      />
      <Choice
        id="tone-mapping"
        label={t.toneMapping}
        options={toneMappings.map((value) => ({ value, label: t.toneMappingNames[value] }))}
        value={toneMapping.value}
        onChange={(kind) => (toneMapping.value = kind)}
      />
    </Section>
  );
}

function ClassicControls() {
  const t = dictionary.value;
  return (
    <>
      <Slider
        id="reflections"
        label={t.reflections}
        min={0}
        max={64}
        step={1}
        value={reflections.value}
        text={String(reflections.value)}
        onInput={(value) => (reflections.value = value)}
        idle={comparing.value === 'reflections' ? t.setByComparison('1 · 2 · 10') : null}
      />
      <LightSamples />
    </>
  );
}

function PathControls() {
  const t = dictionary.value;
  return (
    <Choice
      id="max-depth"
      label={t.maxDepth}
      options={depths.map((value) => ({ value, label: value < 0 ? t.noLimit : String(value) }))}
      value={depths.includes(maxDepth.value) ? maxDepth.value : null}
      onChange={(depth) => (maxDepth.value = depth)}
    />
  );
}

function LightSamples() {
  const t = dictionary.value;
  const idle = comparing.value === 'samples' ? t.setByComparison('1 · 9 · 64') : null;
  const wishesOther = useSignal(false);
  const other = wishesOther.value || !presets.includes(lightSamples.value);
  const options = [...presets.map((n) => ({ value: n, label: String(n) })), { value: 0, label: t.lightSamplesCustom }];
  const choose = (value: number): void => {
    wishesOther.value = value === 0;
    if (value > 0) lightSamples.value = value;
  };
  /** What stands in the field and cannot be taken. */
  const refused = useSignal<string | null>(null);
  const typed = (input: HTMLInputElement): void => {
    const value = input.valueAsNumber;
    const good = Number.isInteger(value) && value >= 1 && value <= 256;
    refused.value = good ? null : input.value;
    if (good) lightSamples.value = value;
  };
  const left = (input: HTMLInputElement): void => {
    input.value = String(lightSamples.value);
    refused.value = null;
  };
  return (
    <div class="with-number">
      <Choice
        id="light-samples"
        label={t.lightSamples}
        options={options}
        value={other ? 0 : lightSamples.value}
        onChange={choose}
        idle={idle}
      />
      {other && !idle && (
        <input
          id="light-samples-number"
          class="number"
          type="number"
          min={1}
          max={256}
          step={1}
          aria-label={t.lightSamplesNumber}
          value={refused.value ?? lightSamples.value}
          onInput={(event) => typed(event.currentTarget)}
          aria-invalid={refused.value !== null}
          onBlur={(event) => left(event.currentTarget)}
        />
      )}
      {other && !idle && (
        <p class="idle" role="status">
          {refused.value !== null && t.lightSamplesNumber}
        </p>
      )}
    </div>
  );
}
