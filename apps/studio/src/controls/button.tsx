import type { ComponentChildren } from 'preact';
import { Icon, type IconName } from './icon.tsx';

interface ButtonProps {
  readonly id?: string;
  readonly icon: IconName;
  readonly onClick: () => void;
  /** Said to a screen reader and shown as a tip, for a button without words. */
  readonly name?: string;
  readonly children?: ComponentChildren;
  readonly kind?: 'plain' | 'primary' | 'round';
  readonly expanded?: boolean;
  readonly controls?: string;
  /** Why it has no effect now; then it cannot be pressed. */
  readonly idle?: string | null;
}

export function Button({ id, icon, onClick, name, children, kind = 'plain', expanded, controls, idle }: ButtonProps) {
  return (
    <button
      id={id}
      type="button"
      class={`button ${kind}${children ? '' : ' wordless'}`}
      aria-label={name}
      title={idle ?? name}
      aria-description={idle ?? undefined}
      disabled={Boolean(idle)}
      aria-expanded={expanded}
      aria-controls={controls}
      onClick={onClick}
    >
      <Icon name={icon} />
      {children && <span>{children}</span>}
    </button>
  );
}
