import type { Option } from './choice.tsx';
import { Idle } from './idle.tsx';

interface MenuProps<Value extends string> {
  readonly id: string;
  readonly label: string;
  readonly options: readonly Option<Value>[];
  readonly value: Value;
  readonly onChange: (value: Value) => void;
  /** Why it has no effect now; then nothing can be chosen. */
  readonly idle?: string | null;
}

/** One of many: the browser's own menu. */
export function Menu<Value extends string>({ id, label, options, value, onChange, idle }: MenuProps<Value>) {
  return (
    <div class="menu">
      <label for={id}>{label}</label>
      <select
        id={id}
        value={value}
        disabled={Boolean(idle)}
        aria-describedby={idle ? `${id}-idle` : undefined}
        onChange={(event) => onChange(event.currentTarget.value as Value)}
      >
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.label}
          </option>
        ))}
      </select>
      {idle && <Idle id={id} why={idle} />}
    </div>
  );
}
