// Tools and offsets: what is sent, and what taking a change back refuses.
import { beforeEach, expect, test, vi } from 'vitest';

vi.stubGlobal('navigator', { language: 'en' });
const { spoken } = await import('../../src/stores/spoken.svelte');
const { Question, Refusal, noData } = await import('../../src/rpc/json_rpc');
const { refusals, attempt } = await import('../../src/stores/refusal.svelte');
const { store } = await import('../../src/stores/machine.svelte');
const { tables } = await import('../../src/stores/tables.svelte');

let x: number;
/** Above it a value wants to be confirmed. */
const likely = 1000;
let sent: Record<string, unknown>[];

beforeEach(async () => {
  await spoken.speak('en');
  x = 10;
  sent = [];
  tables.changes = [];
  refusals.clear();
  vi.stubGlobal('window', { innerHeight: 800 });
  vi.stubGlobal('document', { body: { getBoundingClientRect: () => ({}) } });
  vi.spyOn(store, 'call').mockImplementation(((
    method: string,
    params: { value?: number; confirmed?: number } = {},
  ) => {
    const { value = 0, confirmed = 0 } = params;
    if (method.endsWith('.set')) {
      sent.push({ method, ...params });
      if (Math.abs(value) > likely && confirmed === 0)
        return Promise.reject(new Refusal(-32001, 'too large', { ...noData, code: 'E6095' }));
    }
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

test('a value that is not likely is a question, and yes sends it again, confirmed', async () => {
  await expect(tables.setOffset('G54', 'X', 5000)).rejects.toBeInstanceOf(Question);
  expect(await attempt(null, () => tables.setOffset('G54', 'X', 5000))).toBe(false);
  expect(refusals.shown).toMatchObject({ code: 'E6095', sentence: 'too large' });
  expect([x, tables.changes]).toEqual([10, []]);
  await refusals.shown?.again?.();
  expect(sent.at(-1)).toEqual({
    method: 'offset.set',
    offset: 'G54',
    axis: 'X',
    value: 5000,
    confirmed: 1,
  });
  expect(refusals.shown).toBeNull();
  expect(x).toBe(5000);
  expect(tables.changes[0]).toMatchObject({ what: 'G54 X', from: 10, to: 5000 });
});

test('a question that nobody answers with yes changes nothing', async () => {
  await attempt(null, () => tables.setOffset('G54', 'X', 5000));
  refusals.clear();
  expect([x, sent.length, tables.changes]).toEqual([10, 1, []]);
});

test('tools are asked about likewise, and so is what is taken back', async () => {
  const tool = { number: 3, edge: 1 } as unknown as import('../../src/stores/tables.svelte').Tool;
  await attempt(null, () => tables.setTool(tool, 'length', 9999));
  await refusals.shown?.again?.();
  expect(sent.at(-1)).toMatchObject({ method: 'tool.set', value: 9999, confirmed: 1 });
  x = 3000;
  await tables.read();
  await tables.setOffset('G54', 'X', 25);
  await attempt(null, () => tables.undo());
  expect(x).toBe(25);
  await refusals.shown?.again?.();
  expect(x).toBe(3000);
  expect(tables.changes).toHaveLength(1);
});

test('another refusal is none', async () => {
  vi.mocked(store.call).mockRejectedValueOnce(
    new Refusal(-32001, 'no such axis', { ...noData, code: 'E9003' }),
  );
  await attempt(null, () => tables.setOffset('G54', 'X', 5));
  expect(refusals.shown).toMatchObject({ sentence: 'no such axis', again: null });
});
