// The picture of the path that was asked for last is the one that is shown, and the only one that draws, in
// whatever order browsers start to draw.
import { beforeEach, expect, test, vi } from 'vitest';
import { forgetPicture, pictureOf } from '../../src/geometry/kept_picture';
import type { PathScene } from '../../src/geometry/path_scene';
import { Track } from '../../src/geometry/track';

const { starts, made } = vi.hoisted(() => ({
  starts: [] as (() => void)[],
  made: [] as { lie: string; closed: boolean; isLost: boolean }[],
}));

vi.mock('../../src/geometry/graphics_start', () => ({
  whenGraphicsStarted: async <T>(create: () => T): Promise<T> => {
    await new Promise<void>((resolve) => starts.push(resolve));
    return create();
  },
}));
vi.mock('../../src/geometry/path_scene', () => ({
  PathScene: class {
    closed = false;
    isLost = false;
    constructor(
      readonly planned: Track,
      readonly traced: Track,
      readonly lie: string,
    ) {
      made.push(this);
    }
    close(): void {
      this.closed = true;
    }
  },
}));

beforeEach(() => {
  forgetPicture();
  starts.length = made.length = 0;
});

const lieOf = (asked: Promise<PathScene>): Promise<unknown> =>
  asked.then(
    (scene) => (scene as unknown as { lie: string }).lie,
    () => 'none',
  );
const open = (): string[] => made.filter((one) => !one.closed).map((one) => one.lie);
const started = (count: number): Promise<void> =>
  vi.waitFor(() => expect(starts).toHaveLength(count));

const orders = [
  [0, 1, 2],
  [0, 2, 1],
  [1, 0, 2],
  [1, 2, 0],
  [2, 0, 1],
  [2, 1, 0],
];
test.each(orders)('the last of three is shown: %d, %d, %d', async (...order) => {
  const track = new Track();
  const asked: Promise<unknown>[] = [];
  for (const lie of ['milled', 'turned', 'milled'] as const) {
    asked.push(lieOf(pictureOf(track, track, lie)));
    await started(asked.length);
  }
  for (const k of order) {
    starts[k]?.();
    await new Promise((resolve) => setTimeout(resolve));
    // One that nobody looks at neither draws nor closes the one that somebody looks at.
    expect(open().length).toBeLessThanOrEqual(1);
  }
  expect(await Promise.all(asked)).toEqual(['none', 'none', 'milled']);
  expect(open()).toEqual(['milled']);
});

test('it stays, and is made once however often it is asked for', async () => {
  const track = new Track();
  const asked = [1, 2, 3].map(() => lieOf(pictureOf(track, track, 'turned')));
  await started(1);
  starts[0]?.();
  expect(await Promise.all(asked)).toEqual(['turned', 'turned', 'turned']);
  expect(await lieOf(pictureOf(track, track, 'turned'))).toBe('turned');
  expect(made).toHaveLength(1);
});

test('one that is forgotten before it is made is not made', async () => {
  const asked = lieOf(pictureOf(new Track(), new Track(), 'milled'));
  await started(1);
  forgetPicture();
  starts[0]?.();
  expect(await asked).toBe('none');
  expect(made).toEqual([]);
});

test('one whose graphics are lost is made anew', async () => {
  const track = new Track();
  const first = lieOf(pictureOf(track, track, 'milled'));
  await started(1);
  starts[0]?.();
  await first;
  for (const one of made) one.isLost = true;
  const second = lieOf(pictureOf(track, track, 'milled'));
  await started(2);
  starts[1]?.();
  expect(await second).toBe('milled');
  expect(open()).toEqual(['milled']);
});
