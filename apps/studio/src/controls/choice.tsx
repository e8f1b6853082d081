import { Idle } from './idle.tsx';

export interface Option<Value extends string | number> {
  readonly value: Value;
  readonly label: string;
}

interface ChoiceProps<Value extends string | number> {
  readonly id: string;
  readonly label: string;
  readonly options: readonly Option<Value>[];
  /** Null: none of them. */
  readonly value: Value | null;
  readonly onChange: (value: Value) => void;
  /** One below the other instead of side by side. */
  readonly stacked?: boolean;
  readonly disabled?: boolean;
  /** Why it has no effect now; then nothing can be chosen. */
  readonly idle?: string | null;
}

/** One of a few: radio buttons that look like segments of a bar. */
export function Choice<Value extends string | number>(props: ChoiceProps<Value>) {
  const { id, label, options, value, onChange, stacked = false, disabled = false, idle } = props;
  return (
    <fieldset
      id={id}
      class={stacked ? 'choice stacked' : 'choice'}
      disabled={disabled || Boolean(idle)}
      aria-describedby={idle ? `${id}-idle` : undefined}
    >
      <legend>{label}</legend>
      <div class="segments">
        {options.map((option) => (
          <label key={option.value}>
            <input
              type="radio"
              name={id}
              value={option.value}
              checked={option.value === value}
              onChange={() => onChange(option.value)}
            />
            <span>{option.label}</span>
          </label>
        ))}
      </div>
      {idle && <Idle id={id} why={idle} />}
    </fieldset>
  );
}
