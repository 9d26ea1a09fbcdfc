// Texts of programs as the daemon has them, in parts as its messages carry them, and what was written
// in the editor and is not saved yet: it stays when another view is shown, until the page is closed.
import { store } from './machine.svelte';

export interface ProgramText {
  text: string;
  /** By which the daemon tells whether somebody else has changed it meanwhile. */
  version: string;
  /** False: it holds characters of another encoding, which saving would lose. */
  exact: boolean;
}

const partLength = 200_000;
const attemptsAtMost = 5;

/** The whole text, of one version from its first to its last part. */
export async function readProgram(program: string): Promise<ProgramText> {
  for (let attempt = 1; ; ++attempt) {
    const whole = await readParts(program);
    if (whole !== null) return whole;
    if (attempt === attemptsAtMost) throw new Error(`${program} is being written all the time`);
  }
}

// null: it was changed meanwhile.
async function readParts(program: string): Promise<ProgramText | null> {
  let text = '';
  let offset = 0;
  let first: string | null = null;
  let exact = true;
  for (;;) {
    const answer = await store.call('program.read', { program, offset });
    first ??= answer.version;
    if (answer.version !== first) return null;
    text += answer.text;
    exact &&= answer.exact;
    offset += new TextEncoder().encode(answer.text).length;
    if (answer.complete || answer.text === '') return { text, version: answer.version, exact };
  }
}

/** Its new version. `base`: the version that it replaces; null: there is no such program yet. Refused
    when that is no longer so. */
export async function writeProgram(
  program: string,
  text: string,
  base: string | null,
): Promise<string> {
  let version: string | null = null;
  const known = base === null ? {} : { version: base };
  for (const [part, more] of partsOf(text)) {
    ({ version } = await store.call('program.write', { program, text: part, more, ...known }));
  }
  return version ?? '';
}

/** A request has a bound: a long text goes in parts, of which all but the last say that there is more.
    No character is cut in two. */
export function partsOf(text: string): [part: string, more: 0 | 1][] {
  const parts: [string, 0 | 1][] = [];
  for (let from = 0; from < text.length;) {
    let to = Math.min(from + partLength, text.length);
    const last = text.charCodeAt(to - 1);
    if (to < text.length && last >= 0xd800 && last < 0xdc00) to -= 1;
    parts.push([text.slice(from, to), to < text.length ? 1 : 0]);
    from = to;
  }
  return parts.length > 0 ? parts : [['', 0]];
}

/** What is written and not saved: the text, and the version that it is to replace. */
export const drafts = new Map<string, ProgramText>();
