import { CompletionContext } from '@codemirror/autocomplete';
import { EditorState } from '@codemirror/state';
import { describe, expect, test } from 'vitest';
import { wordAt, wordOf } from '../../src/stores/words';
import { completions } from '../../src/views/programs/hints';

describe('words of the language', () => {
  test('are found however their numbers are written', () => {
    expect(wordOf('G1')?.meaning).toBe('line at feed');
    expect(wordOf('g01')?.name).toBe('G1');
    expect(wordOf('M030')?.name).toBe('M30');
    expect(wordOf('G0')?.meaning).toBe('rapid');
    expect(wordOf('G00')?.meaning).toBe('rapid');
    expect(wordOf('X20')).toBeUndefined();
    expect(wordOf('$pos')?.name).toBe('$pos[axis]');
  });

  test('are found under a column of a line', () => {
    const line = 'N10 G2X0 I-5 $pos[X] hypot(3, 4)';
    expect(wordAt(line, 4)?.word.name).toBe('G2');
    expect(wordAt(line, 5)).toMatchObject({ from: 4, to: 6 });
    expect(wordAt(line, 14)?.word.name).toBe('$pos[axis]');
    expect(wordAt(line, 22)?.word.name).toBe('hypot');
    expect(wordAt(line, 10)).toBeNull();
  });
});

describe('completion', () => {
  const offered = (text: string, explicit = false): string[] => {
    const state = EditorState.create({ doc: text });
    const result = completions(new CompletionContext(state, text.length, explicit));
    return (result?.options ?? []).map((one) => one.label);
  };

  test('offers codes, functions and variables', () => {
    expect(offered('X1 G4')).toContain('G41');
    expect(offered('if (hy')).toContain('hypot');
    expect(offered('X = hy')).toContain('hypot');
    expect(offered('X = $po')).toContain('$pos');
  });

  test('is silent in comments, and behind a letter alone until it is asked for', () => {
    expect(offered('; G4')).toEqual([]);
    expect(offered('(about G4')).toEqual([]);
    expect(offered('G')).toEqual([]);
    expect(offered('G', true)).toContain('G0');
  });
});
