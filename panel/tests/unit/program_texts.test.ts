// Texts of programs in parts: one version from first to last, no character cut, no foreign change lost.
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { partsOf, readProgram, writeProgram } from '../../src/stores/program_texts';
import { store } from '../../src/stores/machine.svelte';

type Asked = Record<string, unknown>;
let asked: Asked[];
let answers: object[];

beforeEach(() => {
  asked = [];
  answers = [];
  vi.spyOn(store, 'call').mockImplementation(((_: string, params: Asked) => {
    asked.push(params);
    return Promise.resolve(answers.shift());
  }) as unknown as typeof store.call);
});
afterEach(() => vi.restoreAllMocks());

const part = (text: string, version: string, complete: boolean, exact = true): object => ({
  text,
  version,
  complete,
  exact,
});

test('parts are put together; the next one begins behind the bytes of those before', async () => {
  answers = [part('G1 Ж\n', 'a', false), part('M30\n', 'a', true)];
  expect(await readProgram('x.nc')).toEqual({ text: 'G1 Ж\nM30\n', version: 'a', exact: true });
  expect(asked.map((one) => one['offset'])).toEqual([0, 6]);
});

test('a program that is changed between two parts is read from its beginning', async () => {
  answers = [part('old', 'a', false), part('new', 'b', true)];
  answers.push(part('ne', 'b', false), part('w', 'b', true));
  expect(await readProgram('x.nc')).toMatchObject({ text: 'new', version: 'b' });
});

test('one part that is not exact makes the text inexact', async () => {
  answers = [part('(\uFFFD)', 'a', false, false), part('M30', 'a', true)];
  expect((await readProgram('x.nc')).exact).toBe(false);
});

test('no part ends within a character', () => {
  const text = 'a' + '\u{1F6E0}'.repeat(150_000);
  const parts = partsOf(text);
  expect(parts.length).toBeGreaterThan(1);
  expect(parts.map(([one]) => one).join('')).toBe(text);
  // Half a character cannot be encoded.
  for (const [one] of parts) expect(() => encodeURI(one)).not.toThrow();
  expect(parts.map(([, more]) => more).slice(-2)).toEqual([1, 0]);
});

test('what is written says which version it replaces, or that there is none yet', async () => {
  answers = [{ version: 'b' }, { version: 'c' }];
  expect(await writeProgram('x.nc', 'M30', 'a')).toBe('b');
  expect(asked[0]).toEqual({ program: 'x.nc', text: 'M30', more: 0, version: 'a' });
  await writeProgram('x.nc', 'M30', null);
  expect(asked[1]).toEqual({ program: 'x.nc', text: 'M30', more: 0 });
});
