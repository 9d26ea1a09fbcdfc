// Colours of a path by feed and tool: what comes by pages lies at its points, and a legend names every colour once.
import { expect, test } from 'vitest';
import { FeedClasses, toolsOf } from '../../src/geometry/shades';
import { PagedTrack, Track } from '../../src/geometry/track';

const part = (count: number): { points: Float32Array; lines: Uint32Array } => ({
  points: new Float32Array(3 * count),
  lines: new Uint32Array(count),
});

test('feeds and tools of a page hold from their points on, and to its end', () => {
  const paged = new PagedTrack();
  paged.expect(1);
  paged.say(1, 0, {
    feeds: [
      [0, 0],
      [2, 500],
    ],
    tools: [[1, 7]],
  });
  paged.take(1, 0, part(4));
  paged.take(1, 1, part(3));
  paged.say(1, 1, {
    feeds: [[0, 800]],
    tools: [
      [0, 7],
      [2, 9],
    ],
  });
  const { feeds, tools, count } = paged.track;
  expect([...feeds.subarray(0, count)]).toEqual([0, 0, 500, 500, 800, 800, 800]);
  expect([...tools.subarray(0, count)]).toEqual([0, 7, 7, 7, 7, 7, 9]);
  expect(toolsOf(paged.track).map(({ value }) => value)).toEqual([0, 7, 9]);
});

function trackOf(feeds: number[]): Track {
  const track = new Track();
  feeds.forEach((feed, k) => {
    track.add(k, 0, 0, k);
    track.feeds[k] = feed;
  });
  return track;
}

test('few feeds have a colour each, the slowest and the fastest the ends of the ramp', () => {
  const classes = new FeedClasses(trackOf([0, 300, 1200, 300]));
  expect(classes.grow()).toBe(true);
  expect(classes.grow()).toBe(false);
  const legend = classes.legend();
  expect(legend.map(({ value }) => value)).toEqual([300, 1200]);
  expect(new Set(legend.map(({ colour }) => colour)).size).toBe(2);
  for (const { value, colour } of legend) expect(classes.colourOf(value)).toBe(colour);
});

test('many feeds fall into five classes of equal width', () => {
  const track = trackOf(Array.from({ length: 101 }, (_, k) => 100 + k));
  const classes = new FeedClasses(track);
  classes.grow();
  const legend = classes.legend();
  expect(legend.map(({ value }) => value)).toEqual([120, 140, 160, 180, 200]);
  expect(classes.colourOf(100)).toBe(legend[0]?.colour);
  expect(classes.colourOf(120.5)).toBe(legend[1]?.colour);
  expect(classes.colourOf(200)).toBe(legend[4]?.colour);
  track.clear();
  expect(classes.grow()).toBe(true);
  expect(classes.legend()).toEqual([]);
});
