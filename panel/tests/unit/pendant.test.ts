// The pendant: one direction together with the enabling button, and nothing else.
import { expect, test } from 'vitest';
import { askedFor, type Buttons } from '../../src/stores/pendant';

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
