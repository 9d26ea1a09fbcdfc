// Which situation a command goes with: the one that was shown when somebody began to write it.
import { expect, test } from 'vitest';
import { SeenSituation, situationOf } from '../../src/stores/seen_situation';

const shown = (
  situation: number,
  { id = 1, run = 7, state = 'Reset' } = {},
): { id: number; situation: number; run: number; state: string } => ({ id, situation, run, state });

test('what was shown when the writing began counts, whoever runs what meanwhile', () => {
  const seen = new SeenSituation();
  seen.write('', shown(3));
  seen.write('G', shown(4));
  seen.write('G0', shown(5, { run: 8, state: 'Active' }));
  seen.write('G0', shown(6, { run: 8 }));
  expect(seen.of(shown(6, { run: 8 }))).toEqual({ situation: 4 });
});

test('an emptied line begins anew, and so does what was refused', () => {
  const seen = new SeenSituation();
  seen.write('G0', shown(4));
  seen.write(' ', shown(5));
  seen.write('G1', shown(6));
  expect(seen.of(shown(7))).toEqual({ situation: 6 });
  seen.send(shown(7));
  seen.refuse();
  expect(seen.of(shown(8))).toEqual({ situation: 8 });
});

test('a line that is written while the own one before it runs is meant for the end of that', () => {
  const seen = new SeenSituation();
  seen.write('G91', shown(4));
  seen.send(shown(4));
  seen.write('', shown(4));
  seen.write('X1', shown(4));
  seen.write('X1', shown(5, { run: 8, state: 'Active' }));
  seen.write('X1', shown(6, { run: 8 }));
  seen.write('X1', shown(7, { run: 8 }));
  expect(seen.of(shown(7, { run: 8 }))).toEqual({ situation: 6 });
});

test('another channel has another situation', () => {
  const seen = new SeenSituation();
  seen.write('G0', shown(4));
  expect(seen.of(shown(9, { id: 2 }))).toEqual({ situation: 9 });
  seen.write('G0 X', shown(10, { id: 2 }));
  expect(seen.of(shown(11, { id: 2 }))).toEqual({ situation: 10 });
});

test('a status without a situation sends none', () => {
  expect(situationOf({})).toEqual({});
});
