// Segments of a track in the scene: pairs of its points, of which the draw range shows a part.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  LineSegments,
  Sphere,
  type LineBasicMaterial,
} from 'three';
import type { Pairs } from './pairs';
import type { Track } from './track';

/** What each point of a track has, in the graphics memory, shared by all that draws it. */
export class PointValues {
  #attribute: BufferAttribute | null = null;
  #uploaded = 0;
  #generation = -1;

  constructor(
    private readonly values: () => Float32Array | Uint8Array,
    private readonly each: number,
    private readonly isNormalized = false,
  ) {}

  static places(track: Track): PointValues {
    return new PointValues(() => track.points, 3);
  }

  /** Of all points. Only those that came since the last picture are sent there. */
  current({ count, generation }: Track): BufferAttribute {
    const values = this.values();
    if (generation !== this.#generation) this.replaced();
    this.#generation = generation;
    if (this.#attribute?.array !== values) {
      this.#attribute = new BufferAttribute(values, this.each, this.isNormalized);
    } else if (count !== this.#uploaded) {
      const first = count > this.#uploaded ? this.#uploaded : 0;
      this.#attribute.addUpdateRange(first * this.each, (count - first) * this.each);
      this.#attribute.needsUpdate = true;
    }
    this.#uploaded = count;
    return this.#attribute;
  }

  /** All are other values now. */
  replaced(): void {
    this.#uploaded = 0;
  }
}

/** A material of lines each of which has the colour of the point that it leads to, not one that runs from end to end. */
export function colouredByEnd(material: LineBasicMaterial): LineBasicMaterial {
  material.vertexColors = true;
  material.onBeforeCompile = (shader) => {
    const flat = 'flat varying vec4 vColor;';
    shader.vertexShader = shader.vertexShader.replace('#include <color_pars_vertex>', flat);
    shader.fragmentShader = shader.fragmentShader.replace('#include <color_pars_fragment>', flat);
  };
  return material;
}

export class TrackLine {
  readonly line: LineSegments;
  readonly #geometry = new BufferGeometry();
  #pairs: Pairs | null = null;
  #version = -1;

  /** `colours` where the material wants them. */
  constructor(
    private readonly track: Track,
    private readonly places: PointValues,
    material: LineBasicMaterial,
    private readonly colours: PointValues | null = null,
  ) {
    this.line = new LineSegments(this.#geometry, material);
    this.line.frustumCulled = false;
    // Else it is found anew of all points, only to put transparent bodies into order.
    this.#geometry.boundingSphere = new Sphere();
  }

  /** Shows the pairs that end behind one point and at or before another. */
  show(pairs: Pairs, after: number, upTo: number): void {
    this.#set('position', this.places);
    if (this.colours !== null) this.#set('color', this.colours);
    this.#index(pairs);
    const first = pairs.upTo(after);
    this.#geometry.setDrawRange(2 * first, 2 * (pairs.upTo(upTo) - first));
  }

  dispose(): void {
    this.#geometry.dispose();
  }

  // What is replaced leaves the graphics memory with the geometry only.
  #set(name: string, values: PointValues): void {
    const attribute = values.current(this.track);
    if (this.#geometry.getAttribute(name) === attribute) return;
    this.#geometry.dispose();
    this.#geometry.setAttribute(name, attribute);
  }

  #index(pairs: Pairs): void {
    if (this.#pairs === pairs && this.#version === pairs.version) return;
    this.#pairs = pairs;
    this.#version = pairs.version;
    const index = this.#geometry.index;
    if (index?.array === pairs.indices) {
      index.clearUpdateRanges();
      index.addUpdateRange(0, 2 * pairs.count);
      index.needsUpdate = true;
      return;
    }
    this.#geometry.dispose();
    this.#geometry.setIndex(new BufferAttribute(pairs.indices, 1).setUsage(DynamicDrawUsage));
  }
}
