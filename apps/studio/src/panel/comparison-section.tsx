import type { ComparisonMode } from '../comparison.ts';
import { Choice, type Option } from '../controls/choice.tsx';
import { dictionary } from '../i18n.ts';
import { cannotCompare, comparisonMode } from '../state.ts';
import { Section } from './section.tsx';

export function ComparisonSection() {
  const t = dictionary.value;
  const options: Option<ComparisonMode>[] = [
    { value: 'off', label: t.compareOff },
    { value: 'reflections', label: `${t.compareReflections} 1 · 2 · 10` },
    { value: 'samples', label: `${t.compareSamples} 1 · 9 · 64` },
  ];
  return (
    <Section id="comparison" title={t.compare}>
      <Choice
        id="comparison"
        label={t.compareWhat}
        options={options}
        value={comparisonMode.value}
        onChange={(mode) => (comparisonMode.value = mode)}
        idle={cannotCompare.value && t[cannotCompare.value]}
        stacked
      />
    </Section>
  );
}
