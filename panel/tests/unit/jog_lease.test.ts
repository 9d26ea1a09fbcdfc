// The jog lease: renewed only while pressed, heard and awake; ended by everything else.
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { JogLease, lease_ms, renewal_ms, unansweredAtMost } from '../../src/rpc/jog_lease';
import { noData, ownNumbers, Refusal } from '../../src/rpc/json_rpc';

const motion = { channel: 1, axis: 'X', velocity: 10 };
let jogs: number;
let holds: number;
let may: boolean;
let refusals: unknown[];
let answer: () => Promise<unknown>;
let clock: number;
let lease: JogLease;

async function pass(milliseconds: number): Promise<void> {
  for (let i = 0; i < milliseconds; ++i) {
    clock += 1;
    await vi.advanceTimersByTimeAsync(1);
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  jogs = holds = clock = 0;
  may = true;
  refusals = [];
  answer = () => Promise.resolve();
  lease = new JogLease({
    jog: () => {
      jogs += 1;
      return answer();
    },
    hold: () => {
      holds += 1;
      return Promise.resolve();
    },
    mayGoOn: () => may,
    refused: (error) => refusals.push(error),
    now: () => clock,
  });
});
afterEach(() => vi.useRealTimers());

test('it is renewed well within the lease while it is pressed', async () => {
  lease.press(motion);
  await pass(1000);
  expect(jogs).toBe(1 + Math.floor(1000 / renewal_ms));
  expect(renewal_ms * 2).toBeLessThan(lease_ms);
  expect(holds).toBe(0);
});

test('letting go holds at once and sends nothing any more', async () => {
  lease.press(motion);
  await pass(100);
  const sent = jogs;
  lease.release();
  expect(holds).toBe(1);
  await pass(1000);
  expect(jogs).toBe(sent);
  lease.release();
  expect(holds).toBe(1);
});

const numbers = (): unknown[] => refusals.map((one) => (one instanceof Refusal ? one.number : one));

test('it goes on behind a connection with 85 ms each way, and holds when it is let go', async () => {
  const arrivals: number[] = [];
  answer = async () => {
    await new Promise((resolve) => setTimeout(resolve, 85));
    arrivals.push(clock);
    await new Promise((resolve) => setTimeout(resolve, 85));
  };
  lease.press(motion);
  await pass(2000);
  expect(lease.motion).not.toBeNull();
  const gaps = arrivals.slice(1).map((at, i) => at - (arrivals[i] ?? 0));
  expect(arrivals.length).toBeGreaterThan(20);
  expect(Math.max(...gaps)).toBeLessThan(lease_ms);
  lease.release();
  expect(holds).toBe(1);
  expect(refusals).toEqual([]);
});

test('few wait in a connection that hangs, it says so, and late answers do not begin it again', async () => {
  const late: ((value: unknown) => void)[] = [];
  answer = () => new Promise((resolve) => late.push(resolve));
  lease.press(motion);
  await pass(1000);
  expect(jogs).toBe(unansweredAtMost);
  expect((unansweredAtMost - 1) * renewal_ms).toBeLessThanOrEqual(lease_ms);
  expect(lease.motion).toBeNull();
  expect(holds).toBe(1);
  expect(numbers()).toEqual([ownNumbers.jogLate]);
  for (const one of late) one(null);
  await pass(1000);
  expect(jogs).toBe(unansweredAtMost);
  expect(refusals).toHaveLength(1);
});

test('a refusal that comes after it was let go is shown, and the next press goes on', async () => {
  answer = () =>
    new Promise((_, reject) => setTimeout(() => reject(new Error('no')), 2.5 * renewal_ms));
  lease.press(motion);
  await pass(100);
  lease.release();
  answer = () => Promise.resolve();
  lease.press({ ...motion, axis: 'Y' });
  await pass(500);
  expect(refusals).toEqual([new Error('no')]);
  expect(lease.motion?.axis).toBe('Y');
  lease.release();
});

test('a page that slept for longer than the lease does not go on', async () => {
  lease.press(motion);
  await pass(100);
  const sent = jogs;
  clock += 500;
  await pass(renewal_ms);
  expect(jogs).toBe(sent);
  expect(lease.motion).toBeNull();
  expect(numbers()).toEqual([ownNumbers.jogLate]);
});

test('focus, tab or connection gone: no renewal, and no press', async () => {
  lease.press(motion);
  await pass(100);
  may = false;
  const sent = jogs;
  await pass(500);
  expect(jogs).toBe(sent);
  expect(holds).toBe(1);
  lease.press(motion);
  expect(jogs).toBe(sent);
});

test('a refusal ends it and is shown once', async () => {
  answer = () => Promise.reject(new Error('no'));
  lease.press(motion);
  await pass(500);
  expect(jogs).toBe(1);
  expect(refusals).toHaveLength(1);
  expect(holds).toBe(0);
});

test('another axis ends the first', async () => {
  lease.press(motion);
  lease.press({ ...motion, axis: 'Y' });
  expect(holds).toBe(1);
  expect(lease.motion?.axis).toBe('Y');
  lease.release();
});

// The hold of one's own release overtakes a renewal that is under way: no news for whoever let go.
test('a renewal that the own stop has overtaken is not told', async () => {
  let refuse: (error: unknown) => void = () => undefined;
  lease.press(motion);
  await pass(10);
  answer = () => new Promise((_, reject) => (refuse = reject));
  await pass(100);
  lease.release();
  refuse(new Refusal(0, '', { ...noData, code: 'E6072' }));
  await pass(1);
  expect(refusals).toEqual([]);
});

test('a stop by somebody else is told', async () => {
  lease.press(motion);
  answer = () => Promise.reject(new Refusal(0, '', { ...noData, code: 'E6072' }));
  await pass(100);
  expect(refusals).toHaveLength(1);
});
