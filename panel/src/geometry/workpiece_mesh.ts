// The part in the picture: triangles by bricks, in the colour of the tool that made them, cut open by a
// plane where somebody wants to look inside.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
  Plane,
  Vector3,
} from 'three';
import type { Colour } from './point_colours';
import { between, type Carried } from './pose';
import { colourOfTool } from './tool_colours';

export interface Section {
  axis: 'X' | 'Y' | 'Z';
  /** Where it cuts, from one end of the part to the other. */
  part: number;
}

const normals = { X: [-1, 0, 0], Y: [0, 1, 0], Z: [0, 0, -1] } as const;

/** Which colour a corner has, by its number: of the tool that made it, or how far it is off. */
export type CornerPainter = (number: number) => string;

export class WorkpieceMesh {
  readonly group = new Group();
  readonly #numbers = new Map<number, Uint32Array>();
  #painter: CornerPainter = colourOfTool;
  readonly #bricks = new Map<number, Mesh<BufferGeometry, MeshLambertMaterial>>();
  readonly #material = new MeshLambertMaterial({
    vertexColors: true,
    flatShading: true,
    side: DoubleSide,
  });
  readonly #plane = new Plane();
  #section: Section | null = null;
  #triangles = 0;

  constructor(private readonly changed: () => void) {
    this.group.matrixAutoUpdate = false;
  }

  get triangles(): number {
    return this.#triangles;
  }

  set(brick: number, corners: Float32Array, numbers: Uint32Array): void {
    this.#remove(brick);
    if (numbers.length > 0) this.#add(brick, corners, numbers);
    this.#cut();
    this.changed();
  }

  clear(): void {
    if (this.#bricks.size === 0) return;
    for (const brick of [...this.#bricks.keys()]) this.#remove(brick);
    this.changed();
  }

  /** By what the surface has its colours from now on; null: by tool. */
  paint(painter: CornerPainter | null): void {
    this.#painter = painter ?? colourOfTool;
    for (const [brick, mesh] of this.#bricks) {
      mesh.geometry.setAttribute('color', this.#coloursOf(this.#numbers.get(brick)));
    }
    this.changed();
  }

  /** Its triangles lie in the system `own`, and are drawn in `part`. */
  lie(own: Carried | null, part: Carried | null): void {
    this.group.matrix.copy(between(own, part));
    this.group.updateMatrixWorld(true);
    this.turned();
    this.changed();
  }

  /** What it lies in has another place in the picture. */
  turned(): void {
    this.#cut();
  }

  section(section: Section | null): void {
    this.#section = section;
    this.#cut();
    this.changed();
  }

  /** Whether it is in the picture; it is kept all the same. */
  put(where: 'into view' | 'away'): void {
    this.group.visible = where === 'into view';
    this.changed();
  }

  /** In the system in which it is drawn; empty while it is put away. */
  bounds(): Box3 {
    if (!this.group.visible) return new Box3();
    return this.#own().applyMatrix4(this.group.matrix);
  }

  #own(): Box3 {
    const box = new Box3();
    for (const { geometry } of this.#bricks.values()) {
      if (geometry.boundingBox !== null) box.union(geometry.boundingBox);
    }
    return box;
  }

  close(): void {
    this.clear();
    this.#material.dispose();
  }

  #add(brick: number, corners: Float32Array, numbers: Uint32Array): void {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.setAttribute('color', this.#coloursOf(numbers));
    geometry.computeBoundingBox();
    const mesh = new Mesh(geometry, this.#material);
    this.#bricks.set(brick, mesh);
    this.#numbers.set(brick, numbers);
    this.group.add(mesh);
    this.#triangles += numbers.length / 3;
  }

  #remove(brick: number): void {
    const mesh = this.#bricks.get(brick);
    if (mesh === undefined) return;
    this.#triangles -= mesh.geometry.getAttribute('position').count / 3;
    this.group.remove(mesh);
    mesh.geometry.dispose();
    this.#bricks.delete(brick);
    this.#numbers.delete(brick);
  }

  // A colour is read once.
  #coloursOf(numbers: Uint32Array = new Uint32Array()): BufferAttribute {
    const colours = new Uint8Array(numbers.length * 3);
    const known = new Map<string, Colour>();
    numbers.forEach((number, i) => {
      const text = this.#painter(number);
      let colour = known.get(text);
      if (colour === undefined) {
        const { r, g, b } = new Color(text);
        colour = [r * 255, g * 255, b * 255];
        known.set(text, colour);
      }
      colours.set(colour, 3 * i);
    });
    return new BufferAttribute(colours, 3, true);
  }

  // What lies on the side that looks at the usual view is left out.
  #cut(): void {
    const { clippingPlanes } = this.#material;
    this.#material.clippingPlanes = this.#section === null ? [] : [this.#plane];
    if (clippingPlanes?.length !== this.#material.clippingPlanes.length) {
      this.#material.needsUpdate = true;
    }
    if (this.#section === null) return;
    const { axis, part } = this.#section;
    const { min, max } = this.#own();
    const place = new Vector3().lerpVectors(min, max, part);
    this.#plane.setFromNormalAndCoplanarPoint(new Vector3(...normals[axis]), place);
    this.#plane.applyMatrix4(this.group.matrixWorld);
  }
}
