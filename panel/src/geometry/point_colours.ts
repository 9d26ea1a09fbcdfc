// The colour of each point of a track, which is that of what leads to it.
import type { Track } from './track';

export type Colour = readonly [red: number, green: number, blue: number];

/** Which colour a point has, of 0 to 255 each. */
export type Painter = (index: number) => Colour;

export class PointColours {
  values = new Uint8Array(0);
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

  /** Gives their colours to the points that came; true when all were painted anew. */
  grow(): boolean {
    const { track } = this;
    if (this.#generation !== track.generation || this.#painted > track.count) this.#painted = 0;
    this.#generation = track.generation;
    const isAnew = this.#painted === 0;
    if (this.values.length < 3 * track.count) {
      const larger = new Uint8Array(track.lines.length * 3);
      larger.set(this.values);
      this.values = larger;
    }
    for (let i = this.#painted; i < track.count; ++i) this.values.set(this.painter(i), 3 * i);
    this.#painted = track.count;
    return isAnew;
  }
}
