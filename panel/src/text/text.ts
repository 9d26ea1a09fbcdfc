// t('key', {name: value}): a text of the chosen language; {name} in it is the value.
import { spoken } from '../stores/spoken.svelte';
import type { TextKey } from './catalogue';

export function fill(text: string, values: Record<string, string | number>): string {
  return text.replace(/\{(\w+)\}/g, (mark, name: string) => String(values[name] ?? mark));
}

export function t(key: TextKey, values: Record<string, string | number> = {}): string {
  return fill(spoken.texts?.[key] ?? '', values);
}
