// Where the tip was at a time of a log, and logs that are opened while others are still read.
import { afterEach, expect, test, vi } from 'vitest';
import { store } from '../../src/stores/machine.svelte';
import { indexAt, playback } from '../../src/stores/playback.svelte';

test('the last point that is not later', () => {
  const times = [0, 10, 10, 25, 40];
  expect([-1, 0, 9, 10, 24, 25, 100].map((time) => indexAt(times, time))).toEqual([
    -1, 0, 0, 2, 2, 3, 4,
  ]);
  expect(indexAt([], 5)).toBe(-1);
});

// A server that answers when it is told to: two pages a log, each with one point whose X says the log.
class Server {
  readonly #takes: ((frame: ArrayBuffer) => void)[] = [];
  readonly #waiting: (() => void)[] = [];

  constructor() {
    vi.spyOn(store, 'onFrame').mockImplementation((take) => {
      this.#takes.push(take);
      return () => this.#takes.splice(this.#takes.indexOf(take), 1);
    });
    vi.spyOn(store, 'call').mockImplementation(
      ((_: string, params: { file: string; page: number }) =>
        new Promise((resolve) => {
          this.#waiting.push(() => {
            resolve({
              pages: 2,
              time_s: 1,
              left_out_s: 0,
              first_cycle: 0,
              geometry: { lines: [] },
            });
            const frame = this.#page(Number(params.file), params.page);
            setTimeout(() => [...this.#takes].forEach((take) => take(frame)));
          });
        })) as unknown as typeof store.call,
    );
  }

  async answer(): Promise<void> {
    this.#waiting.shift()?.();
    await new Promise((resolve) => setTimeout(resolve, 2));
  }
  get waits(): number {
    return this.#waiting.length;
  }

  #page(log: number, page: number): ArrayBuffer {
    const bytes = new ArrayBuffer(32);
    new Uint32Array(bytes, 0, 4).set([3, 0, page, 1]);
    new Float32Array(bytes, 16, 3).set([log, 0, 0]);
    return bytes;
  }
}

afterEach(() => {
  playback.close();
  vi.restoreAllMocks();
});

test('a log that is opened while another one is read is shown alone', async () => {
  const server = new Server();
  const first = playback.open('1', 1, null);
  await server.answer();
  const second = playback.open('2', 1, null);
  while (server.waits > 0) await server.answer();
  await Promise.all([first, second]);
  expect(playback.file).toBe('2');
  expect([...playback.track.points.slice(0, 6)]).toEqual([2, 0, 0, 2, 0, 0]);
  expect(playback.points).toBe(2);
});

test('a log that is closed while it is read does not come', async () => {
  const server = new Server();
  const opening = playback.open('1', 1, null);
  await server.answer();
  playback.close();
  while (server.waits > 0) await server.answer();
  await opening;
  expect(playback.file).toBe('');
  expect(playback.points).toBe(0);
});
