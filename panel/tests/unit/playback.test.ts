// Where the tip was at a time of a log.
import { expect, test } from 'vitest';
import { indexAt } from '../../src/stores/playback.svelte';

test('the last point that is not later', () => {
  const times = [0, 10, 10, 25, 40];
  expect([-1, 0, 9, 10, 24, 25, 100].map((time) => indexAt(times, time))).toEqual([
    -1, 0, 0, 2, 2, 3, 4,
  ]);
  expect(indexAt([], 5)).toBe(-1);
});
