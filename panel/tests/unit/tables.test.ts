// Tools and offsets: what is sent, and what taking a change back refuses.
import { beforeEach, expect, test, vi } from 'vitest';

vi.stubGlobal('navigator', { language: 'en' });
const { spoken } = await import('../../src/stores/spoken.svelte');
const { store } = await import('../../src/stores/machine.svelte');
const { tables } = await import('../../src/stores/tables.svelte');

let x: number;

beforeEach(async () => {
  await spoken.speak('en');
  x = 10;
  tables.changes = [];
  vi.spyOn(store, 'call').mockImplementation(((
    method: string,
    { value = 0 }: { value?: number } = {},
  ) => {
    if (method === 'offset.set') x = value;
    // In the order of a table that knows more than the nine of every machine.
    const offsets = { G54: { X: x }, 'G54.1P1': { X: 0 }, G55: { X: 0 } };
    return Promise.resolve({ tools: [], axes: ['X'], offsets });
  }) as unknown as typeof store.call);
  await tables.read();
});

test('a change is taken back to what was there', async () => {
  await tables.setOffset('G54', 'X', 25);
  expect(x).toBe(25);
  await tables.undo();
  expect(x).toBe(10);
  expect(tables.changes).toEqual([]);
});

test('what somebody else has set since stays', async () => {
  await tables.setOffset('G54', 'X', 25);
  x = 31;
  await expect(tables.undo()).rejects.toThrow('changed by somebody else');
  expect(x).toBe(31);
  expect(tables.changes).toHaveLength(1);
});
