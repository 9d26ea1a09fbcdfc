// What the daemon calls a session, a role and a method, in words that people use.
import { beforeAll, expect, test } from 'vitest';
import { noData, Refusal } from '../../src/rpc/json_rpc';
import { whoIs, withPeople } from '../../src/stores/people';
import { sentenceOf } from '../../src/stores/refusal.svelte';
import { spoken } from '../../src/stores/spoken.svelte';

beforeAll(() => spoken.speak('en'));

test('a session is a user, a page opened by its link, or a program', () => {
  expect(whoIs('session 79 (maria (uid 0, pid 3244))')).toBe('maria');
  expect(whoIs('session 79 (uid 0 (uid 0, pid 3244))')).toBe('a page opened by its link');
  expect(whoIs('session 1 (uid 1000, pid 15)')).toBe(
    'a program on the control computer (process 15)',
  );
  expect(whoIs('uid 1000, pid 15')).toMatch(/process 15/);
  expect(whoIs('maria (uid 0, pid 3244)')).toBe('maria');
  expect(whoIs('the program')).toBe('the program');
});

test('a refusal says it in its sentence', () => {
  const sentence = 'channel 1 is controlled by session 2 (maria (uid 0, pid 7))';
  expect(withPeople(sentence)).toBe('channel 1 is controlled by maria');
  const refused = new Refusal(1000, sentence, { ...noData, code: 'E6080' });
  expect(sentenceOf(refused)).toBe('channel 1 is controlled by maria');
  expect(withPeople('the axis X stands outside (2 mm)')).toBe('the axis X stands outside (2 mm)');
});

test('what a role does not permit has no name of a method', () => {
  const wire = 'program.hold needs the role operator; this session is observer';
  const refused = new Refusal(-32002, wire, { ...noData, code: 'E9004' });
  expect(sentenceOf(refused)).toBe('Not permitted for the role “observer”.');
});
