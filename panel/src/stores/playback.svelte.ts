// A log on a time line: its path, where the tip was at a time, and forward and backward through it.
import { loggedKind, type GeometryPage } from '../geometry/page_frame';
import { Track } from '../geometry/track';
import type { Result } from '../rpc/json_rpc';
import { store } from './machine.svelte';
import { PageFrames } from './page_frames';

type Verdict = Result<'history.verify'>;

/** What is said of a page besides the frame that it comes in: from which point on which line ran. */
interface Geometry {
  lines: [number, number][];
}

/** The last index whose time is not later; -1 before the first one. Times ascend. */
export function indexAt(times: readonly number[] | Uint32Array, time: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((times[middle] ?? 0) <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

class Playback {
  /** The log that is shown; empty: none is. */
  file = $state('');
  points = $state(0);
  length_s = $state(0);
  time_s = $state(0);
  /** 1: as the machine went; below 0: backward; 0: it stands. */
  speed = $state(0);
  /** Where verifying found the first difference, or the log's end of what can be repeated. */
  stopped_s = $state<number | null>(null);
  /** For how long the places of the log are not known. */
  leftOut_s = $state(0);
  readonly track = new Track();
  #times: number[] = [];
  #stopTicking: (() => void) | null = null;
  #opened = 0;
  #opening: Promise<unknown> = Promise.resolve();

  readonly index = $derived(
    this.points > 0 ? Math.max(0, indexAt(this.#times, this.time_s * 1000)) : 0,
  );

  /** The line of the program at the time that is shown. */
  get line(): number {
    return this.track.lines[this.index] ?? 0;
  }
  get place(): [number, number, number] {
    const at = 3 * this.index;
    const { points } = this.track;
    return [points[at] ?? 0, points[at + 1] ?? 0, points[at + 2] ?? 0];
  }

  /** Opens a log. The one that was opened last is shown: others give up at their next page, and are waited for,
   *  since their frames do not say of which log they are. */
  async open(file: string, channel: number, verdict: Verdict | null): Promise<void> {
    this.close();
    const mine = ++this.#opened;
    const before = this.#opening;
    const opening = before.then(() => this.#read(mine, file, channel, verdict));
    this.#opening = opening.catch(() => undefined);
    await opening;
  }

  async #read(mine: number, file: string, channel: number, verdict: Verdict | null): Promise<void> {
    const frames = new PageFrames(loggedKind);
    const stop = frames.listen();
    let first = 0;
    try {
      for (let page = 0, pages = 1; page < pages; ++page) {
        if (mine !== this.#opened) return;
        const answer = await store.call('history.path', { file, channel, page, system: 'part' });
        const points = await frames.next(page);
        if (mine !== this.#opened) return;
        this.#append(points, (answer.geometry as Geometry).lines);
        ({ pages, time_s: this.length_s, left_out_s: this.leftOut_s, first_cycle: first } = answer);
      }
    } finally {
      stop();
    }
    const cycle_s = (store.machine?.cycle_us ?? 1000) / 1e6;
    const end = verdict?.difference as { cycle: number } | null | undefined;
    const stopped = end?.cycle ?? verdict?.lost_from_cycle ?? null;
    this.stopped_s = stopped === null ? null : (stopped - first) * cycle_s;
    this.points = this.track.count;
    this.time_s = this.stopped_s ?? 0;
    this.file = file;
  }

  close(): void {
    ++this.#opened;
    this.play(0);
    this.file = '';
    this.points = 0;
    this.#times = [];
    this.track.clear();
  }

  /** Goes through the log at a multiple of the machine's pace until its end. */
  play(speed: number): void {
    this.speed = speed;
    this.#stopTicking?.();
    this.#stopTicking = null;
    if (speed === 0) return;
    if (speed > 0 && this.time_s >= this.length_s) this.time_s = 0;
    let last = performance.now();
    let frame = 0;
    const tick = (now: number): void => {
      const wanted = this.time_s + (speed * (now - last)) / 1000;
      last = now;
      this.time_s = Math.min(this.length_s, Math.max(0, wanted));
      if (this.time_s === wanted) frame = requestAnimationFrame(tick);
      else this.play(0);
    };
    frame = requestAnimationFrame(tick);
    this.#stopTicking = () => cancelAnimationFrame(frame);
  }

  // The numbers of such a page are times; lines come as the points at which they begin.
  #append({ points, lines: times }: GeometryPage, begins: [number, number][]): void {
    const lines = new Uint32Array(times.length);
    begins.forEach(([from, line], i) => lines.fill(line, from, begins[i + 1]?.[0] ?? times.length));
    this.track.append(points, lines);
    for (const time of times) this.#times.push(time);
  }
}

export const playback = new Playback();
