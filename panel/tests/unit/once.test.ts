// Pressed twice is done once; afterwards it can be done again.
import { expect, test } from 'vitest';
import { once } from '../../src/stores/once';

test('what is under way is not begun anew', async () => {
  let begun = 0;
  let end = (): void => undefined;
  const act = once(() => new Promise<number>((resolve) => (end = () => resolve((begun += 1)))));
  const [first, second] = [act(), act()];
  end();
  expect(await Promise.all([first, second])).toEqual([1, 1]);
  const third = act();
  end();
  expect(await third).toBe(2);
});

test('a refusal ends it, too', async () => {
  const act = once(() => Promise.reject(new Error('no')));
  await expect(act()).rejects.toThrow('no');
  await expect(act()).rejects.toThrow('no');
});
