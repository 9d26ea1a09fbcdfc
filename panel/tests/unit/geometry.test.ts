// Pages of geometry, the tracks that they fill, and how far the tool is along them.
import { expect, test } from 'vitest';
import { readPage } from '../../src/geometry/page_frame';
import { reached } from '../../src/geometry/progress';
import { PagedTrack, Track } from '../../src/geometry/track';

function frame(id: number, page: number, points: number[], lines: number[]): ArrayBuffer {
  const count = lines.length;
  const bytes = new ArrayBuffer(16 + count * 16);
  const view = new DataView(bytes);
  [1, id, page, count].forEach((value, i) => view.setUint32(4 * i, value, true));
  points.forEach((value, i) => view.setFloat32(16 + 4 * i, value, true));
  lines.forEach((value, i) => view.setUint32(16 + 12 * count + 4 * i, value, true));
  return bytes;
}

test('a page is read as it was written', () => {
  const page = readPage(frame(7, 2, [1, 2, 3, 4, 5, 6.5], [10, 11]));
  expect(page).toMatchObject({ kind: 1, id: 7, page: 2 });
  expect([...(page?.points ?? [])]).toEqual([1, 2, 3, 4, 5, 6.5]);
  expect([...(page?.lines ?? [])]).toEqual([10, 11]);
});

test('a frame of another length is not read', () => {
  const whole = frame(7, 0, [1, 2, 3], [10]);
  expect(readPage(whole.slice(0, 12))).toBeNull();
  expect(readPage(whole.slice(0, 28))).toBeNull();
  expect(readPage(new ArrayBuffer(0))).toBeNull();
});

test('a track keeps 173,103 points and their lines', () => {
  const track = new Track();
  const count = 173_103;
  for (let i = 0; i < count; ++i) track.add(i, 1 - i, i / 2, i + 1);
  expect(track.count).toBe(count);
  expect(track.points[3 * 1000]).toBe(1000);
  expect(track.points[3 * 172_000 + 1]).toBe(-171_999);
  expect(track.lines[count - 1]).toBe(count);
  expect(track.bounds()).toEqual({
    low: [1, 2 - count, 0.5],
    high: [count - 1, 0, (count - 1) / 2],
  });
  track.halve();
  expect(track.count).toBe(count - (count >> 1));
  expect(track.lines[0]).toBe((count >> 1) + 1);
});

const page = (value: number): { points: Float32Array; lines: Uint32Array } => ({
  points: new Float32Array([value, value, value]),
  lines: new Uint32Array([value]),
});

test('pages come into place in whatever order they arrive; those of another path do not', () => {
  const paged = new PagedTrack();
  paged.expect(5);
  for (const one of [0, 1, 2]) paged.say(5, one, {});
  expect(paged.take(5, 1, page(2))).toBe(0);
  expect(paged.take(4, 0, page(9))).toBe(0);
  expect(paged.take(5, 0, page(1))).toBe(2);
  expect(paged.take(5, 0, page(8))).toBe(0);
  expect(paged.take(5, 2, page(3))).toBe(1);
  expect([...paged.track.lines.subarray(0, paged.track.count)]).toEqual([1, 2, 3]);
  paged.expect(6);
  expect(paged.track.count).toBe(0);
});

test('a page of an earlier path that comes late keeps no later one away', () => {
  const paged = new PagedTrack();
  const one = { points: new Float32Array(3), lines: new Uint32Array(1) };
  paged.expect(5);
  paged.expect(6);
  expect(paged.take(5, 0, one)).toBe(0);
  paged.say(6, 0, {});
  expect(paged.take(6, 0, one)).toBe(1);
});

test('a page comes into place when its points and what leads to them are known', () => {
  const paged = new PagedTrack();
  const three = { points: new Float32Array(9), lines: new Uint32Array(3) };
  paged.expect(5);
  expect(paged.say(5, 1, { rapid: [[1, 2]] })).toBe(0);
  expect(paged.take(5, 0, three)).toBe(0);
  expect(paged.take(5, 1, three)).toBe(0);
  expect(paged.say(5, 0, { begins: [[0, 1]] })).toBe(6);
  expect([...paged.track.ways.subarray(0, 6)]).toEqual([2, 0, 0, 0, 1, 0]);
});

test('progress is the nearest point of the line that runs, and never goes back', () => {
  const track = new Track();
  for (let line = 1; line <= 4; ++line) {
    for (let i = 0; i < 10; ++i) track.add(line * 10 + i, 0, 0, line);
  }
  const first = reached(track, 2, [23.2, 0, 0], 0);
  expect(first).toBe(13);
  expect(reached(track, 2, [20, 0, 0], first)).toBe(13);
  expect(reached(track, 4, [49, 0, 0], first)).toBe(39);
  expect(reached(track, 99, [0, 0, 0], first)).toBe(first);
});
