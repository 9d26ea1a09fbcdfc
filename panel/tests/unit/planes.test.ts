// Tilted planes of a program as they are shown behind its check.
import { expect, test } from 'vitest';
import { spoken } from '../../src/stores/spoken.svelte';
import {
  directionText,
  otherText,
  positionText,
  type TiltedPlane,
} from '../../src/views/programs/planes';

const plane: TiltedPlane = {
  file: 'plane.nc',
  line: 3,
  tool: [-1e-17, -0.42261826174069944, 0.9063077870366499],
  axes: { A: -25, C: 0 },
};

test('angles and directions are written without noise', () => {
  expect(positionText({ A: -21.80140948635181, C: 90.00000000000001 })).toBe('A\u221221.8014 C90');
  expect(positionText({ B: 100, C: -1e-9 })).toBe('B100 C0');
  expect(directionText(plane.tool)).toBe('X0 Y\u22120.4226 Z0.9063');
});

test('the other position is told with what hinders it', async () => {
  await spoken.speak('en');
  expect(otherText(plane)).toBe('');
  expect(otherText({ ...plane, other: { word: 'P1', axes: { A: 25, C: -180 } } })).toBe(
    'P1: A25 C\u2212180',
  );
  expect(otherText({ ...plane, other: { word: 'P1', axes: { A: 50 }, limit: 30 } })).toBe(
    'P1: A50, but A ends at 30',
  );
});
