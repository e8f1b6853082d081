import type { ComponentChildren } from 'preact';

interface SectionProps {
  readonly id: string;
  readonly title: string;
  readonly children: ComponentChildren;
  /** Opened and closed by its heading; closed at first. */
  readonly foldable?: boolean;
}

export function Section({ id, title, children, foldable = false }: SectionProps) {
  if (foldable) {
    return (
      <details class="section" id={`section-${id}`}>
        <summary>
          <h2>{title}</h2>
        </summary>
        <div class="section-body">{children}</div>
      </details>
    );
  }
  return (
    <section class="section" id={`section-${id}`} aria-labelledby={`heading-${id}`}>
      <h2 id={`heading-${id}`}>{title}</h2>
      <div class="section-body">{children}</div>
    </section>
  );
}
