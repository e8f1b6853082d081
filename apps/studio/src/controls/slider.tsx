import { Idle } from './idle.tsx';

interface SliderProps {
  readonly id: string;
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** The value in words. */
  readonly text: string;
  readonly onInput: (value: number) => void;
  /** Why it has no effect now; then it cannot be moved. */
  readonly idle?: string | null;
}

/** A named slider with its value in words beside the name. */
export function Slider({ id, label, value, min, max, step, text, onInput, idle }: SliderProps) {
  return (
    <div class="slider">
      <label for={id}>{label}</label>
      <output for={id}>{text}</output>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        aria-valuetext={text}
        disabled={Boolean(idle)}
        aria-describedby={idle ? `${id}-idle` : undefined}
        style={{ '--share': `${((value - min) / (max - min)) * 100}%` }}
        onInput={(event) => onInput(event.currentTarget.valueAsNumber)}
      />
      {idle && <Idle id={id} why={idle} />}
    </div>
  );
}
