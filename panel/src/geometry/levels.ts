// Which segments of a track a picture shows: none of those that are out of view, and of the others as few as
// look the same at the distance from which they are seen. What is known of the track grows with it.
import { Box3, Vector3, type Frustum, type Ray } from 'three';
import type { Pairs } from './pairs';
import { levels, levelWithin, Stretch } from './stretch';
import { way, type Track } from './track';

const segmentsEach = 256;
const outOfView = 255;

/** From where, how exactly and with how many segments a picture is drawn. */
export interface Sight {
  frustum: Frustum;
  eye: Vector3;
  /** By how much a line may be off, in mm for each mm that it is away from the eye. */
  tolerance: number;
  segmentsAtMost: number;
}

const [a, b, onRay, met] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];

export class Levels {
  #stretches: Stretch[] = [];
  #generation = -1;
  #grown = 0;
  #chosen: Uint8Array = new Uint8Array(0);
  #shown = 0;

  constructor(private readonly track: Track) {}

  /** Takes in what was added to the track: only what came, and the stretch that was not full. False when the time
      `until` (performance.now()) has come before that. */
  grow(until = Infinity): boolean {
    const { track } = this;
    if (track.generation !== this.#generation) this.#begin();
    if (track.count === this.#grown) return true;
    this.#shown = 0;
    const last = this.#stretches.at(-1);
    if (last !== undefined && last.last - last.first < segmentsEach) this.#stretches.pop();
    for (let first = this.#stretches.at(-1)?.last ?? 0; first < track.count - 1;) {
      if (performance.now() > until) return false;
      const end = Math.min(first + segmentsEach, track.count - 1);
      this.#stretches.push(new Stretch(track, first, end));
      first = end;
    }
    this.#grown = track.count;
    return true;
  }

  /** Fills in the segments of a picture, unless they are the same as in the one before. */
  choose(sight: Sight, into: Pairs): void {
    const chosen = this.#choose(sight);
    const isSame = this.#shown === this.#stretches.length;
    if (isSame && chosen.every((level, k) => level === this.#chosen[k])) return;
    this.#chosen = chosen;
    this.#shown = this.#stretches.length;
    into.clear();
    this.#stretches.forEach((stretch, k) => {
      const level = chosen[k] ?? outOfView;
      if (level !== outOfView) into.append(stretch.pairs(level));
    });
  }

  /** The point whose segment a ray meets first, within a distance of it; -1 when there is none. */
  metBy(ray: Ray, within_mm: number): number {
    const box = new Box3();
    let nearest = Infinity;
    let found = -1;
    for (const stretch of this.#stretches) {
      if (!ray.intersectsBox(box.copy(stretch.box).expandByScalar(within_mm))) continue;
      for (let i = stretch.first + 1; i <= stretch.last; ++i) {
        if (this.track.ways[i] === way.none) continue;
        a.fromArray(this.track.points, 3 * (i - 1));
        b.fromArray(this.track.points, 3 * i);
        if (ray.distanceSqToSegment(a, b, onRay, met) > within_mm * within_mm) continue;
        const distance = onRay.distanceTo(ray.origin);
        if (distance < nearest) [nearest, found] = [distance, i];
      }
    }
    return found;
  }

  #begin(): void {
    this.#generation = this.track.generation;
    this.#stretches = [];
    this.#grown = 0;
    this.#shown = -1;
  }

  // Where these are too many, all of them coarser.
  #choose(sight: Sight): Uint8Array {
    const wanted = this.#wanted(sight);
    for (let coarser = 0; coarser < levels; ++coarser) {
      const chosen = wanted.map((level) =>
        level === outOfView ? outOfView : Math.min(levels - 1, level + coarser),
      );
      if (this.#count(chosen) <= sight.segmentsAtMost || coarser === levels - 1) return chosen;
    }
    return wanted;
  }

  #wanted({ frustum, eye, tolerance }: Sight): Uint8Array {
    return Uint8Array.from(this.#stretches, ({ box }) =>
      frustum.intersectsBox(box) ? levelWithin(tolerance * box.distanceToPoint(eye)) : outOfView,
    );
  }

  #count(chosen: Uint8Array): number {
    return this.#stretches.reduce(
      (sum, { counts }, k) => sum + (counts[chosen[k] ?? outOfView] ?? 0),
      0,
    );
  }
}
