// Values are old from 0.3 s on: by what the status says of its age, and by the time since it came.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Freshness, oldAfter_ms } from '../../src/stores/freshness';

describe('A status is old', () => {
  const told: boolean[] = [];
  const isOld = (): boolean | undefined => told.at(-1);
  let freshness: Freshness;
  beforeEach(() => {
    vi.useFakeTimers();
    told.length = 0;
    freshness = new Freshness((old) => told.push(old));
  });
  afterEach(() => vi.useRealTimers());

  it('when none has come for 0.3 s, and is new again with the next one', () => {
    freshness.came(0);
    vi.advanceTimersByTime(oldAfter_ms - 1);
    expect(isOld()).toBe(false);
    vi.advanceTimersByTime(2);
    expect(isOld()).toBe(true);
    freshness.came(0);
    expect(isOld()).toBe(false);
  });
  it('by the age that it has when it comes', () => {
    freshness.came(oldAfter_ms);
    expect(isOld()).toBe(true);
    freshness.came(250);
    expect(isOld()).toBe(false);
    vi.advanceTimersByTime(51);
    expect(isOld()).toBe(true);
  });
  it('never while they come in time', () => {
    for (let i = 0; i < 100; ++i) {
      freshness.came(2);
      vi.advanceTimersByTime(50);
    }
    expect(told).not.toContain(true);
  });
  it('not where the page stood still and one waits to be taken', () => {
    freshness.came(0);
    setTimeout(() => freshness.came(0), oldAfter_ms);
    vi.advanceTimersByTime(oldAfter_ms + 10);
    expect(told).not.toContain(true);
  });
});
