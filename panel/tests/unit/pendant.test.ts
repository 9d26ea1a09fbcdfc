// The pendant: one direction together with the enabling button, and nothing else.
import { afterEach, expect, test, vi } from 'vitest';
import { askedFor, watchPendants, type Buttons } from '../../src/stores/pendant';

afterEach(() => vi.unstubAllGlobals());

const pad = (...pressed: number[]): Buttons => ({
  buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: pressed.includes(i) })),
});

test('a direction wants the enabling button', () => {
  expect(askedFor([pad(0, 15)])).toEqual(['X', 1]);
  expect(askedFor([pad(0, 14)])).toEqual(['X', -1]);
  expect(askedFor([null, pad(0, 12)])).toEqual(['Y', 1]);
  expect(askedFor([pad(0, 4)])).toEqual(['Z', -1]);
  expect(askedFor([pad(15)])).toBeNull();
  expect(askedFor([pad(0)])).toBeNull();
});

test('several directions, or those of two controllers, are none', () => {
  expect(askedFor([pad(0, 12, 15)])).toBeNull();
  expect(askedFor([pad(0, 15), pad(0, 12)])).toBeNull();
  expect(askedFor([pad(0), pad(15)])).toBeNull();
  expect(askedFor([{ buttons: [] }])).toBeNull();
});

test('what is down already when jogging is armed moves nothing until it was let go', () => {
  let now = [pad(0, 15)];
  let picture = (): void => undefined;
  vi.stubGlobal('navigator', { getGamepads: () => now });
  vi.stubGlobal('requestAnimationFrame', (look: () => void) => ((picture = look), 1));
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
  const pressed: string[] = [];
  const stop = watchPendants({
    press: (word, direction) => pressed.push(`${word}${direction}`),
    release: () => undefined,
  });
  picture();
  expect(pressed).toEqual([]);
  now = [pad(0)];
  picture();
  now = [pad(0, 15)];
  picture();
  expect(pressed).toEqual(['X1']);
  stop();
});
