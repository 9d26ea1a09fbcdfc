// The colour of each point of a track, which is that of what leads to it.
import type { Track } from './track';

export type Colour = readonly [red: number, green: number, blue: number];

/** Which colour a point has, of 0 to 255 each. */
export type Painter = (index: number) => Colour;

const eachTime = 1024;

export class PointColours {
  values = new Uint8Array(0);
  /** Another one whenever all are painted anew. */
  version = 0;
  #generation = -1;
  #painted = 0;

  constructor(
    private readonly track: Track,
    private painter: Painter,
  ) {}

  /** All points get other colours, of the same painter or another one. */
  repaint(painter = this.painter): void {
    this.painter = painter;
    this.#painted = 0;
  }

  /** Gives their colours to the points that came. False when the time `until` (performance.now()) has come before
      that. */
  grow(until = Infinity): boolean {
    const { track } = this;
    if (this.#generation !== track.generation || this.#painted > track.count) this.#painted = 0;
    this.#generation = track.generation;
    if (this.#painted === 0) this.version += 1;
    if (this.values.length < 3 * track.count) {
      const larger = new Uint8Array(track.lines.length * 3);
      larger.set(this.values);
      this.values = larger;
    }
    while (this.#painted < track.count) {
      if (performance.now() > until) return false;
      this.#paint(Math.min(this.#painted + eachTime, track.count));
    }
    return true;
  }

  #paint(end: number): void {
    for (let i = this.#painted; i < end; ++i) this.values.set(this.painter(i), 3 * i);
    this.#painted = end;
  }
}
