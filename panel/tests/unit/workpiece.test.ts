// The part by bricks: frames belong to their answers, only what changed is asked for, another blank
// replaces the first.
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { store } from '../../src/stores/machine.svelte';
import { cutterOf, WorkpieceFollower } from '../../src/stores/workpiece.svelte';

type Asked = Record<string, number>;
let asked: Asked[];
let bricks: Map<number, number>;
let answers: (() => object)[];
let follower: WorkpieceFollower;
let stop: () => void;
let frames: ((frame: ArrayBuffer) => void)[];

function frame(id: number, page: number, corners: number, tool: number): ArrayBuffer {
  const words = new Uint32Array(4 + corners * 4);
  words.set([2, id, page, corners]);
  words.fill(tool, 4 + corners * 3);
  return words.buffer;
}

// An answer, and its frame behind it.
function page(id: number, version: number, from: number, told: number[][], next: number | null) {
  return () => {
    const count = Math.max(0, ...told.map((one) => one[2] ?? 0));
    queueMicrotask(() =>
      setTimeout(() => frames.forEach((take) => take(frame(id, from, count, 5)))),
    );
    const geometry = { id, page: from, bricks: told };
    return { workpiece: id, version, next, cycles_left_out: 0, geometry };
  };
}
const nothing = (): object => ({ workpiece: null, version: 0, next: null, cycles_left_out: 0 });

beforeEach(() => {
  vi.useFakeTimers();
  store.phase = 'live';
  [asked, answers, frames] = [[], [], []];
  bricks = new Map();
  vi.spyOn(store, 'onFrame').mockImplementation((take) => {
    frames.push(take);
    return () => undefined;
  });
  vi.spyOn(store, 'call').mockImplementation(((_: string, params: Asked) => {
    asked.push(params);
    return Promise.resolve((answers.shift() ?? nothing)());
  }) as unknown as typeof store.call);
  follower = new WorkpieceFollower({
    set: (brick, corners, tools) => {
      expect(corners.length).toBe(tools.length * 3);
      if (tools.length > 0) bricks.set(brick, tools.length);
      else bricks.delete(brick);
    },
    clear: () => bricks.clear(),
  });
});
afterEach(() => {
  stop();
  vi.useRealTimers();
  vi.restoreAllMocks();
});

test('all pages first, then what is newer than the first of them', async () => {
  answers = [
    page(
      1,
      4,
      0,
      [
        [0, 0, 6],
        [3, 6, 12],
      ],
      7,
    ),
    page(1, 5, 7, [[9, 0, 3]], null),
  ];
  answers.push(page(1, 6, 0, [[3, 0, 0]], null));
  stop = follower.follow(1);
  await vi.advanceTimersByTimeAsync(100);
  expect([...bricks]).toEqual([
    [0, 6],
    [3, 6],
    [9, 3],
  ]);
  await vi.advanceTimersByTimeAsync(400);
  expect(asked.map(({ workpiece, since, from }) => [workpiece, since, from])).toEqual([
    [0, 0, 0],
    [1, 0, 7],
    [1, 4, 0],
  ]);
  expect([...bricks.keys()]).toEqual([0, 9]);
});

test('as long as pages are missing it says so; changes of a whole part do not', async () => {
  answers = [page(1, 4, 0, [[0, 0, 6]], 7), () => ({ ...page(1, 4, 7, [[9, 0, 3]], null)() })];
  const said: boolean[] = [];
  const call = vi.mocked(store.call).getMockImplementation();
  vi.mocked(store.call).mockImplementation(((method: string, params: Asked) => {
    said.push(follower.isComing);
    return call?.(method as never, params as never);
  }) as unknown as typeof store.call);
  answers.push(page(1, 6, 0, [[3, 0, 6]], 5), page(1, 6, 5, [[5, 0, 3]], null));
  stop = follower.follow(1);
  await vi.advanceTimersByTimeAsync(700);
  expect(said).toEqual([false, true, false, false]);
});

test('a part is that of the newest run when it was first seen, lines by hand left out', async () => {
  let runs = [
    { channel: 1, program: 'first.nc' },
    { channel: 2, program: 'other.nc' },
    { channel: 1, program: 'MDI' },
  ];
  vi.mocked(store.call).mockImplementation((() =>
    Promise.resolve({ runs })) as unknown as typeof store.call);
  stop = () => undefined;
  expect(await cutterOf(1, 7)).toBe('first.nc');
  runs = [...runs, { channel: 1, program: 'second.nc' }];
  expect(await cutterOf(1, 7)).toBe('first.nc');
  expect(await cutterOf(1, 8)).toBe('second.nc');
});

test('another blank takes the place of the first; none shows nothing', async () => {
  answers = [page(1, 4, 0, [[0, 0, 6]], null), page(2, 1, 0, [[5, 0, 3]], null)];
  stop = follower.follow(1);
  await vi.advanceTimersByTimeAsync(600);
  expect(follower.workpiece).toBe(2);
  expect([...bricks.keys()]).toEqual([5]);
  await vi.advanceTimersByTimeAsync(600);
  expect(follower.workpiece).toBe(0);
  expect(bricks.size).toBe(0);
});

// The page chooses other colours while an answer is on its way: what that brings belongs to nobody, and
// what has come by then is not taken for what the new look has.
test('an answer that comes behind the end of its look changes nothing', async () => {
  const waiting: (() => void)[] = [];
  vi.spyOn(store, 'call').mockImplementation(((_: string, params: Asked) => {
    asked.push(params);
    const answer = answers.shift() ?? nothing;
    return new Promise((resolve) => waiting.push(() => resolve(answer())));
  }) as unknown as typeof store.call);
  const come = async (): Promise<void> => {
    waiting.shift()?.();
    await vi.advanceTimersByTimeAsync(10);
  };
  answers = [page(1, 4, 0, [[0, 0, 6]], null), page(1, 5, 0, [[3, 0, 9]], null)];
  answers.push(page(1, 5, 0, [[0, 0, 6]], null));
  stop = follower.follow(1);
  await vi.advanceTimersByTimeAsync(10);
  await come();
  expect([...bricks.keys()]).toEqual([0]);
  await vi.advanceTimersByTimeAsync(400); // asks for what is newer than 4
  stop();
  follower.forget();
  stop = follower.follow(1, 'wanted.stl');
  await come();
  expect([...bricks.keys()]).toEqual([]);
  await vi.advanceTimersByTimeAsync(400);
  await come();
  await vi.advanceTimersByTimeAsync(400);
  expect(asked.map(({ since }) => since)).toEqual([0, 4, 0, 5]);
  expect([...bricks.keys()]).toEqual([0]);
});
