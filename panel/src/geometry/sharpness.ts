// How sharp pictures are that follow each other: as sharp as can be drawn fast enough here. Where a graphics processor
// draws, that is as sharp as one that stands; where a processor has to draw, fewer pixels for as long as things move.

const slow_ms = 40;
const fast_ms = 25;
const atFirst_px = 350_000;
const least_px = 60_000;

export class Sharpness {
  #pixels = atFirst_px;

  /** The share of the width and height of a picture that has so many pixels. */
  share(pixels: number): number {
    return Math.min(1, Math.sqrt(this.#pixels / Math.max(1, pixels)));
  }

  /** A picture of so many pixels took so long. */
  took(time_ms: number, pixels: number): void {
    if (time_ms > slow_ms) this.#pixels = Math.max(least_px, Math.min(this.#pixels, pixels) * 0.8);
    else if (time_ms < fast_ms && pixels >= 0.9 * this.#pixels) this.#pixels *= 1.15;
  }
}
