// When pictures are drawn: when something has changed, one after the other, and no other begins before the one before is
// done, so that none pile up where drawing takes long. What a picture needs is made ready by slices, between which a press on
// hold or stop is heard. While things change they are as sharp as is fast enough; when nothing has changed for a moment comes one
// that is as sharp as the screen.
import { Sharpness } from './sharpness';

const moment_ms = 250;
const slice_ms = 8;

/** Draws; says how many pixels a picture has that is as sharp as the screen. */
export interface Easel {
  fullPixels(): number;
  /** Makes ready what the next picture needs, until a time (performance.now()); true when that is all. */
  prepare(until: number): boolean;
  /** share: of the width and height of such a picture. True when it has that size already. */
  fit(share: number): boolean;
  draw(stands: boolean): void;
  gl(): WebGL2RenderingContext;
}

export class PicturePace {
  readonly #sharpness = new Sharpness();
  #asked = false;
  #busy = false;
  #closed = false;
  #standing: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly easel: Easel) {}

  /** Something has changed. */
  wake(): void {
    clearTimeout(this.#standing);
    this.#asked = true;
    if (this.#busy || this.#closed) return;
    this.#busy = true;
    requestAnimationFrame(() => this.#prepare());
  }

  #prepare(): void {
    if (this.#closed) return;
    if (!this.easel.prepare(performance.now() + slice_ms))
      return void setTimeout(() => this.#prepare());
    this.#asked = false;
    this.#move();
  }

  /** Of the width and height, in the next picture. */
  share(): number {
    return this.#sharpness.share(this.easel.fullPixels());
  }

  close(): void {
    this.#closed = true;
    clearTimeout(this.#standing);
  }

  #move(): void {
    this.#whenFitted(this.share(), () => {
      this.easel.draw(false);
      this.#whenDone((time_ms) => this.#sharpness.took(time_ms));
    });
  }

  // Another size may take as long as a picture: what waits for the thread goes between them.
  #whenFitted(share: number, then: () => void): void {
    if (this.easel.fit(share)) return then();
    setTimeout(() => {
      if (!this.#closed) then();
    });
  }

  #stand(): void {
    if (this.#busy || this.#closed) return;
    if (!this.easel.prepare(performance.now() + slice_ms)) return this.wake();
    this.#busy = true;
    this.#whenFitted(1, () => {
      this.easel.draw(true);
      this.#whenDone(() => undefined, 'stands');
    });
  }

  #whenDone(then: (time_ms: number) => void, how: 'moves' | 'stands' = 'moves'): void {
    const began = performance.now();
    const gl = this.easel.gl();
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = (): void => {
      if (this.#closed) return;
      const isDone =
        fence === null ||
        gl.isContextLost() ||
        gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
      if (!isDone) return void requestAnimationFrame(look);
      gl.deleteSync(fence);
      this.#busy = false;
      then(performance.now() - began);
      if (this.#asked) this.wake();
      else if (how === 'moves') this.#standing = setTimeout(() => this.#stand(), moment_ms);
    };
    requestAnimationFrame(look);
  }
}
