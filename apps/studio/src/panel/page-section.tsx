import { Choice, type Option } from '../controls/choice.tsx';
import { chooseLanguage, dictionary, type Language, language, languageNames } from '../i18n.ts';
import { chooseTheme, type Theme, theme } from '../theme.ts';
import { Section } from './section.tsx';

export function PageSection() {
  const t = dictionary.value;
  const languages: Option<Language>[] = [
    { value: 'en', label: languageNames.en },
    { value: 'zh-CN', label: languageNames['zh-CN'] },
  ];
  const themes: Option<Theme>[] = [
    { value: 'system', label: t.themeSystem },
    { value: 'light', label: t.themeLight },
    { value: 'dark', label: t.themeDark },
  ];
  return (
    <Section id="page" title={t.page} foldable>
      <Choice id="language" label={t.language} options={languages} value={language.value} onChange={chooseLanguage} />
      <Choice id="theme" label={t.theme} options={themes} value={theme.value} onChange={chooseTheme} />
    </Section>
  );
}
