import { computed, effect, signal } from '@preact/signals';
import { en } from './en.ts';
import { loadTables } from './said-in-chinese.ts';
import { recall, remember } from './storage.ts';
import { zhCN } from './zh-CN.ts';

/** What each language says: the keys of the English one. */
export type Dictionary = typeof en;
export type Language = 'en' | 'zh-CN';

export const languageNames: Readonly<Record<Language, string>> = { en: 'English', 'zh-CN': '简体中文' };

/** The first of the wished languages that there is, by its primary subtag; English otherwise. */
export function pickLanguage(wishes: readonly string[]): Language {
  for (const wish of wishes) {
    const primary = wish.toLowerCase().split(/[-_]/)[0];
    if (primary === 'zh') return 'zh-CN';
    if (primary === 'en') return 'en';
  }
  return 'en';
}

export const language = signal<Language>('en');
export const dictionary = computed<Dictionary>(() => (language.value === 'en' ? en : zhCN));

export function chooseLanguage(next: Language): void {
  language.value = next;
  remember('language', next);
}

/** Address first, then what was chosen before, then the browser's languages. */
export function startLanguage(fromAddress: string | null): void {
  const wishes = [fromAddress, recall('language'), ...navigator.languages];
  language.value = pickLanguage(wishes.filter((wish) => wish !== null));
  effect(() => {
    document.documentElement.lang = language.value;
    document.title = dictionary.value.title;
  });
}

/** Resolves when what readers of files tell can be said. */
export const readyToReport = async (): Promise<void> => (language.peek() === 'en' ? undefined : loadTables());

export function sceneName(id: string, ownName: string): string {
  const names = dictionary.value.sceneNames;
  return Object.hasOwn(names, id) ? names[id]! : ownName;
}
