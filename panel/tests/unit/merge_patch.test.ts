// The table of RFC 7396, appendix A, and that what is not named keeps its identity.
import { expect, test } from 'vitest';
import { mergePatch, type Json } from '../../src/rpc/merge_patch';

const cases: [Json, Json, Json][] = [
  [{ a: 'b' }, { a: 'c' }, { a: 'c' }],
  [{ a: 'b' }, { b: 'c' }, { a: 'b', b: 'c' }],
  [{ a: 'b' }, { a: null }, {}],
  [{ a: 'b', b: 'c' }, { a: null }, { b: 'c' }],
  [{ a: ['b'] }, { a: 'c' }, { a: 'c' }],
  [{ a: 'c' }, { a: ['b'] }, { a: ['b'] }],
  [{ a: { b: 'c' } }, { a: { b: 'd', c: null } }, { a: { b: 'd' } }],
  [{ a: [{ b: 'c' }] }, { a: [1] }, { a: [1] }],
  [
    ['a', 'b'],
    ['c', 'd'],
    ['c', 'd'],
  ],
  [{ a: 'b' }, ['c'], ['c']],
  [{ a: 'foo' }, null, null],
  [{ a: 'foo' }, 'bar', 'bar'],
  [{ e: null }, { a: 1 }, { e: null, a: 1 }],
  [[1, 2], { a: 'b', c: null }, { a: 'b' }],
  [{}, { a: { bb: { ccc: null } } }, { a: { bb: {} } }],
];

test.each(cases)('%j with %j is %j', (target, patch, result) => {
  expect(mergePatch(target, patch)).toEqual(result);
});

test('what a patch does not name keeps its identity, and the target is not changed', () => {
  const target = { machine: { cycle: 1 }, channels: { '1': { line: 3 }, '2': { line: 9 } } };
  const merged = mergePatch(target, { channels: { '1': { line: 4 } } }) as typeof target;
  expect(merged.channels['1'].line).toBe(4);
  expect(target.channels['1'].line).toBe(3);
  expect(merged.machine).toBe(target.machine);
  expect(merged.channels['2']).toBe(target.channels['2']);
});
