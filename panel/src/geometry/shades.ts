// In which colours the moves at feed of a path are drawn: all alike, by their feed, or by their tool.
import { colourOfTool } from './tool_colours';
import type { Track } from './track';

/** One colour of a legend. */
export interface Shade {
  colour: string;
  /** A tool, or the greatest feed of the class in mm/min. */
  value: number;
}

// From slow to fast, told apart without red and green.
const ramp = ['#4575b4', '#74add1', '#c79a2b', '#f46d43', '#d73027'];

/** Classes of feed: each of its own where they are few, else of equal width. Grows with the track. */
export class FeedClasses {
  #bounds: number[] = [];
  #seen = new Set<number>();
  #range: [number, number] = [Infinity, -Infinity];
  #generation = -1;
  #known = 0;

  constructor(private readonly track: Track) {}

  /** True when the classes are others now. */
  grow(): boolean {
    const { track } = this;
    if (track.generation !== this.#generation || track.count < this.#known) this.#begin();
    for (; this.#known < track.count; ++this.#known) {
      const feed = track.feeds[this.#known] ?? 0;
      if (feed <= 0) continue;
      if (this.#seen.size <= ramp.length) this.#seen.add(feed);
      this.#range = [Math.min(this.#range[0], feed), Math.max(this.#range[1], feed)];
    }
    const before = this.#bounds;
    this.#bounds = this.#boundsNow();
    return before.join() !== this.#bounds.join();
  }

  colourOf(feed: number): string {
    const found = this.#bounds.findIndex((bound) => feed <= bound);
    return this.#colour(found < 0 ? this.#bounds.length - 1 : found);
  }

  legend(): Shade[] {
    return this.#bounds.map((value, k) => ({ value, colour: this.#colour(k) }));
  }

  #begin(): void {
    this.#generation = this.track.generation;
    this.#seen.clear();
    this.#range = [Infinity, -Infinity];
    this.#known = 0;
  }

  #boundsNow(): number[] {
    if (this.#seen.size <= ramp.length) return [...this.#seen].sort((a, b) => a - b);
    const [low, high] = this.#range;
    return ramp.map((_, k) => low + ((high - low) * (k + 1)) / ramp.length);
  }

  // Few classes are as far apart as they can be.
  #colour(index: number): string {
    const steps = Math.max(1, this.#bounds.length - 1);
    return ramp[Math.round((index * (ramp.length - 1)) / steps)] ?? '';
  }
}

/** The tools of a track, rising. */
export function toolsOf({ tools, count }: Track): Shade[] {
  const numbers = [...new Set(tools.subarray(0, count))].sort((a, b) => a - b);
  return numbers.map((value) => ({ value, colour: colourOfTool(value) }));
}
