// Units in the words of the chosen language.
import { isRotary } from '../stores/format';
import { t } from './text';

export const unitOf = (word: string): string => (isRotary(word) ? '°' : t('unit.mm'));
