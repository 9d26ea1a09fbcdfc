// The segments of a track as pairs of points: those of feed and those of rapid moves apart, all of them,
// and fewer that look the same from a distance.
import { Outline } from './outline';
import { way, type Track } from './track';

const outlinedFrom = 20_000;
const pixelsAcross = 2500;

/** Pairs of indices of points, rising. */
export class Pairs {
  indices: Uint32Array = new Uint32Array(2048);
  count = 0;

  clear(): void {
    this.count = 0;
  }

  add(from: number, to: number): void {
    if (2 * this.count === this.indices.length) {
      const larger = new Uint32Array(this.indices.length * 2);
      larger.set(this.indices);
      this.indices = larger;
    }
    this.indices[2 * this.count] = from;
    this.indices[2 * this.count + 1] = to;
    this.count += 1;
  }

  /** How many pairs end at or before a point. */
  upTo(point: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.indices[2 * middle + 1] ?? 0) <= point) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}

export interface Drawn {
  feed: Pairs;
  rapid: Pairs;
}

const nothing = (): Drawn => ({ feed: new Pairs(), rapid: new Pairs() });

export class Segments {
  readonly whole = nothing();
  readonly coarse = nothing();
  #outline: Outline | null = null;
  #generation = -1;
  #grown = 0;

  constructor(private readonly track: Track) {}

  /** Takes in what has come; `size` is that of the picture in mm. */
  grow(size: number): void {
    const { track } = this;
    if (track.generation !== this.#generation) this.#begin();
    if (track.count === this.#grown) return;
    for (let i = Math.max(1, this.#grown); i < track.count; ++i) this.#add(this.whole, i - 1, i);
    this.#grown = track.count;
    if (track.count >= outlinedFrom) this.#outlineAll(size);
  }

  /** Fewer segments, where there are so many that it matters. */
  get seenFromAfar(): Drawn {
    return this.track.count >= outlinedFrom ? this.coarse : this.whole;
  }

  #begin(): void {
    this.#generation = this.track.generation;
    this.#outline = null;
    this.#grown = 0;
    for (const pairs of [this.whole, this.coarse]) {
      pairs.feed.clear();
      pairs.rapid.clear();
    }
  }

  #outlineAll(size: number): void {
    this.#outline ??= new Outline(this.track, size / pixelsAcross);
    this.#outline.grow();
    this.coarse.feed.clear();
    this.coarse.rapid.clear();
    const { indices, count } = this.#outline;
    for (let k = 1; k < count; ++k) this.#add(this.coarse, indices[k - 1] ?? 0, indices[k] ?? 0);
  }

  #add(into: Drawn, from: number, to: number): void {
    const how = this.track.ways[to];
    if (how === way.feed) into.feed.add(from, to);
    else if (how === way.rapid) into.rapid.add(from, to);
  }
}
