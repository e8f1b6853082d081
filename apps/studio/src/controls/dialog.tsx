import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { dictionary } from '../i18n.ts';
import { Button } from './button.tsx';

interface DialogProps {
  readonly id: string;
  readonly title: string;
  /** What it is open for, another thing each time, or true; null or false: it is closed. */
  readonly open: unknown;
  readonly onClose: () => void;
  readonly actions?: ComponentChildren;
  readonly children: ComponentChildren;
}

/** A modal dialog with a heading, a body that scrolls, and a way out by button, Escape or a click beside it. */
export function Dialog({ id, title, open, onClose, actions, children }: DialogProps) {
  const element = useRef<HTMLDialogElement>(null);
  const shown = useRef<unknown>(null);
  useEffect(() => {
    if (!open) return element.current?.close();
    if (!element.current?.open) element.current?.showModal();
    shown.current = open;
  }, [open]);
  // A browser tells that a dialog is closed some frames later, when it may be open again, or about to be, for something else.
  const closed = (): void => {
    if (!element.current?.open && shown.current === open) onClose();
  };
  const clicked = (event: MouseEvent): void => {
    if (event.target === element.current) onClose();
  };
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: the keyboard's way out is Escape, which closes a dialog by itself.
    <dialog id={id} ref={element} aria-labelledby={`${id}-title`} onClose={closed} onClick={clicked}>
      <div class="dialog-frame">
        <header>
          <h2 id={`${id}-title`}>{title}</h2>
          <Button icon="close" kind="round" name={dictionary.value.close} onClick={onClose} />
        </header>
        {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable to be scrolled by keys. */}
        <section class="dialog-body" tabIndex={0} aria-labelledby={`${id}-title`}>
          {open ? children : null}
        </section>
        {actions && <footer>{actions}</footer>}
      </div>
    </dialog>
  );
}
