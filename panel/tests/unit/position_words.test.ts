// Positions in the unit that programs are read in, and diameters.
import { expect, test } from 'vitest';
import { isDiameter, shownWord, unitsOf, wordIn } from '../../src/stores/position_words';

test('a word is shown in the unit of the codes in force; angles stay degrees', () => {
  expect(unitsOf({})).toBe('mm');
  expect(unitsOf({ units: 'inch' })).toBe('inch');
  expect(shownWord('X', 25.4, 'mm')).toBe('25.400');
  expect(shownWord('X', -25.4, 'inch')).toBe('\u22121.0000');
  expect(shownWord('Z', 0.00254, 'inch')).toBe('0.0001');
  expect(shownWord('C', 25.4, 'inch')).toBe('25.400');
});

test('what is written is a value in mm or degrees', () => {
  expect(wordIn('10', 'X', 'mm')).toBe(10);
  expect(wordIn('10', 'X', 'inch')).toBeCloseTo(254, 12);
  expect(wordIn('-0,5', 'Z', 'inch')).toBeCloseTo(-12.7, 12);
  expect(wordIn('10', 'C', 'inch')).toBe(10);
  expect(wordIn('', 'X', 'inch')).toBeNull();
});

test('a diameter is what the channel says is one', () => {
  expect(isDiameter({ diameter: ['X'] }, 'X')).toBe(true);
  expect(isDiameter({ diameter: ['X'] }, 'Z')).toBe(false);
  expect(isDiameter({}, 'X')).toBe(false);
});
