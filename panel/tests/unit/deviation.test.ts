import { expect, test } from 'vitest';
import { colourOfDeviation, deviationOf, scaleOf } from '../../src/geometry/deviation';

test('the number of a corner is a deviation in steps of 0.1 µm, below zero too', () => {
  expect(deviationOf(12_345)).toBe(1.2345);
  expect(deviationOf(2 ** 32 - 500)).toBe(-0.05);
});

test('the scale says what each colour means', () => {
  const scale = scaleOf(0.7);
  expect(scale).toHaveLength(7);
  expect(scale[0]?.from).toBeNull();
  expect(scale[6]?.to).toBeNull();
  scale.forEach(({ colour, from, to }, k) => {
    expect(to ?? 0.7).toBeCloseTo(-0.5 + 0.2 * k);
    const middle = ((from ?? -0.7) + (to ?? 0.7)) / 2;
    expect(colourOfDeviation(middle, 0.7)).toBe(colour);
  });
  // Beyond both ends.
  expect(colourOfDeviation(-5, 0.7)).toBe(colourOfDeviation(-0.65, 0.7));
  expect(colourOfDeviation(5, 0.7)).toBe(colourOfDeviation(0.65, 0.7));
  expect(new Set(scale.map(({ colour }) => colour)).size).toBe(7);
});
