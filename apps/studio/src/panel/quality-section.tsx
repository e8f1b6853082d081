import type { Backend } from 'mirrorball';
import { Choice, type Option } from '../controls/choice.tsx';
import { Slider } from '../controls/slider.tsx';
import { Switch } from '../controls/switch.tsx';
import { dictionary } from '../i18n.ts';
import { chooseBackend } from '../session.ts';
import { adaptive, renderer, resolutionScale, switchingTo, targetFps } from '../state.ts';
import { Section } from './section.tsx';

export function QualitySection() {
  const t = dictionary.value;
  const backends: Option<Backend>[] = [
    { value: 'webgpu', label: t.backendNames.webgpu },
    { value: 'webgl2', label: t.backendNames.webgl2 },
    { value: 'cpu', label: t.cpuStill },
  ];
  const rates: Option<30 | 60>[] = [
    { value: 60, label: t.fps(60) },
    { value: 30, label: t.fps(30) },
  ];
  return (
    <Section id="quality" title={t.quality} foldable>
      <Choice
        id="backend"
        label={t.backend}
        options={backends}
        value={renderer.value?.backend ?? null}
        onChange={(backend) => void chooseBackend(backend)}
        disabled={switchingTo.value !== null}
      />
      <Slider
        id="resolution"
        label={t.resolution}
        min={0.1}
        max={1}
        step={0.05}
        value={resolutionScale.value}
        text={t.percent(Math.round(resolutionScale.value * 100))}
        onInput={(value) => (resolutionScale.value = value)}
      />
      <Choice
        id="target-fps"
        label={t.target}
        options={rates}
        value={targetFps.value}
        onChange={(fps) => (targetFps.value = fps)}
      />
      <Switch
        id="adaptive"
        label={t.adaptive}
        checked={adaptive.value}
        onChange={(checked) => (adaptive.value = checked)}
      />
    </Section>
  );
}
