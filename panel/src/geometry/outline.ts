// Fewer points for the same picture: the points of a track that are needed so that no other is further
// than a tolerance from the line that is drawn, and where what leads to them changes. It grows with the track, a page at a time.
import type { Track } from './track';

const skippedAtMost = 48;

export class Outline {
  /** Indices of the points that are kept, rising; the last one is the last point of the track. */
  indices: Uint32Array = new Uint32Array(1024);
  count = 0;
  /** The first points that are final: the others are found anew when points are added. */
  #final = 0;

  constructor(
    private readonly track: Track,
    private readonly tolerance_mm: number,
  ) {}

  /** Takes in what was added to the track. */
  grow(): void {
    const { track } = this;
    this.count = this.#final;
    let anchor = this.count > 0 ? (this.indices[this.count - 1] ?? 0) : 0;
    if (track.count > 0 && this.count === 0) this.#keep(0);
    while (anchor < track.count - 1) {
      const next = this.#furthest(anchor);
      if (next + skippedAtMost < track.count) this.#final = this.count + 1;
      this.#keep(next);
      anchor = next;
    }
  }

  /** How many of the kept points lie at or before a point of the track. */
  upTo(index: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.indices[middle] ?? 0) <= index) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #keep(index: number): void {
    if (this.count === this.indices.length) {
      const larger = new Uint32Array(this.indices.length * 2);
      larger.set(this.indices);
      this.indices = larger;
    }
    this.indices[this.count] = index;
    this.count += 1;
  }

  // The last point that a straight line from the anchor may reach.
  #furthest(anchor: number): number {
    const end = Math.min(this.track.count - 1, anchor + skippedAtMost);
    let best = anchor + 1;
    const { ways } = this.track;
    for (let to = anchor + 2; to <= end; ++to) {
      if (ways[to] !== ways[to - 1] || !this.#isStraight(anchor, to)) break;
      best = to;
    }
    return best;
  }

  #isStraight(from: number, to: number): boolean {
    for (let i = from + 1; i < to; ++i) {
      if (this.#offset2(i, from, to) > this.tolerance_mm * this.tolerance_mm) return false;
    }
    return true;
  }

  // The square of the distance of a point from the line between two others.
  #offset2(index: number, from: number, to: number): number {
    const p = this.track.points;
    const at = (point: number, axis: number): number => p[3 * point + axis] ?? 0;
    let along = 0;
    let length2 = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const edge = at(to, axis) - at(from, axis);
      along += (at(index, axis) - at(from, axis)) * edge;
      length2 += edge * edge;
    }
    const share = length2 > 0 ? Math.min(1, Math.max(0, along / length2)) : 0;
    let sum = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const foot = at(from, axis) + share * (at(to, axis) - at(from, axis));
      sum += (at(index, axis) - foot) ** 2;
    }
    return sum;
  }
}
