// How sharp pictures are that follow each other: as sharp as can be drawn fast enough here. Where a graphics processor
// draws, that is as sharp as one that stands; where a processor has to draw, fewer pixels for as long as things move.
//
// A picture of another size is waited for by the thread of the page: there are few sizes, and they change seldom.

const slow_ms = 40;
const fast_ms = 25;
const atFirst_px = 350_000;
/** Of the width and height of a picture that stands. */
const shares = [1, 0.7, 0.5, 0.35, 0.25] as const;
/** One after the other, before there are fewer pixels, or more. */
const slowOnes = 3;
const fastOnesAtFirst = 12;
const fastOnesAtMost = 400;

export class Sharpness {
  #step: number | null = null;
  #slow = 0;
  #fast = 0;
  #fastOnes = fastOnesAtFirst;

  /** The share of the width and height of a picture that has so many pixels. */
  share(pixels: number): number {
    this.#step ??= stepWithin(pixels);
    return shares[this.#step] ?? 1;
  }

  /** A picture that moves took so long. */
  took(time_ms: number): void {
    this.#slow = time_ms > slow_ms ? this.#slow + 1 : 0;
    this.#fast = time_ms < fast_ms ? this.#fast + 1 : 0;
    if (this.#slow >= slowOnes) {
      // Where more pixels were too many, they are tried again later and later.
      this.#fastOnes = Math.min(2 * this.#fastOnes, fastOnesAtMost);
      this.#go(1);
    } else if (this.#fast >= this.#fastOnes) this.#go(-1);
  }

  #go(steps: 1 | -1): void {
    this.#slow = this.#fast = 0;
    this.#step = Math.min(Math.max((this.#step ?? 0) + steps, 0), shares.length - 1);
  }
}

function stepWithin(pixels: number): number {
  const found = shares.findIndex((share) => pixels * share * share <= atFirst_px);
  return found < 0 ? shares.length - 1 : found;
}
