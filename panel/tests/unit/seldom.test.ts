// Many askings are one act, and the last of them counts.
import { expect, test, vi } from 'vitest';
import { seldom } from '../../src/stores/seldom';

test('a burst is one act; what comes later is another one', () => {
  vi.useFakeTimers();
  let acts = 0;
  const ask = seldom(500, () => (acts += 1));
  for (let i = 0; i < 100; ++i) {
    ask();
    vi.advanceTimersByTime(1);
  }
  vi.advanceTimersByTime(500);
  expect(acts).toBe(1);
  ask();
  vi.advanceTimersByTime(500);
  expect(acts).toBe(2);
  vi.useRealTimers();
});
