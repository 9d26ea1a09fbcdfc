// Where a comment begins: by docs/reference/language.md, its table of comments and of how statements begin.
import { expect, test } from 'vitest';
import { isInComment, partsOf } from '../../src/views/programs/g_code';

const commentsOf = (...lines: string[]): string[] =>
  [...partsOf(lines)].filter(([, kind]) => kind === 'comment').map(([text]) => text);

test('a semicolon of a high-level statement begins no comment', () => {
  expect(commentsOf('for (num i = 0; i < 3; i++) {', '  G0 X1', '}')).toEqual([]);
  expect(commentsOf('num depth = 2; num width = 3;')).toEqual([]);
  expect(commentsOf('way(); // there', 'far_away = 5; num other')).toEqual(['// there']);
  expect(commentsOf('num long = 1 +', '  2; num next = 3;')).toEqual([]);
  expect(commentsOf('if (true) { G0 Z50; }')).toEqual([]);
  expect(commentsOf('$feed = 100; G1 X1')).toEqual([]);
  const parts = [...partsOf(['for (num i = 0; i < 3; i++) { G1 X5; }'])];
  expect(parts.filter(([text]) => text === 'G1')).toEqual([['G1', 'keyword']]);
});

test('inside braces a semicolon ends a block, and begins a comment as the first thing on a line', () => {
  expect(commentsOf('if (true) {', '  G0 X1; // there', '  ; a remark', '}')).toEqual([
    '// there',
    '; a remark',
  ]);
});

test('behind a block outside braces it begins a comment', () => {
  expect(commentsOf('G0 X10 ; old style')).toEqual(['; old style']);
  expect(commentsOf('N10 G1 Y2; G0 X1')).toEqual(['; G0 X1']);
  expect(commentsOf('#1 = 5 ; set', 'O100 sub ; begins', 'T1 M6 ; drill')).toHaveLength(3);
  expect(commentsOf('IF [#1 EQ 2] GOTO 10 ; remark', 'WHILE [1] DO1 ; on')).toHaveLength(2);
  expect(commentsOf('  ; first', '%', '(flange)', 'X[2*(3+4)] ; sum')).toEqual([
    '; first',
    '(flange)',
    '; sum',
  ]);
  // Behind the end of braces it is one again, and in a string never.
  expect(commentsOf('if (true) {', '}', 'G0 X1 ; out')).toEqual(['; out']);
  expect(commentsOf('print("a;b"); num c;')).toEqual([]);
  expect(commentsOf('G0 X1 /* a', 'b; */ Y2 ; c')).toEqual(['/*', ' a', 'b; */', '; c']);
});

test('what is written behind a semicolon of a statement is no comment for completion', () => {
  expect(isInComment('for (num i = 0; i < ')).toBe(false);
  expect(isInComment('num a = 1; ')).toBe(false);
  expect(isInComment('G0 X1 ; ')).toBe(true);
  expect(isInComment('// ')).toBe(true);
  expect(isInComment('G0 X1 (about ')).toBe(true);
  expect(isInComment('G0 (about) X')).toBe(false);
});
