// Frames with the points of a page: each comes behind the answer that says what it is, and is waited for by
// who asked for the page.
import { readPage, type GeometryPage } from '../geometry/page_frame';
import { store } from './machine.svelte';

const patience_ms = 5000;

export class PageFrames {
  readonly #waiting = new Map<number, (page: GeometryPage) => void>();

  constructor(private readonly kind: number) {}

  /** Listens until the function that it gives back is called. */
  listen(): () => void {
    return store.onFrame((frame) => this.take(frame));
  }

  take(frame: ArrayBuffer): void {
    const page = readPage(frame);
    if (page === null || page.kind !== this.kind) return;
    this.#waiting.get(page.page)?.(page);
    this.#waiting.delete(page.page);
  }

  /** The frame of the page that is being asked for. Refused when none comes: the connection has gone. */
  next(page: number): Promise<GeometryPage> {
    return new Promise((resolve, reject) => {
      this.#waiting.set(page, resolve);
      setTimeout(() => {
        if (this.#waiting.get(page) !== resolve) return;
        this.#waiting.delete(page);
        reject(new Error('the points of a page have not come'));
      }, patience_ms);
    });
  }
}
