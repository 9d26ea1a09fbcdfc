// How a program text is read for its colours: words, statements, strings, comments.
import { StreamLanguage } from '@codemirror/language';

const statements =
  /^(if|else|while|do|for|return|break|continue|switch|case|default|end|endif|goto|true|false|var|const|shared|int|double|string|bool|void)\b/;

// Parentheses are comments at the begin of a line and behind words like X10; elsewhere they calculate.
const beforeComment = /(^|%|[A-Za-z][-+.\d]+|\))\s*$/;

export const gCode = StreamLanguage.define({
  name: 'g-code',
  startState: () => ({ inComment: false }),
  token(stream, state) {
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
    if (stream.match('//') || stream.match(';')) {
      stream.skipToEnd();
      return 'comment';
    }
    if (stream.peek() === '(' && beforeComment.test(stream.string.slice(0, stream.pos))) {
      if (stream.match(/^\([^()]*\)/)) return 'comment';
    }
    if (stream.match(/^"(\\.|[^"\\])*"?/)) return 'string';
    if (stream.match(/^#\w+/)) return 'meta';
    if (stream.match(statements)) return 'keyword';
    if (stream.match(/^[Nn]\d+/)) return 'labelName';
    if (stream.match(/^[GMgm]\d+(\.\d+)?/)) return 'keyword';
    if (stream.match(/^[A-Za-z_]\w{2,}/)) return 'variableName';
    if (stream.match(/^[A-Za-z](?=[-+.\d= ])/)) return 'propertyName';
    if (stream.match(/^\d*\.?\d+/)) return 'number';
    stream.next();
    return null;
  },
});

/** Whether a comment has begun in a part of a line and has not ended. */
export function isInComment(text: string): boolean {
  if (/(^|\s)(;|\/\/)/.test(text)) return true;
  const open = text.lastIndexOf('(');
  return open > text.lastIndexOf(')') && beforeComment.test(text.slice(0, open));
}
