// Which segments a picture shows: far fewer from afar, none further off than what was allowed, none out of view.
import { Frustum, PerspectiveCamera, Ray, Vector3, Matrix4 } from 'three';
import { expect, test } from 'vitest';
import { Levels, type Sight } from '../../src/geometry/levels';
import { Pairs } from '../../src/geometry/pairs';
import { Sharpness } from '../../src/geometry/sharpness';
import { Track, way } from '../../src/geometry/track';

function sightFrom(eye: Vector3, target: Vector3, tolerance: number, most = Infinity): Sight {
  const camera = new PerspectiveCamera(40, 1, 0.1, 50_000);
  camera.position.copy(eye);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  const seen = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const frustum = new Frustum().setFromProjectionMatrix(seen);
  return { frustum, eye, tolerance, segmentsAtMost: most };
}

const far = (tolerance: number, most?: number): Sight =>
  sightFrom(new Vector3(0, -1000, 500), new Vector3(0, 0, 2), tolerance, most);

// A helix of radius 40 mm, 500 points for each radian.
function spread(track: Track, from: number, to: number): void {
  for (let i = from; i < to; ++i) {
    const turn = i / 500;
    track.add(40 * Math.cos(turn), 40 * Math.sin(turn), turn / 10, i + 1);
  }
}

function chosen(track: Track, sight: Sight): number[][] {
  const levels = new Levels(track);
  const pairs = new Pairs();
  levels.grow();
  levels.choose(sight, pairs);
  return Array.from({ length: pairs.count }, (_, k) => [
    ...pairs.indices.subarray(2 * k, 2 * k + 2),
  ]);
}

const at = (track: Track, i: number): Vector3 => new Vector3().fromArray(track.points, 3 * i);

function mostOff(track: Track, pairs: number[][]): number {
  let most = 0;
  for (const [from = 0, to = 0] of pairs) {
    const [a, u] = [at(track, from), at(track, to).sub(at(track, from))];
    for (let i = from + 1; i < to; ++i) {
      const p = at(track, i).sub(a);
      const share = Math.min(1, Math.max(0, p.dot(u) / u.lengthSq()));
      most = Math.max(most, p.addScaledVector(u, -share).length());
    }
  }
  return most;
}

test('from afar there are fewer segments, and no point is further off than was allowed', () => {
  const track = new Track();
  spread(track, 0, 20_000);
  for (const off_mm of [0.02, 0.1, 1]) {
    // The nearest point is some 1078 mm away; what is asked of it holds for all.
    const pairs = chosen(track, far(off_mm / 1200));
    expect(mostOff(track, pairs)).toBeLessThan(off_mm);
    // A chord that is off by h at radius r is sqrt(8 r h) long; by levels twice as fine, 0.7 of it at worst,
    // and Douglas and Peucker halve: at least a quarter of it.
    const chord_points = (Math.sqrt(8 * 40 * off_mm) / 40) * 500;
    expect(pairs.length).toBeLessThan(20_000 / (chord_points / 4) + 20_000 / 256 + 1);
  }
});

test('seen from near, all segments in view are there, and none of those behind', () => {
  const track = new Track();
  spread(track, 0, 20_000);
  const pairs = chosen(track, sightFrom(new Vector3(40, -3, 0), new Vector3(40, 0, 0), 1e-6));
  const isThere = new Set(pairs.map(([from = 0]) => from));
  for (let i = 0; i < 100; ++i) expect(isThere.has(i)).toBe(true);
  expect(pairs.every(([from = 0, to = 0]) => to === from + 1)).toBe(true);
  // Half a turn on, the path runs at x = -40, 80 mm behind what is looked at, but not in the narrow picture.
  expect(pairs.length).toBeLessThan(20_000 / 2);
});

test('there are never more segments than a picture may have', () => {
  const track = new Track();
  spread(track, 0, 50_000);
  expect(chosen(track, far(0)).length).toBe(49_999);
  expect(chosen(track, far(0, 2000)).length).toBeLessThanOrEqual(2000);
});

test('a path that came by pages is drawn as the whole', () => {
  const [whole, paged] = [new Track(), new Track()];
  spread(whole, 0, 10_000);
  const [levels, pairs] = [new Levels(paged), new Pairs()];
  for (let page = 0; page < 10; ++page) {
    spread(paged, 1000 * page, 1000 * (page + 1));
    levels.grow();
    levels.choose(far(1e-4), pairs);
    expect(pairs.indices[2 * pairs.count - 1]).toBe(paged.count - 1);
  }
  expect([...pairs.indices.subarray(0, 2 * pairs.count)]).toEqual(chosen(whole, far(1e-4)).flat());
});

test('nothing leads to a new beginning, and feed and rapid moves never become one line', () => {
  const track = new Track();
  for (let i = 0; i < 6; ++i) track.add(i, 0, 0, i);
  track.mark(2, 4, way.rapid);
  track.mark(5, 6, way.none);
  expect(chosen(track, far(1))).toEqual([
    [0, 1],
    [1, 3],
    [3, 4],
  ]);
  track.clear();
  track.add(0, 0, 0, 1);
  expect(chosen(track, far(1))).toEqual([]);
});

test('a press meets the segment that is nearest to the eye', () => {
  const track = new Track();
  for (let i = 0; i < 1000; ++i) track.add(i / 10, 0, 0, i);
  for (let i = 0; i < 1000; ++i) track.add(i / 10, 0, -10, 1000 + i);
  track.mark(1000, 1001, way.none);
  const levels = new Levels(track);
  levels.grow();
  const down = new Vector3(0, 0, -1);
  // Segments within 0.17 mm along the path are as near; none of the 1000 that lie lower.
  const met = levels.metBy(new Ray(new Vector3(50.05, 0.1, 100), down), 0.2);
  expect(Math.abs(met - 501)).toBeLessThanOrEqual(2);
  expect(levels.metBy(new Ray(new Vector3(50.05, 1, 100), down), 0.2)).toBe(-1);
});

test('pictures get fewer pixels where they take long, and all of them where they do not', () => {
  const full = 1280 * 800;
  const slow = new Sharpness();
  expect(slow.share(full)).toBe(0.5);
  for (let i = 0; i < 50; ++i) slow.took(80);
  expect(slow.share(full)).toBeLessThan(0.3);
  const fast = new Sharpness();
  fast.share(full);
  for (let i = 0; i < 50; ++i) fast.took(17);
  expect(fast.share(full)).toBe(1);
});

test('their size changes seldom, for it is waited for', () => {
  const full = 1280 * 800;
  const sharpness = new Sharpness();
  const sizes: number[] = [];
  // Half the pixels are drawn fast enough here, more are not, and now and then something else is in the way.
  for (let i = 0; i < 2000; ++i) {
    const share = sharpness.share(full);
    if (share !== sizes.at(-1)) sizes.push(share);
    sharpness.took(i % 20 === 0 || share > 0.5 ? 60 : 15);
  }
  expect(sizes.length).toBeLessThan(20);
  expect(Math.min(...sizes)).toBe(0.5);
});
