// Touching off: what is sent, what is asked about, and what is told when something has changed since.
import { beforeEach, expect, test, vi } from 'vitest';

vi.stubGlobal('navigator', { language: 'en' });
const { spoken } = await import('../../src/stores/spoken.svelte');
const { Refusal, noData } = await import('../../src/rpc/json_rpc');
const { store } = await import('../../src/stores/machine.svelte');
const { tables } = await import('../../src/stores/tables.svelte');
const { touchOff } = await import('../../src/stores/touch_off.svelte');
type Channel = import('../../src/stores/machine.svelte').Channel;

const lathe = {
  id: 1,
  words: ['X', 'Z', 'C'],
  axis_names: ['X', 'Z', 'C1'],
  diameter: ['X'],
  units: 'mm',
  situation: 12,
} as unknown as Channel;

let sent: Record<string, unknown>[];
let undone: unknown[];
let refused: string[];
let values: Record<string, number>;

beforeEach(async () => {
  await spoken.speak('en');
  [sent, undone, refused, values] = [[], [], [], { X: 1, Z: 2, C1: 3 }];
  tables.changes = [];
  touchOff.leave();
  store.channels = [lathe];
  vi.spyOn(store, 'call').mockImplementation(((
    method: string,
    params: Record<string, unknown> = {},
  ) => {
    if (method === 'offset.touch') {
      sent.push(params);
      const code = refused.shift();
      if (code !== undefined)
        return Promise.reject(new Refusal(-32000, `says ${code}`, { ...noData, code }));
      const axis = params['axis'] === 'C' ? 'C1' : String(params['axis']);
      const old = values[axis] ?? 0;
      values = { ...values, [axis]: 40 };
      return Promise.resolve({ old, new: 40, undo: 7 });
    }
    if (method === 'offset.undo') {
      undone.push(params['undo']);
      values = { ...values, Z: 2 };
      return Promise.resolve({ old: 40, new: 2 });
    }
    return Promise.resolve({ tools: [], axes: ['X', 'Z', 'C1'], offsets: { G54: values } });
  }) as unknown as typeof store.call);
  await tables.read();
});

test('along a diameter the value is one, in the situation that was looked at', async () => {
  touchOff.look(lathe);
  await touchOff.touch({ ...lathe, situation: 13 }, 'G54', 'X', '60');
  await touchOff.touch({ ...lathe, situation: 13 }, 'G54', 'Z', '-2,5');
  expect(sent).toEqual([
    { channel: 1, offset: 'G54', axis: 'X', value: 60, as: 'diameter', situation: 12 },
    { channel: 1, offset: 'G54', axis: 'Z', value: -2.5, situation: 13 },
  ]);
});

test('inches become millimetres, degrees stay', async () => {
  const inches = { ...lathe, units: 'inch' };
  await touchOff.touch(inches, 'G54', 'Z', '10');
  await touchOff.touch(inches, 'G54', 'C', '10');
  expect(sent.map(({ value }) => value)).toEqual([254, 10]);
  expect(tables.changes[0]).toMatchObject({ what: 'G54 C1', from: 3, to: 40 });
});

test('what is no number is not sent', async () => {
  await expect(touchOff.touch(lathe, 'G54', 'Z', '')).rejects.toThrow();
  expect(sent).toEqual([]);
});

test('the newest one can be taken back, as long as it is the newest', async () => {
  await touchOff.touch(lathe, 'G54', 'Z', '0');
  expect(touchOff.done).toMatchObject({ what: 'G54 Z', from: 2, to: 40 });
  await tables.setOffset('G54', 'X', 5);
  expect(touchOff.done).toBeNull();
  tables.changes = tables.changes.slice(1);
  await tables.undo();
  expect(undone).toEqual([7]);
  expect(touchOff.done).toBeNull();
});

test.each(['E6093', 'E6095'])(
  'what is large is asked about (%s) and sent again, confirmed',
  async (code) => {
    refused = [code];
    await touchOff.touch(lathe, 'G54', 'Z', '500');
    expect(touchOff.question).toBe(`says ${code}`);
    expect(touchOff.done).toBeNull();
    await touchOff.confirm();
    expect(sent[1]).toEqual({ ...sent[0], confirmed: 1 });
    expect(touchOff.question).toBeNull();
    expect(touchOff.done).toMatchObject({ what: 'G54 Z' });
  },
);

test('a question that is answered with no sends nothing', async () => {
  refused = ['E6093'];
  await touchOff.touch(lathe, 'G54', 'Z', '500');
  touchOff.forget();
  await touchOff.confirm();
  expect(sent).toHaveLength(1);
});

test('when something has changed since, it says so; the next press has the new numbers', async () => {
  refused = ['E6090'];
  touchOff.look(lathe);
  await touchOff.touch({ ...lathe, situation: 13 }, 'G54', 'Z', '0');
  expect(touchOff.hasChanged).toBe(true);
  await touchOff.touch({ ...lathe, situation: 13 }, 'G54', 'Z', '0');
  expect(sent.map(({ situation }) => situation)).toEqual([12, 13]);
  expect(touchOff.hasChanged).toBe(false);
});

test('other refusals are those of the button', async () => {
  refused = ['E6092'];
  await expect(touchOff.touch(lathe, 'G54', 'Z', '0')).rejects.toThrow('says E6092');
  expect(touchOff.question).toBeNull();
});
