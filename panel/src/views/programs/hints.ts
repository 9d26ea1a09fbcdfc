// What the editor says of the words of the language: on hover, and while they are written.
import {
  autocompletion,
  type CompletionContext,
  type CompletionResult,
} from '@codemirror/autocomplete';
import { hoverTooltip, type EditorView, type Tooltip } from '@codemirror/view';
import { wordAt, words, type Word } from '../../stores/words';
import { isInComment } from './g_code';

const options = words.map(({ name, meaning, rest }) => ({
  label: name.replace('[axis]', '').replace('[num]', ''),
  detail: rest,
  info: meaning,
  type: /^[GM]\d/.test(name) ? 'keyword' : 'function',
}));

export function completions(context: CompletionContext): CompletionResult | null {
  const line = context.state.doc.lineAt(context.pos);
  const before = line.text.slice(0, context.pos - line.from);
  const found = /(\$\w*|[GgMm]\d*\.?\d*|[a-z_]\w+)$/.exec(before);
  if (found === null || isInComment(before.slice(0, found.index))) return null;
  const [text] = found;
  // A letter alone begins an axis word as well: it is offered when somebody asks.
  if (text.length < 2 && !context.explicit) return null;
  return { from: context.pos - text.length, options, validFor: /^[$\w.]*$/ };
}

function shown({ name, meaning, rest }: Word): HTMLElement {
  const place = document.createElement('div');
  const title = document.createElement('strong');
  title.textContent = name;
  place.append(title, ` ${meaning}`, ...(rest === '' ? [] : [document.createElement('br'), rest]));
  return place;
}

export function hint(view: EditorView, position: number): Tooltip | null {
  const line = view.state.doc.lineAt(position);
  const found = wordAt(line.text, position - line.from);
  if (found === null) return null;
  return {
    pos: line.from + found.from,
    end: line.from + found.to,
    above: true,
    create: () => ({ dom: shown(found.word) }),
  };
}

export const hints = [
  autocompletion({ override: [completions], icons: false }),
  hoverTooltip(hint, { hoverTime: 400 }),
];
