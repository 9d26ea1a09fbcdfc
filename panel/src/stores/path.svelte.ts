// The path of the chosen channel: planned, by pages, when the daemon has it, and the trace of the live
// positions. The points stay outside of the framework; what it watches is only how many there are.
import type { Carried } from '../geometry/pose';
import type { Lie, Standpoint } from '../geometry/path_scene';
import { pathKind, readPage } from '../geometry/page_frame';
import { reached } from '../geometry/progress';
import { PagedTrack, Track, type PageWays } from '../geometry/track';
import { store, type Channel } from './machine.svelte';

/** What is said of a page of points besides the frame that they come in. */
interface Geometry extends PageWays {
  id: number;
  page: number;
}

/** docs/reference/protocol.md, program.path */
type GivenUp = 'computing_time' | 'machine_time' | 'points' | 'refused' | 'failed' | 'replaced';

const tracedAtMost = 200_000;
const stillness_mm = 0.005;
const again_ms = 500;
const after_refusal_ms = 2000;

const pause = (time_ms: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, time_ms));

/** Of the tool on the part; before the daemon knows it, the programmed point, never the words for it. */
export function tipOf({ on_part, point_W: point = {} }: Channel): [number, number, number] {
  const [x, y, z] = on_part?.tip ?? [point['X'], point['Y'], point['Z']];
  return [x ?? 0, y ?? 0, z ?? 0];
}

export class PathFollower {
  readonly plan = new PagedTrack();
  readonly trace = new Track();
  /** Points of the planned path; 0 while there is none. */
  planned = $state(0);
  done = $state(0);
  /** The planned path goes on behind what is drawn. */
  isComing = $state(false);
  /** Why the planned path does not lead to the end of the program; null: it does, or it still grows. */
  givenUp = $state<GivenUp | null>(null);
  /** The part system, in which the path lies; null: not known. */
  part = $state.raw<Carried | null>(null);
  /** What the path belongs to: as long as it is the same, the picture is seen from where it was. */
  of = '';
  /** From where the picture was seen when another view was opened. */
  readonly standpoints: Partial<Record<Lie, Standpoint>> = {};
  #run = '';
  #asked = '';
  #last: [number, number, number] = [NaN, NaN, NaN];

  /** Looks at what a channel does now; true when the tool has moved. */
  follow(channel: Channel): boolean {
    this.#askPlan(channel);
    const [X, Y, Z] = tipOf(channel);
    const line = channel.line ?? 0;
    this.done = this.planned > 0 ? reached(this.plan.track, line, [X, Y, Z], this.done) : 0;
    const [x, y, z] = this.#last;
    if (Math.hypot(X - x, Y - y, Z - z) < stillness_mm) return false;
    this.#last = [X, Y, Z];
    if (this.trace.count >= tracedAtMost) this.trace.halve();
    this.trace.add(X, Y, Z, line);
    return true;
  }

  clear(): void {
    this.trace.clear();
    this.#last = [NaN, NaN, NaN];
  }

  take(frame: ArrayBuffer): void {
    const page = readPage(frame);
    if (page === null || page.kind !== pathKind) return;
    this.plan.take(page.id, page.page, page);
    this.planned = this.plan.track.count;
  }

  // Every run has a trace of its own. The daemon plans anew when the program or a table is another one.
  #askPlan({ id, program, scheme = 0, run = 0, planned_path: plan }: Channel): void {
    this.of = `${id} ${program ?? ''}`;
    const traced = `${this.of} ${scheme} ${run}`;
    if (traced !== this.#run) this.clear();
    this.#run = traced;
    const wanted = plan == null ? '' : `${id} ${plan}`;
    if (wanted === this.#asked) return;
    this.#asked = wanted;
    this.plan.expect(plan ?? null);
    this.planned = this.done = 0;
    this.givenUp = null;
    this.part = null;
    this.isComing = plan != null;
    if (plan != null) void this.#readPlan(wanted, id, plan);
  }

  // The daemon makes the path in the background: pages that are not there yet are asked for again.
  async #readPlan(wanted: string, channel: number, plan: number): Promise<void> {
    try {
      for (let page = 0; wanted === this.#asked;) {
        const answer = await store.call('program.path', { channel, page, system: 'part' });
        if (wanted !== this.#asked) return;
        if (answer.id !== plan) {
          // There is a newer one, and the next status says so.
          await pause(again_ms);
          continue;
        }
        this.part ??= answer.part;
        if (answer.geometry != null && page < answer.pages) {
          const geometry = answer.geometry as Geometry;
          this.plan.say(geometry.id, geometry.page, geometry);
          this.planned = this.plan.track.count;
          page += 1;
        } else if (answer.complete || answer.given_up !== null) {
          this.givenUp = answer.given_up as GivenUp | null;
          this.isComing = false;
          return;
        } else {
          await pause(again_ms);
        }
      }
    } catch {
      this.isComing = false;
      // Lost or refused: the trace is drawn in its place, and the path is asked for again.
      await pause(after_refusal_ms);
      if (wanted === this.#asked) this.#asked = 'again';
    }
  }
}

export const follower = new PathFollower();
store.onFrame((frame) => follower.take(frame));
