// What a channel told of its process is shown as that of this channel, however late it comes.
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { store } from '../../src/stores/machine.svelte';
import { ProcessFollower } from '../../src/stores/process.svelte';

let answers: { channel: number; give: () => void }[];
beforeEach(() => {
  vi.useFakeTimers();
  answers = [];
  store.phase = 'live';
  vi.spyOn(store, 'call').mockImplementation(
    ((_: string, { channel }: { channel: number }) =>
      new Promise((resolve) =>
        answers.push({ channel, give: () => resolve({ channel }) }),
      )) as unknown as typeof store.call,
  );
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

test('an answer that comes when another channel is looked at is not shown', async () => {
  const follower = new ProcessFollower();
  const stop = follower.follow(1);
  await vi.advanceTimersByTimeAsync(2000);
  stop();
  const stopSecond = follower.follow(2);
  for (const answer of answers.splice(0)) answer.give();
  await vi.advanceTimersByTimeAsync(0);
  expect(follower.status).toBe(null);
  expect(follower.readings).toBe(0);
  await vi.advanceTimersByTimeAsync(2000);
  answers[0]?.give();
  await vi.advanceTimersByTimeAsync(0);
  expect(follower.status).toEqual({ channel: 2 });
  stopSecond();
});
