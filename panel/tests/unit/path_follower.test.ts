// The planned path is asked for again after a connection was lost in the middle of it.
import { afterEach, expect, test, vi } from 'vitest';
import { store, type Channel } from '../../src/stores/machine.svelte';
import { PathFollower, tipOf } from '../../src/stores/path.svelte';

afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

test('a path that was interrupted is read from its beginning', async () => {
  vi.useFakeTimers();
  const pages: number[] = [];
  let isLost = true;
  vi.spyOn(store, 'call').mockImplementation(((_: string, params: { page: number }) => {
    pages.push(params.page);
    if (isLost && params.page === 1) return Promise.reject(new Error('lost'));
    const geometry = { id: 3, page: params.page, rapid: [], begins: [] };
    return Promise.resolve({
      id: 3,
      pages: 2,
      complete: true,
      given_up: null,
      geometry: params.page < 2 ? geometry : null,
    });
  }) as unknown as typeof store.call);
  const channel = { id: 1, program: 'a.nc', scheme: 1, run: 1, planned_path: 3 } as Channel;
  const follower = new PathFollower();
  follower.follow(channel);
  await vi.advanceTimersByTimeAsync(1000);
  expect(pages).toEqual([0, 1]);
  isLost = false;
  await vi.advanceTimersByTimeAsync(5000);
  follower.follow(channel);
  await vi.advanceTimersByTimeAsync(1000);
  expect(pages).toEqual([0, 1, 0, 1, 2]);
});

test('another path of the same program takes the place of the one before', async () => {
  vi.useFakeTimers();
  const asked: number[] = [];
  let given_up: string | null = null;
  let id = 3;
  vi.spyOn(store, 'call').mockImplementation(((_: string, { page }: { page: number }) => {
    asked.push(page);
    return Promise.resolve({ id, pages: 0, complete: given_up === null, given_up, geometry: null });
  }) as unknown as typeof store.call);
  const channel = { id: 1, program: 'a.nc', scheme: 1, run: 1, planned_path: 3 } as Channel;
  const follower = new PathFollower();
  for (let status = 0; status < 5; ++status) {
    follower.follow(channel);
    await vi.advanceTimersByTimeAsync(50);
  }
  expect(asked).toEqual([0]);
  const { generation } = follower.plan.track;
  given_up = 'computing_time';
  id = 4;
  follower.follow({ ...channel, planned_path: 4 });
  await vi.advanceTimersByTimeAsync(5000);
  expect(asked).toEqual([0, 0]);
  expect(follower.plan.track.generation).toBeGreaterThan(generation);
  expect(follower.givenUp).toBe('computing_time');
});

test('the tool is drawn at the point, never at the words for it', () => {
  const lathe = { position: { X: 60, Z: -5 }, point_W: { X: 30, Z: -5 } };
  expect(tipOf({ id: 1, ...lathe } as unknown as Channel)).toEqual([30, 0, -5]);
  const on_part = { tip: [1, 2, 3] };
  expect(tipOf({ id: 1, ...lathe, on_part } as unknown as Channel)).toEqual([1, 2, 3]);
});
