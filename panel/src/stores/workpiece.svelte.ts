// The workpiece of a channel while it is cut: triangles by bricks, of which only those that have changed
// are asked for again. The triangles stay outside of what the framework watches.
import type { Carried } from '../geometry/pose';
import { surfaceKind } from '../geometry/page_frame';
import { Refusal, type Result } from '../rpc/json_rpc';
import { store } from './machine.svelte';
import { PageFrames } from './page_frames';

type Surface = Result<'workpiece.surface'>;

/** What is said of a page of triangles besides the frame that they come in. */
interface Geometry {
  page: number;
  /** Number of the brick, its first corner, and the one behind its last. */
  bricks: [number, number, number][];
}

/** Who draws: three corners make a triangle, each with the number of the tool that made it, or with how
    far it is off the reference. */
export interface Shown {
  set(brick: number, corners: Float32Array, numbers: Uint32Array): void;
  clear(): void;
}

const period_ms = 400;

/** What a line by hand is called among the runs; it announces no blank. */
const byHand = 'MDI';
let greeting: unknown;
let cutters: Record<string, Promise<string | null>> = {};

/** The program that announced a workpiece, asked for when it is first seen: that of the newest run then. */
export function cutterOf(channel: number, workpiece: number): Promise<string | null> {
  // Another daemon counts anew.
  if (greeting !== store.hello) [greeting, cutters] = [store.hello, {}];
  return (cutters[`${channel} ${workpiece}`] ??= store.call('program.history').then(
    ({ runs }) => {
      const own = runs.filter((run) => run.channel === channel && run.program !== byHand);
      return own.at(-1)?.program ?? null;
    },
    () => null,
  ));
}

const pause = (time_ms: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, time_ms));

export class WorkpieceFollower {
  /** Which workpiece of the channel is shown; 0: none has been announced. */
  workpiece = $state(0);
  /** Cycles that the daemon was too late for: the part may be behind the machine. */
  leftOut = $state(0);
  /** The workpiece system in which its triangles lie. */
  base = $state.raw<Carried | null>(null);
  /** Not all of it has come yet: what is drawn is a piece of it. */
  isComing = $state(false);
  /** Why the surface does not come: of the reference, most often. */
  failed = $state('');
  #since = 0;
  readonly #frames = new PageFrames(surfaceKind);

  constructor(private readonly shown: Shown) {}

  /** Looks at the channel until the function that it gives back is called. `reference`: a file of the
      surface that the part is to have; none: ''. */
  follow(channel: number, reference = ''): () => void {
    let isOver = false;
    const stopFrames = this.#frames.listen();
    const look = async (): Promise<void> => {
      while (!isOver) {
        if (store.live) {
          await this.#look(
            { channel, ...(reference === '' ? {} : { reference }) },
            () => isOver,
          ).then(
            () => {
              if (!isOver) this.failed = '';
            },
            (error: unknown) => {
              if (isOver) return;
              this.#since = 0;
              this.failed = error instanceof Refusal ? error.message : '';
            },
          );
        }
        await pause(period_ms);
      }
    };
    // Later: who calls this from an effect must not depend on what it reads.
    void Promise.resolve().then(look);
    return () => {
      isOver = true;
      stopFrames();
    };
  }

  // All pages of what has changed; the version of the first one is known then. What comes when it is over
  // belongs to nobody: another look may have begun, which has nothing of it.
  async #look(
    asked: { channel: number; reference?: string },
    isOver: () => boolean,
  ): Promise<void> {
    let version: number | null = null;
    let from: number | null = 0;
    while (from !== null && !isOver()) {
      const known = { workpiece: this.workpiece, since: this.#since };
      const answer: Surface = await store.call('workpiece.surface', { ...asked, from, ...known });
      if (isOver()) return;
      if (answer.workpiece === null) return this.forget();
      if (answer.workpiece !== this.workpiece) {
        this.forget(answer.workpiece);
        version = null;
      } else if (known.since === 0 && from === 0) {
        // All comes anew, but for bricks in which there is nothing any more.
        this.shown.clear();
      }
      this.leftOut = answer.cycles_left_out;
      if (JSON.stringify(answer.base) !== JSON.stringify(this.base)) this.base = answer.base;
      version ??= answer.version;
      this.isComing = known.since === 0 && answer.next !== null;
      await this.#show(answer.geometry as Geometry, isOver);
      from = answer.next;
    }
    if (version !== null && !isOver()) this.#since = version;
  }

  async #show({ page, bricks }: Geometry, isOver: () => boolean): Promise<void> {
    const { points, lines } = await this.#frames.next(page);
    if (isOver()) return;
    for (const [brick, first, behind] of bricks) {
      this.shown.set(brick, points.slice(3 * first, 3 * behind), lines.slice(first, behind));
    }
  }

  /** Shows nothing any more; all is asked for anew, of whatever workpiece there is. */
  forget(next = 0): void {
    this.shown.clear();
    this.workpiece = next;
    this.isComing = false;
    this.#since = 0;
  }
}
