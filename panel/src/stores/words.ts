// The words of the language: G and M codes, functions, system variables, and what each of them is.
import rows from '../generated/words.json';

export interface Word {
  name: string;
  meaning: string;
  /** Words that may stand beside a code; arguments of a function. */
  rest: string;
}

export const words: Word[] = (rows as [string, string, string][]).map(([name, meaning, rest]) => ({
  name,
  meaning,
  rest,
}));

const known = new Map(words.map((word) => [nameIn(word.name), word]));

// `$pos[axis]` is looked for as $pos, G01 and g1 as G1.
function nameIn(text: string): string {
  const [name = ''] = text.split('[');
  const code = /^([GgMm])0*(\d[\d.]*)$/.exec(name);
  return code === null ? name : `${(code[1] ?? '').toUpperCase()}${code[2] ?? ''}`;
}

/** What a word of a program text is; undefined: none of the language. */
export const wordOf = (text: string): Word | undefined => known.get(nameIn(text));

const inText = /\$\w+|[GgMm]\d+(?:\.\d+)?|[a-z_]\w+/g;

/** The word of the language that stands over a column (from 0) of a line, and where it begins and ends. */
export function wordAt(
  line: string,
  column: number,
): { word: Word; from: number; to: number } | null {
  for (const match of line.matchAll(inText)) {
    const [from, to] = [match.index, match.index + match[0].length];
    if (column < from || column > to) continue;
    const word = wordOf(match[0]);
    if (word !== undefined) return { word, from, to };
  }
  return null;
}
