// Segments of a track in the scene: pairs of its points, of which the draw range shows a part.
import {
  BufferAttribute,
  BufferGeometry,
  LineSegments,
  type LineBasicMaterial,
  type Raycaster,
} from 'three';
import type { Pairs } from './segments';
import type { Track } from './track';

/** The points of a track in the graphics memory, shared by all that draws it. */
export class TrackPoints {
  #attribute: BufferAttribute | null = null;
  #uploaded = 0;

  constructor(private readonly track: Track) {}

  /** Only the points that came since the last picture are sent there. */
  current(): BufferAttribute {
    const { track } = this;
    if (this.#attribute?.array !== track.points) {
      this.#attribute = new BufferAttribute(track.points, 3);
    } else if (track.count !== this.#uploaded) {
      const first = track.count > this.#uploaded ? this.#uploaded : 0;
      this.#attribute.addUpdateRange(first * 3, (track.count - first) * 3);
      this.#attribute.needsUpdate = true;
    }
    this.#uploaded = track.count;
    return this.#attribute;
  }
}

export class TrackLine {
  readonly line: LineSegments;
  readonly #geometry = new BufferGeometry();
  #pairs: Pairs | null = null;
  #indices: Uint32Array | null = null;
  #count = 0;

  constructor(
    private readonly points: TrackPoints,
    material: LineBasicMaterial,
  ) {
    this.line = new LineSegments(this.#geometry, material);
    this.line.frustumCulled = false;
  }

  /** Shows the pairs that end behind one point and at or before another. */
  show(pairs: Pairs, after: number, upTo: number): void {
    this.#geometry.setAttribute('position', this.points.current());
    if (this.#indices !== pairs.indices || this.#count !== pairs.count || this.#pairs !== pairs) {
      this.#pairs = pairs;
      this.#indices = pairs.indices;
      this.#count = pairs.count;
      this.#geometry.setIndex(new BufferAttribute(pairs.indices, 1));
    }
    const first = pairs.upTo(after);
    this.#geometry.setDrawRange(2 * first, 2 * (pairs.upTo(upTo) - first));
  }

  /** The points whose segments a ray meets, with the distance from its origin. */
  met(ray: Raycaster): { distance: number; point: number }[] {
    this.#geometry.boundingSphere = null;
    return ray.intersectObject(this.line, false).map(({ distance, index = 0 }) => ({
      distance,
      point: this.#indices?.[index + 1] ?? -1,
    }));
  }

  dispose(): void {
    this.#geometry.dispose();
  }
}
