// Numbers and times as they are shown, and the words for what a channel does.
import { expect, test } from 'vitest';
import {
  fileOf,
  isUnderWay,
  kindOfMark,
  overrideAtZero,
  placeOf,
  progressOf,
  stateOf,
  stoppingOverride,
  timeLeft,
} from '../../src/stores/acts';
import { bytes, duration, fixed, isRotary, numberIn } from '../../src/stores/format';
import { spoken } from '../../src/stores/spoken.svelte';
import type { Channel } from '../../src/stores/machine.svelte';

test('numbers have fixed decimals, a real minus and no negative zero', () => {
  expect(fixed(12.3456, 3)).toBe('12.346');
  expect(fixed(-0.5, 3)).toBe('\u22120.500');
  expect(fixed(-0.0001, 3)).toBe('0.000');
});

test('what a person writes is a number or none; an empty field is not zero', () => {
  expect(['1', ' -2,5 ', '\u22120.5', '+.25', '3.'].map(numberIn)).toEqual([
    1, -2.5, -0.5, 0.25, 3,
  ]);
  for (const none of ['', ' ', '1e3', '0x10', '1.2.3', '1,234.5', 'Infinity', 'abc', '-']) {
    expect(numberIn(none)).toBeNull();
  }
});

test('sizes', async () => {
  await spoken.speak('en');
  expect([489, 100_854, 22_200_000].map(bytes)).toEqual(['489 B', '100.9 kB', '22.2 MB']);
  await spoken.speak('ru');
  expect([489, 100_854, 22_200_000].map(bytes)).toEqual(['489 Б', '100.9 кБ', '22.2 МБ']);
});

test('times', () => {
  expect(duration(75)).toBe('1:15');
  expect(duration(3700)).toBe('1:01:40');
  expect(duration(-1)).toBe('0:00');
});

test('A, B and C turn', () => {
  expect(['X', 'Y', 'Z', 'A', 'B1', 'C'].map(isRotary)).toEqual([
    false,
    false,
    false,
    true,
    true,
    true,
  ]);
});

const channel = (some: Partial<Channel>): Channel => ({
  id: 1,
  name: 'work',
  state: 'Reset',
  program_status: 'Stopped',
  override: { feed: 100, rapid: 100, spindle: 100 },
  ...some,
});
const alarm = { channel: 1, code: 'A1001', text: '', cycle: 0 } as NonNullable<Channel['alarm']>;

test('an alarm comes before all, then hold, waiting, running', () => {
  expect(stateOf(channel({ state: 'Interrupted', alarm }), true)).toBe('alarm');
  expect(stateOf(channel({ state: 'Interrupted' }), true)).toBe('held');
  expect(stateOf(channel({ state: 'Active', program_status: 'Waiting' }), true)).toBe('waiting');
  expect(stateOf(channel({ state: 'Active', program_status: 'Running' }), true)).toBe('running');
  expect(stateOf(channel({ program: 'a.nc' }), true)).toBe('ready');
  expect(stateOf(channel({}), true)).toBe('idle');
  expect(stateOf(channel({ program: 'a.nc' }), false)).toBe('off');
  expect(Object.keys(kindOfMark)).toHaveLength(8);
});

test('what does not move is not running, and an override says why', () => {
  const at = (feed: number, rapid: number, speed_mm_s: number, code = 'G1'): Channel => {
    const some = { speed_mm_s, g_codes: [code, 'G90'], words: ['X', 'Y'] };
    const running = { state: 'Active', program_status: 'Running' };
    return channel({ ...running, ...some, override: { feed, rapid, spindle: 100 } });
  };
  expect(stateOf(at(0, 100, 0), true)).toBe('standing');
  expect(stoppingOverride(at(0, 100, 0))).toBe('feed');
  // On its way to rest, in a rapid move, or with a pause between two blocks.
  expect(stateOf(at(0, 100, 3.5), true)).toBe('running');
  expect(stateOf(at(0, 100, 0, 'G0'), true)).toBe('running');
  expect(stateOf(at(100, 100, 0), true)).toBe('running');
  expect(stoppingOverride(at(100, 0, 0, 'G0'))).toBe('rapid');
  // A channel that directs others has nothing that could move.
  expect(stateOf({ ...at(0, 0, 0), words: [] }, true)).toBe('running');
  expect(overrideAtZero(at(0, 100, 0, 'G0'))).toBe('feed');
  expect(overrideAtZero(at(100, 0, 0))).toBe('rapid');
  expect(overrideAtZero(at(100, 100, 0))).toBeNull();
  expect(isUnderWay('standing')).toBe(true);
  expect(isUnderWay('ready')).toBe(false);
});

test('the time that is left is that of overrides of 100 %', async () => {
  await spoken.speak('en');
  const left = (feed: number): string =>
    timeLeft(channel({ remaining_s: 83, override: { feed, rapid: 100, spindle: 100 } }));
  expect(left(100)).toBe('1:23 left');
  expect(left(50)).toBe('1:23 left at 100 %');
});

test('progress is a share of the predicted time', () => {
  expect(progressOf(channel({ predicted_s: 100, remaining_s: 39 }))).toBeCloseTo(0.61);
  expect(progressOf(channel({ predicted_s: 100, remaining_s: 120 }))).toBe(0);
  expect(progressOf(channel({ predicted_s: null, remaining_s: 1 }))).toBeNull();
});

test('a line has its file beside it where that is not the program', async () => {
  await spoken.speak('en');
  expect(placeOf({ program: 'a.nc', file: 'a.nc', line: 7 })).toBe('line 7');
  expect(placeOf({ program: 'a.nc', file: 'sub.nc', line: 7 })).toBe('sub.nc:7');
  expect(placeOf({ program: 'a.nc' })).toBe('line 0');
  expect(fileOf({ program: 'a.nc', file: 'sub.nc' })).toBe('sub.nc');
  expect(fileOf({ program: 'a.nc', file: null })).toBe('a.nc');
  expect(fileOf({})).toBeNull();
});
