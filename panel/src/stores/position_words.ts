// Positions as programs call them: the daemon tells words in mm and degrees, shown are those of the unit
// in which programs are read now.
import { t } from '../text/text';
import { fixed, isRotary, numberIn } from './format';
import type { Channel } from './machine.svelte';

export type Units = 'mm' | 'inch';

const mm_per_inch = 25.4;

/** The unit of its linear words: that of the codes in force. */
export const unitsOf = ({ units }: Pick<Channel, 'units'>): Units =>
  units === 'inch' ? 'inch' : 'mm';

/** Whether its value is a diameter, as X of a lathe in G7. */
export const isDiameter = ({ diameter = [] }: Pick<Channel, 'diameter'>, word: string): boolean =>
  diameter.includes(word);

const isInInches = (word: string, units: Units): boolean => units === 'inch' && !isRotary(word);

/** The unit of a word, in the chosen language. */
export function unitOf(word: string, units: Units = 'mm'): string {
  if (isRotary(word)) return '°';
  return units === 'inch' ? t('unit.inch') : t('unit.mm');
}

/** A value of the daemon, mm or deg, in digits of the unit that is shown. */
export const shownWord = (word: string, value: number, units: Units): string =>
  isInInches(word, units) ? fixed(value / mm_per_inch, 4) : fixed(value, 3);

/** What was written for a word in the unit that is shown, in mm or deg; null: it is no number. */
export function wordIn(text: string, word: string, units: Units): number | null {
  const value = numberIn(text);
  return value !== null && isInInches(word, units) ? value * mm_per_inch : value;
}
