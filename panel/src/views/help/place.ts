// Places of the manual, and how they stand in the address of the page.
export const front = 'README.md';
export const prefix = 'manual/';

/** A place in the manual: a file, and a heading in it or nothing. */
export interface Place {
  file: string;
  heading: string;
}

/** What stands behind #/help/ when a place of the manual is shown; null: it is something else. */
export function placeOf(rest: string): Place | null {
  if (!rest.startsWith(prefix)) return null;
  const [file = '', heading = ''] = rest.slice(prefix.length).split('#');
  return { file: file === '' ? front : file, heading };
}

export function addressOf({ file, heading }: Place): string {
  const place = heading === '' ? file : `${file}#${heading}`;
  return `#/help/${encodeURIComponent(prefix + place)}`;
}
