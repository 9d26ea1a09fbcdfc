// Whether the status that is shown is of now: its age when it was sent, and the time since it came.

/** Behind this the values are shown as old ones. */
export const oldAfter_ms = 300;

export class Freshness {
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly changed: (isOld: boolean) => void) {}

  /** A status has come that is from so long ago. */
  came(age_ms: number): void {
    clearTimeout(this.#timer);
    const left_ms = oldAfter_ms - age_ms;
    this.changed(left_ms <= 0);
    if (left_ms > 0) this.#timer = setTimeout(() => this.#wait(), left_ms);
  }

  // Where the page itself stood still, what came meanwhile waits behind this: it goes first.
  #wait(): void {
    this.#timer = setTimeout(() => this.changed(true));
  }
}
