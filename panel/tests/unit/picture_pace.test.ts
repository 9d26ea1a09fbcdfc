// Pictures never keep the thread of the page for long: what they need comes by slices, and what draws is
// started elsewhere.
import { Frustum, Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { whenGraphicsStarted } from '../../src/geometry/graphics_start';
import { Levels } from '../../src/geometry/levels';
import { Pairs } from '../../src/geometry/pairs';
import { PicturePace } from '../../src/geometry/picture_pace';
import { PointColours } from '../../src/geometry/point_colours';
import { Track } from '../../src/geometry/track';

const frame_ms = 16;
let did: string[];
beforeEach(() => {
  vi.useFakeTimers();
  did = [];
  vi.stubGlobal('requestAnimationFrame', (act: () => void) => setTimeout(act, frame_ms));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const gl = {
  fenceSync: () => null,
  flush: () => undefined,
  isContextLost: () => false,
  deleteSync: () => undefined,
} as unknown as WebGL2RenderingContext;

function paceOf(slices: number, size: 'fits' | 'differs' = 'fits'): PicturePace {
  let left = slices;
  return new PicturePace({
    fullPixels: () => 1000,
    prepare: () => {
      did.push('slice');
      left -= 1;
      return left <= 0;
    },
    fit: () => {
      const fits = size === 'fits';
      if (!fits) did.push('size');
      return fits;
    },
    draw: () => did.push('picture'),
    gl: () => gl,
  });
}

test('a press is heard between the slices of a picture', async () => {
  const pace = paceOf(4);
  pace.wake();
  await vi.advanceTimersByTimeAsync(frame_ms - 1);
  // Comes while the first slice is being made.
  setTimeout(() => did.push('press'), 1);
  await vi.advanceTimersByTimeAsync(frame_ms);
  expect(did).toEqual(['slice', 'press', 'slice', 'slice', 'slice', 'picture']);
  pace.close();
});

test('a press is heard between another size of the picture and the picture', async () => {
  const pace = paceOf(1, 'differs');
  pace.wake();
  await vi.advanceTimersByTimeAsync(frame_ms - 1);
  setTimeout(() => did.push('press'), 1);
  await vi.advanceTimersByTimeAsync(2);
  expect(did).toEqual(['slice', 'size', 'press', 'picture']);
  pace.close();
});

test('a view that was closed prepares and draws nothing any more', async () => {
  const pace = paceOf(1000);
  pace.wake();
  await vi.advanceTimersByTimeAsync(frame_ms);
  pace.close();
  const before = did.length;
  await vi.advanceTimersByTimeAsync(1000);
  expect(did.length).toBe(before);
});

test('levels and colours that come by slices are those that come at once', () => {
  const track = new Track();
  for (let i = 0; i < 5000; ++i) track.add(Math.cos(i / 50), Math.sin(i / 50), i / 1000, i);
  const [levels, colours] = [new Levels(track), new PointColours(track, (i) => [i & 255, 1, 2])];
  // Each look at the clock finds it a moment later: one stretch, or one piece, a slice.
  let now = 0;
  vi.spyOn(performance, 'now').mockImplementation(() => (now += 1));
  let slices = 0;
  while (!levels.grow(now + 1)) slices += 1;
  expect(slices).toBe(Math.ceil(4999 / 256) - 1);
  slices = 0;
  while (!colours.grow(now + 1)) slices += 1;
  expect(slices).toBe(Math.ceil(5000 / 1024) - 1);
  expect(colours.version).toBe(1);
  const whole = new PointColours(track, (i) => [i & 255, 1, 2]);
  whole.grow();
  expect(colours.values).toEqual(whole.values);
  const camera = new PerspectiveCamera(40, 1, 0.1, 50_000);
  const seen = camera.projectionMatrix.clone().multiply(new Matrix4().makeTranslation(0, 0, -20));
  const sight = {
    frustum: new Frustum().setFromProjectionMatrix(seen),
    eye: new Vector3(0, 0, 20),
    tolerance: 1e-4,
    segmentsAtMost: Infinity,
  };
  const atOnce = new Levels(track);
  atOnce.grow();
  const [some, all] = [levels, atOnce].map((one) => {
    const pairs = new Pairs();
    one.choose(sight, pairs);
    return pairs;
  });
  expect(all?.count).toBeGreaterThan(100);
  expect(some?.indices).toEqual(all?.indices);
});

test('a context is asked for when a thread of its own has started to draw', async () => {
  let worker: { onmessage?: () => void; onerror?: () => void } = {};
  const terminate = vi.fn();
  vi.stubGlobal(
    'Worker',
    class {
      terminate = terminate;
      constructor() {
        worker = this as typeof worker;
      }
    },
  );
  const created = whenGraphicsStarted(() => did.push('created'));
  await vi.advanceTimersByTimeAsync(1000);
  expect(did).toEqual([]);
  worker.onmessage?.();
  await created;
  expect(did).toEqual(['created']);
  expect(terminate).toHaveBeenCalledOnce();
});

test('where there is no such thread it is asked for all the same', async () => {
  vi.stubGlobal('Worker', undefined);
  const created = whenGraphicsStarted(() => 'created');
  await vi.advanceTimersByTimeAsync(1);
  expect(await created).toBe('created');
});
