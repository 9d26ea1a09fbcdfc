// What F1 explains: the names in data-help, each with a text of the catalogue.
import { spoken } from '../../stores/spoken.svelte';
import type { TextKey } from '../../text/catalogue';

export function topicOf(name: string): TextKey | null {
  const key = `topic.${name}`;
  return name !== '' && Object.hasOwn(spoken.texts ?? {}, key) ? (key as TextKey) : null;
}
