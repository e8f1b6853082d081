import { signal } from '@preact/signals';
import type { Dictionary } from './i18n.ts';

/** A sentence over the picture. It is a function of the dictionary, so that it follows the language. */
export interface Notice {
  /** One notice a subject: a newer one takes the place of the older. */
  readonly subject:
    | 'backend'
    | 'cpu'
    | 'device'
    | 'file'
    | 'focus'
    | 'parameters'
    | 'error'
    | 'path'
    | 'compare'
    | 'save';
  readonly text: (dictionary: Dictionary) => string;
}

/** What is not about a failure goes by itself after a while: it may be read, and need not be kept. */
export const isBrief = (subject: Notice['subject']): boolean =>
  ['cpu', 'focus', 'parameters', 'path', 'compare'].includes(subject);

export const notices = signal<readonly Notice[]>([]);

export function dismiss(subject: Notice['subject']): void {
  notices.value = notices.peek().filter((notice) => notice.subject !== subject);
}

export function notify(subject: Notice['subject'], text: Notice['text']): void {
  notices.value = [...notices.peek().filter((notice) => notice.subject !== subject), { subject, text }];
}

export const reasonOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
