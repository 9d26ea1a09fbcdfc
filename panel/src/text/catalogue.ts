// The languages of the page, each a catalogue of its own, of which a page loads the one that is read.
import type { english } from './english';

export type TextKey = keyof typeof english;
export type Catalogue = Record<TextKey, string>;

const loaders = {
  en: async (): Promise<Catalogue> => (await import('./english')).english,
  ru: async (): Promise<Catalogue> => (await import('./russian')).russian,
};
export type Language = keyof typeof loaders;
export const languages = Object.keys(loaders) as Language[];
export const languageNames: Record<Language, string> = { en: 'English', ru: 'Русский' };

export const load = (language: Language): Promise<Catalogue> => loaders[language]();
