// Texts of programs as the daemon has them, read once and kept for the page's life.
import { store } from './machine.svelte';

export interface ProgramText {
  text: string;
  version: string;
  lines: string[];
}

const linesShownAtMost = 300_000;
const partLength = 200_000;

class ProgramTexts {
  #texts = $state.raw<Record<string, ProgramText>>({});

  get(program: string): ProgramText | undefined {
    return this.#texts[program];
  }

  async read(program: string): Promise<ProgramText> {
    return this.#keep(program, ...(await readWhole(program)));
  }

  /** Refused when somebody else has changed the program since it was read here. */
  async write(program: string, text: string): Promise<void> {
    const before = this.#texts[program]?.version;
    let version: string | null = null;
    for (const [part, more] of partsOf(text)) {
      const params = {
        program,
        text: part,
        more,
        ...(before === undefined ? {} : { version: before }),
      };
      ({ version } = await store.call('program.write', params));
    }
    this.#keep(program, text, version ?? '');
  }

  #keep(program: string, text: string, version: string): ProgramText {
    const lines = text.split(/\r?\n/, linesShownAtMost);
    const entry = { text, version, lines };
    this.#texts = { ...this.#texts, [program]: entry };
    return entry;
  }
}

async function readWhole(program: string): Promise<[text: string, version: string]> {
  let text = '';
  let offset = 0;
  for (;;) {
    const answer = await store.call('program.read', { program, offset });
    text += answer.text;
    offset += new TextEncoder().encode(answer.text).length;
    if (answer.complete || answer.text === '') return [text, answer.version];
  }
}

// A request has a bound: a long text goes in parts, of which all but the last say that there is more.
function partsOf(text: string): [part: string, more: 0 | 1][] {
  const parts: [string, 0 | 1][] = [];
  for (let from = 0; from < text.length; from += partLength) {
    parts.push([text.slice(from, from + partLength), from + partLength < text.length ? 1 : 0]);
  }
  return parts.length > 0 ? parts : [['', 0]];
}

export const programTexts = new ProgramTexts();
