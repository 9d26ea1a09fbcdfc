// How far the machine is along a planned path: the part of it that is drawn as done.
import type { Track } from './track';

const window_points = 4000;

function distance2(track: Track, index: number, at: readonly [number, number, number]): number {
  const [x, y, z] = at;
  const dx = (track.points[index * 3] ?? 0) - x;
  const dy = (track.points[index * 3 + 1] ?? 0) - y;
  const dz = (track.points[index * 3 + 2] ?? 0) - z;
  return dx * dx + dy * dy + dz * dz;
}

/** The index of the point that the tool has reached, not before `from`: within the line that runs,
    the point that is nearest to the tool. `from` again when the line does not lie ahead. */
export function reached(
  track: Track,
  line: number,
  at: readonly [number, number, number],
  from: number,
): number {
  const first = track.indexOfLine(line, from);
  if (first < 0) return from;
  let best = first;
  let nearest = Infinity;
  const end = Math.min(track.count, first + window_points);
  for (let i = first; i < end && track.lines[i] === line; ++i) {
    const far = distance2(track, i, at);
    if (far < nearest) {
      nearest = far;
      best = i;
    }
  }
  return best;
}
