// When something happened and how a run ended: by the clock where the daemon says it, else as far as it does.
import { beforeEach, expect, test, vi } from 'vitest';

vi.stubGlobal('navigator', { language: 'en' });
const { dateAndTime, duration } = await import('../../src/stores/format');
const { endOf, lostPeriodsOf, whenOf } = await import('../../src/stores/happened');
const { store } = await import('../../src/stores/machine.svelte');
const { spoken } = await import('../../src/stores/spoken.svelte');
type Run = import('../../src/stores/happened').Run;

const noon_s = new Date(2026, 2, 1, 12, 5, 9).getTime() / 1000;

beforeEach(async () => {
  await spoken.speak('en');
  store.machine = { cycle_us: 2000 } as typeof store.machine;
});

test('by the clock on the wall, of this time zone', () => {
  expect(dateAndTime(noon_s)).toBe('2026-03-01 12:05:09');
  expect(dateAndTime(noon_s + 0.9)).toBe('2026-03-01 12:05:09');
  expect(whenOf(noon_s, 37_500)).toBe('2026-03-01 12:05:09');
});

test.each([null, undefined])('a daemon that does not say it (%s) has its cycles', (at) => {
  expect(whenOf(at, 37_500)).toBe(duration(75));
  expect(whenOf(at, null)).toBe('–');
});

const run = (how: object): Run => ({ ok: false, ended: true, ...how }) as unknown as Run;

test('a run says how it ended', () => {
  const said = (end: string) => endOf(run({ end }));
  expect(said('done')).toBe('done');
  expect(said('stopped')).toBe('stopped by an operator');
  expect(said('reset')).toBe('reset by an operator');
  expect(said('estop')).toBe('STOP ALL');
  expect(said('alarm')).toBe('ended by an alarm');
  expect(said('cut_off')).toBe('interrupted: the control went down during the run');
  expect(said('off')).toBe('the machine was switched off');
});

test.each([{}, { end: null }, { end: 'of a newer daemon' }])('without it: %j', (how) => {
  expect(endOf(run({ ...how, ok: true }))).toBe('done');
  expect(endOf(run(how))).toBe('not finished');
  expect(endOf(run({ ...how, ended: false }))).toBe('running');
});

test('a run says how many periods it lost, and the longest gap', () => {
  expect(lostPeriodsOf(run({ lost_periods: 0, longest_gap_ms: 0 }))).toBe('0');
  expect(lostPeriodsOf(run({ lost_periods: 12, longest_gap_ms: 4 }))).toBe('12 (4 ms)');
  expect(lostPeriodsOf(run({ ended: false, lost_periods: 1, longest_gap_ms: 1 }))).toBe('–');
  expect(lostPeriodsOf(run({}))).toBe('–');
});
