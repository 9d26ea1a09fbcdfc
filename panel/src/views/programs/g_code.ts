// How a program text is read for its colours: words, statements, strings, comments.
//
// A `;` begins a comment as the first thing on a line, and behind a block outside braces; elsewhere it ends a
// statement (docs/reference/language.md).
import { StreamLanguage, StringStream } from '@codemirror/language';

const statements =
  /^(if|else|while|do|for|return|break|continue|switch|case|default|end|endif|goto|true|false|var|const|shared|num|axis|string|bool|void)\b/;

// Parentheses are comments at the begin of a line and behind words like X10; elsewhere they calculate.
const beforeComment = /(^|%|[A-Za-z][-+.\d]+|\))\s*$/;

// What a statement is by how it begins: blocks, directives, O-lines and macro lines end with their line, high-level
// statements with `;` or a brace.
const skipped = /^([Nn]\d|\/\d?)/;
const block = /^([A-Za-z](?![A-Za-z_])|#|(IF|WHILE)\s*\[|(DO|END)\s*\d|GOTO\b)/i;
const highLevel = /^[A-Za-z_$]/;

interface Reading {
  inComment: boolean;
  statement: 'none' | 'block' | 'high_level';
  braces: number;
  parentheses: number;
}

function begin(stream: StringStream, state: Reading): void {
  if (state.statement !== 'none' || stream.match(skipped, false)) return;
  if (stream.match(block, false)) state.statement = 'block';
  else if (stream.match(highLevel, false)) state.statement = 'high_level';
}

function end(state: Reading): void {
  state.statement = 'none';
  state.parentheses = 0;
}

function isRemark(stream: StringStream, state: Reading): boolean {
  if (stream.string.slice(0, stream.pos).trim() === '') return true;
  return state.braces === 0 && state.statement !== 'high_level';
}

function punctuation(stream: StringStream, state: Reading): null {
  const mark = stream.next();
  if (mark === '{') state.braces += 1;
  if (mark === '}') state.braces = Math.max(0, state.braces - 1);
  if (mark === '(') state.parentheses += 1;
  if (mark === ')') state.parentheses = Math.max(0, state.parentheses - 1);
  if (mark === '{' || mark === '}' || (mark === ';' && state.parentheses === 0)) end(state);
  return null;
}

const reader = {
  startState: (): Reading => ({
    inComment: false,
    statement: 'none',
    braces: 0,
    parentheses: 0,
  }),
  token(stream: StringStream, state: Reading): string | null {
    if (stream.sol() && state.statement === 'block') end(state);
    if (state.inComment) {
      if (stream.skipTo('*/')) stream.match('*/');
      else stream.skipToEnd();
      state.inComment = !stream.string.slice(0, stream.pos).endsWith('*/');
      return 'comment';
    }
    if (stream.eatSpace()) return null;
    if (stream.match('/*')) {
      state.inComment = true;
      return 'comment';
    }
    if (stream.match('//') || (stream.peek() === ';' && isRemark(stream, state))) {
      stream.skipToEnd();
      return 'comment';
    }
    if (stream.peek() === '(' && beforeComment.test(stream.string.slice(0, stream.pos))) {
      if (stream.match(/^\([^()]*\)/)) return 'comment';
    }
    begin(stream, state);
    if (stream.match(/^"(\\.|[^"\\])*"?/)) return 'string';
    if (stream.match(/^#\w+/)) return 'meta';
    if (stream.match(statements)) return 'keyword';
    if (stream.match(/^[Nn]\d+/)) return 'labelName';
    if (stream.match(/^[GMgm]\d+(\.\d+)?/)) return 'keyword';
    if (stream.match(/^[A-Za-z_]\w{2,}/)) return 'variableName';
    if (stream.match(/^[A-Za-z](?=[-+.\d= ])/)) return 'propertyName';
    if (stream.match(/^\d*\.?\d+/)) return 'number';
    return punctuation(stream, state);
  },
};

export const gCode = StreamLanguage.define({ name: 'g-code', ...reader });

/** The parts of some lines with what they are, as the editor reads them. */
export function* partsOf(lines: readonly string[]): Generator<[text: string, kind: string | null]> {
  const state = reader.startState();
  for (const line of lines) {
    for (const stream = new StringStream(line, 2, 2); !stream.eol(); stream.start = stream.pos) {
      const kind = reader.token(stream, state);
      yield [stream.current(), kind];
    }
  }
}

/** Whether a comment has begun in a part of a line and has not ended. */
export function isInComment(text: string): boolean {
  const [last, kind] = [...partsOf([text])].at(-1) ?? ['', null];
  if (kind === 'comment') return !/^\(|\*\/$/.test(last);
  const open = text.lastIndexOf('(');
  return open > text.lastIndexOf(')') && beforeComment.test(text.slice(0, open));
}
