// The languages of the page, each a catalogue of its own.
import { english } from './english';
import { russian } from './russian';

export type TextKey = keyof typeof english;

export const catalogues = { en: english, ru: russian } satisfies Record<
  string,
  Record<TextKey, string>
>;
export type Language = keyof typeof catalogues;
export const languages = Object.keys(catalogues) as Language[];
export const languageNames: Record<Language, string> = { en: 'English', ru: 'Русский' };
