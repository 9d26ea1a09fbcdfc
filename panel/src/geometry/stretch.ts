// A stretch of a track: some hundred points in a box, drawn with as few segments as the eye can tell from all.
//
// Level 0 has all its segments; each further one leaves out what lies within twice the tolerance of the
// one before: 0.01 mm, 0.02 mm, ... So a level is found without looking at the points again.
import { Box3, Vector3 } from 'three';
import { significance } from './significance';
import { way, type Track } from './track';

export const levels = 16;
const finest_mm = 0.01;

/** The coarsest level that is off by no more than so much. */
export function levelWithin(tolerance_mm: number): number {
  if (!(tolerance_mm >= finest_mm)) return 0;
  return Math.min(levels - 1, 1 + Math.floor(Math.log2(tolerance_mm / finest_mm)));
}

const point = new Vector3();

export class Stretch {
  readonly box = new Box3();
  /** How many segments a level has. */
  readonly counts = new Uint32Array(levels);
  /** Of each point behind the first, the last level that has it. */
  readonly #lastLevel: Uint8Array;
  readonly #pairs: (Uint32Array | undefined)[] = [];

  /** From its first point to its last one; the first is the last of the stretch before. */
  constructor(
    private readonly track: Track,
    readonly first: number,
    readonly last: number,
  ) {
    this.#lastLevel = new Uint8Array(last - first + 1);
    this.#weigh();
    for (let i = first; i <= last; ++i)
      this.box.expandByPoint(point.fromArray(track.points, 3 * i));
    for (let i = first + 1; i <= last; ++i) {
      if (track.ways[i] === way.none) continue;
      for (let k = this.#levelOf(i); k >= 0; --k) this.counts[k] = (this.counts[k] ?? 0) + 1;
    }
  }

  /** The segments of a level. */
  pairs(level: number): Uint32Array {
    return (this.#pairs[level] ??= this.#pairsOf(level));
  }

  #levelOf(index: number): number {
    return this.#lastLevel[index - this.first] ?? 0;
  }

  // What leads to points changes at some of them: these are the ends of lines that are thinned out.
  #weigh(): void {
    const { track, first, last } = this;
    const weights = new Float32Array(last - first + 1);
    let from = first;
    for (let i = first + 1; i <= last; ++i) {
      if (i < last && !track.turnsAt(i)) continue;
      significance(track.points, from, i, weights, first);
      from = i;
    }
    weights.forEach((weight, i) => (this.#lastLevel[i] = levelWithin(weight)));
  }

  #pairsOf(level: number): Uint32Array {
    const pairs = new Uint32Array(2 * (this.counts[level] ?? 0));
    let before = this.first;
    let filled = 0;
    for (let i = this.first + 1; i <= this.last; ++i) {
      if (this.#levelOf(i) < level) continue;
      if (this.track.ways[i] !== way.none) {
        pairs[filled] = before;
        pairs[filled + 1] = i;
        filled += 2;
      }
      before = i;
    }
    return pairs;
  }
}
