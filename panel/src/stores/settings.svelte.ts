// What a person chose for this screen: language, theme, contrast. Kept in the browser, nowhere else.
import { shadings } from '../geometry/shading';
import { languages, type Language } from '../text/catalogue';

export const themes = ['auto', 'light', 'dark'] as const;
export const contrasts = ['auto', 'high'] as const;

const key = 'stanok.screen';

interface Saved {
  language?: string;
  theme?: string;
  contrast?: string;
  shading?: string;
}

function saved(): Saved {
  try {
    return JSON.parse(localStorage.getItem(key) ?? '{}') as Saved;
  } catch {
    return {};
  }
}

function firstLanguage(wanted: string | undefined): Language {
  const known = languages.find((one) => one === wanted);
  if (known !== undefined) return known;
  return navigator.language.startsWith('ru') ? 'ru' : 'en';
}

function oneOf<T extends string>(values: readonly T[], wanted: string | undefined, first: T): T {
  return values.find((one) => one === wanted) ?? first;
}

class Settings {
  language = $state<Language>(firstLanguage(saved().language));
  theme = $state(oneOf(themes, saved().theme, 'auto'));
  contrast = $state(oneOf(contrasts, saved().contrast, 'auto'));
  /** Of the path. */
  shading = $state(oneOf(shadings, saved().shading, 'kind'));

  /** Writes the choice down and lets the style sheet know. */
  apply(): void {
    const { language, theme, contrast, shading } = this;
    localStorage.setItem(key, JSON.stringify({ language, theme, contrast, shading }));
    const root = document.documentElement;
    root.lang = language;
    root.dataset['theme'] = theme;
    root.dataset['contrast'] = contrast;
  }
}

export const settings = new Settings();
