// The editor of program texts: CodeMirror in a tree of its own, so that its styles are adopted sheets
// and the page keeps a content policy without inline styles.
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, setDiagnostics, type Diagnostic as Mark } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { EditorState, StateEffect, StateField, type Text } from '@codemirror/state';
import {
  Decoration,
  EditorView,
  highlightActiveLine,
  keymap,
  lineNumbers,
  type DecorationSet,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';
import type { Result } from '../../rpc/json_rpc';
import { gCode } from './g_code';
import { hints } from './hints';

export type Diagnostic = Result<'program.check'>['diagnostics'][number];

const colours = HighlightStyle.define([
  { tag: tags.comment, color: 'var(--text-quiet)', fontStyle: 'italic' },
  { tag: tags.keyword, color: 'var(--running)', fontWeight: '600' },
  { tag: tags.string, color: 'var(--attention)' },
  { tag: tags.meta, color: 'var(--attention)' },
  { tag: tags.labelName, color: 'var(--text-quiet)' },
]);

const look = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--raised)' },
  '.cm-scroller': { fontFamily: 'var(--font-code)', lineHeight: '1.5', overflow: 'auto' },
  '.cm-gutters': {
    backgroundColor: 'var(--surface)',
    color: 'var(--text-quiet)',
    borderRight: '1px solid var(--line)',
  },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--surface)' },
  '.cm-running': { backgroundColor: 'var(--running-ground)', fontWeight: '700' },
  '.cm-tooltip': { backgroundColor: 'var(--raised)', color: 'var(--text)', padding: '0.25rem' },
  '.cm-tooltip-autocomplete > ul > li': { minHeight: '1.75rem' },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    backgroundColor: 'var(--text)',
    color: 'var(--surface)',
  },
  '.cm-completionDetail': { color: 'inherit', fontStyle: 'normal' },
  // The marks of the package are images in the style sheet, which the page's content policy forbids.
  '.cm-lint-marker-error': { content: "'▲'", color: 'var(--alarm)' },
  '.cm-lint-marker-warning': { content: "'●'", color: 'var(--attention)' },
  '.cm-lint-marker-info': { content: "'●'", color: 'var(--running)' },
  '.cm-lintRange-error, .cm-lintRange-warning, .cm-lintRange-info, .cm-lintRange-active': {
    backgroundImage: 'none',
    textDecoration: 'underline wavy',
    textDecorationColor: 'var(--alarm)',
  },
  '.cm-panels': { backgroundColor: 'var(--surface)', color: 'var(--text)' },
});

const setRunning = StateEffect.define<number>();
const runningLine = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    let next = marks.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (effect.is(setRunning)) next = lineMark(transaction.state.doc, effect.value);
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

function lineMark(text: Text, line: number): DecorationSet {
  if (line < 1 || line > text.lines) return Decoration.none;
  return Decoration.set([Decoration.line({ class: 'cm-running' }).range(text.line(line).from)]);
}

function place(text: Text, line: number, column: number): number {
  const found = text.line(Math.min(Math.max(line, 1), text.lines));
  return Math.min(found.from + Math.max(column - 1, 0), found.to);
}

const severities: Record<string, Mark['severity']> = { error: 'error', warning: 'warning' };

/** Diagnostics count lines and columns from 1; an end that lies before its beginning is that of the line. */
export function marksOf(text: Text, diagnostics: Diagnostic[]): Mark[] {
  return diagnostics.map((one) => {
    const from = place(text, one.line, one.column);
    const end = place(text, one.end_line, one.end_column);
    const lineEnd = text.line(Math.min(Math.max(one.line, 1), text.lines)).to;
    const message = [`${one.code}: ${one.message}`, ...one.help].join('\n');
    const severity = severities[one.severity] ?? 'info';
    return { from, to: end > from ? end : lineEnd, severity, message };
  });
}

export class ProgramEditor {
  readonly #view: EditorView;
  // Saved lines end as those did that were read.
  #lineEnd = '\n';

  constructor(place: HTMLElement, label: string, changed: () => void) {
    const root = place.shadowRoot ?? place.attachShadow({ mode: 'open' });
    const state = EditorState.create({
      extensions: [
        lineNumbers(),
        history(),
        highlightActiveLine(),
        highlightSelectionMatches(),
        search({ top: true }),
        keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap]),
        gCode,
        syntaxHighlighting(colours),
        lintGutter(),
        hints,
        runningLine,
        look,
        EditorView.contentAttributes.of({ 'aria-label': label }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !update.transactions.some((one) => one.isUserEvent('load'))) {
            changed();
          }
        }),
      ],
    });
    this.#view = new EditorView({ state, parent: root, root });
    // What scrolls can be reached without a mouse.
    this.#view.scrollDOM.tabIndex = 0;
  }

  get text(): string {
    const { doc } = this.#view.state;
    return doc.sliceString(0, doc.length, this.#lineEnd);
  }

  show(text: string): void {
    const { doc } = this.#view.state;
    this.#lineEnd = text.includes('\r\n') ? '\r\n' : '\n';
    this.#view.dispatch({
      changes: { from: 0, to: doc.length, insert: text },
      userEvent: 'load',
    });
    this.mark([]);
  }

  mark(diagnostics: Diagnostic[]): void {
    const { state } = this.#view;
    this.#view.dispatch(setDiagnostics(state, marksOf(state.doc, diagnostics)));
  }

  run(line: number): void {
    this.#view.dispatch({ effects: setRunning.of(line) });
  }

  goTo(line: number): void {
    const at = place(this.#view.state.doc, line, 1);
    this.#view.dispatch({
      selection: { anchor: at },
      effects: EditorView.scrollIntoView(at, { y: 'center' }),
    });
    this.#view.focus();
  }

  /** The line of the cursor. */
  get line(): number {
    const { state } = this.#view;
    return state.doc.lineAt(state.selection.main.head).number;
  }

  close(): void {
    this.#view.destroy();
  }
}
