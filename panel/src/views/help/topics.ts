// What F1 explains: the names in data-help, each with a text of the catalogue.
import { english } from '../../text/english';
import type { TextKey } from '../../text/catalogue';

export function topicOf(name: string): TextKey | null {
  const key = `topic.${name}`;
  return name !== '' && Object.hasOwn(english, key) ? (key as TextKey) : null;
}
