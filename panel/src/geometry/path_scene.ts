// The picture of the path view: planned path, what is done of it, the trace of the live positions, the
// tool, work zero and a grid. It draws when something changed, and knows nothing of the framework.
//
// All of it lies in the part system (docs/reference/protocol.md), which stands still in the picture, or
// turns with the table while the machine does.
import {
  AxesHelper,
  Box3,
  Box3Helper,
  BufferGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  Frustum,
  GridHelper,
  Group,
  HemisphereLight,
  Line,
  LineBasicMaterial,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { whenDone } from './graphics_done';
import { magnification } from '../style/resolved';
import { Levels, type Sight } from './levels';
import { matrixOf, type Carried, type Pose } from './pose';
import { Pairs } from './pairs';
import { PicturePace } from './picture_pace';
import { PointColours, type Colour, type Painter } from './point_colours';
import { FeedClasses, toolsOf, type Shade } from './shades';
import type { Shading } from './shading';
import { colourOfTool } from './tool_colours';
import { way, type Track } from './track';
import { colouredByEnd, PointValues, TrackLine } from './track_line';
import { WorkpieceMesh } from './workpiece_mesh';

export type Look = 'iso' | 'top' | 'front' | 'side';
/** Milled parts stand on XY with Z up; turned ones lie with Z to the right and X up. */
export type Lie = 'milled' | 'turned';
export type Place = readonly [x: number, y: number, z: number];

/** From where a picture is seen, and of what it is. */
export interface Standpoint {
  of: string;
  look: Look;
  /** Null: from where the look has the whole path in view. */
  from: { eye: Place; target: Place } | null;
}

export interface ToolShape {
  radius: number;
  length: number;
  ball: boolean;
  /** Of the holder; 0: it is not known. */
  holder: { radius: number; length: number };
}

export interface Colours {
  ground: string;
  line: string;
  feed: string;
  arc: string;
  rapid: string;
  done: string;
  tool: string;
}

// From what is looked at to who looks.
const directions: Record<Lie, Record<Look, Place>> = {
  milled: { iso: [1, -1.2, 0.9], top: [0, -0.0001, 1], front: [0, -1, 0], side: [1, 0, 0] },
  turned: { iso: [0.8, 1.2, 0.7], top: [1, 0.0001, 0], front: [0, 1, 0], side: [0, 0, 1] },
};
const upward: Record<Lie, Place> = { milled: [0, 0, 1], turned: [1, 0, 0] };
// Of a line, in pixels, and how many segments of a path: while things move, and when nothing does.
const fineness = {
  moving: { off_px: 1, segmentsAtMost: 12_000 },
  standing: { off_px: 0.5, segmentsAtMost: 60_000 },
} as const;

// Of the housing of the spindle, where the machine stands still, mm.
const housing = { radius: 45, length: 140 } as const;
const plateThickness = 8;

const firstLook: Record<Lie, Look> = { milled: 'iso', turned: 'front' };

/** What is known of a track, and which of its segments are in the picture. */
interface Shown {
  levels: Levels;
  pairs: Pairs;
}

function bytesOf(colour: string): Colour {
  const { r, g, b } = new Color(colour);
  return [255 * r, 255 * g, 255 * b];
}

export class PathScene {
  readonly canvas = document.createElement('canvas');
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(40, 1, 0.1, 50_000);
  readonly #controls: OrbitControls;
  /** From the part system to the picture. */
  readonly #root = new Group();
  readonly #fromRoot = new Matrix4();
  #carried: Carried | null = null;
  #direction: Place = [0, 0, 1];
  readonly #tool = new Group();
  readonly #housing: Mesh;
  readonly #plate: Mesh;
  /** Of the workpiece system that is active. */
  readonly #work = new AxesHelper(14);
  readonly #grid = new GridHelper(1000, 20);
  readonly #materials = {
    plan: colouredByEnd(new LineBasicMaterial()),
    done: new LineBasicMaterial(),
    trace: new LineBasicMaterial(),
    marked: new LineBasicMaterial({ depthTest: false }),
    measured: new LineBasicMaterial({ depthTest: false }),
    tool: new MeshBasicMaterial({ transparent: true, opacity: 0.55 }),
    machine: new MeshLambertMaterial({ transparent: true, opacity: 0.35 }),
  };
  readonly #planned: Shown;
  readonly #traced: Shown;
  readonly #colours: PointColours;
  readonly #colourValues: PointValues;
  readonly #feeds: FeedClasses;
  #shading: Shading = 'kind';
  readonly #colourOf: Record<'feed' | 'arc' | 'rapid', Colour> = {
    feed: [0, 0, 0],
    arc: [0, 0, 0],
    rapid: [0, 0, 0],
  };
  readonly #lines: Record<'plan' | 'done' | 'trace' | 'marked', TrackLine>;
  readonly workpiece = new WorkpieceMesh(() => this.#showWorkpiece());
  readonly #marked = new Pairs();
  readonly #measured: Line;
  readonly #limits = new Box3Helper(new Box3());
  #markedLine: number | null = null;
  #markedOf = { count: 0, generation: -1 };
  readonly #framed = new Box3();
  readonly #pace: PicturePace;
  readonly #frustum = new Frustum();
  #screen: [width: number, height: number] = [1, 1];
  #ratio = 1;
  #of = '';
  #reached = 0;
  #look: Look;
  /** Until a person turns or zooms the picture, it keeps the whole path in view. */
  #follows = true;
  #pictures = 0;
  /** Whether what shades lines and bodies has been made, which the thread of the page does not wait for. */
  #isCompiled = false;
  #isClosed = false;
  #coloursNow = '';
  #coloured = 0;

  constructor(
    private readonly planned: Track,
    private readonly traced: Track,
    private readonly lie: Lie,
    standpoint?: Standpoint,
  ) {
    this.#look = firstLook[lie];
    const { canvas } = this;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true });
    // Each answer of it is waited for; one does, when a program has been made.
    this.#renderer.debug.checkShaderErrors = false;
    this.#pace = new PicturePace({
      fullPixels: () => this.#screen[0] * this.#screen[1] * this.#ratio ** 2,
      prepare: (until) => this.#prepare(until),
      fit: (share) => this.#fit(share),
      draw: (stands) => this.#render(stands ? 'standing' : 'moving'),
      gl: () => this.#renderer.getContext() as WebGL2RenderingContext,
    });
    this.#planned = { levels: new Levels(planned), pairs: new Pairs() };
    this.#traced = { levels: new Levels(traced), pairs: new Pairs() };
    this.#feeds = new FeedClasses(planned);
    this.#colours = new PointColours(planned, this.#painter());
    this.#colourValues = new PointValues(() => this.#colours.values, 3, true);
    const [places, trace] = [PointValues.places(planned), PointValues.places(traced)];
    const materials = this.#materials;
    this.#lines = {
      plan: new TrackLine(planned, places, materials.plan, this.#colourValues),
      done: new TrackLine(planned, places, materials.done),
      trace: new TrackLine(traced, trace, materials.trace),
      marked: new TrackLine(planned, places, materials.marked),
    };
    this.#camera.up.set(...upward[lie]);
    if (lie === 'milled') this.#grid.rotation.x = Math.PI / 2;
    this.#measured = new Line(new BufferGeometry(), this.#materials.measured);
    this.#measured.frustumCulled = false;
    this.#measured.visible = this.#limits.visible = false;
    const { radius, length } = housing;
    this.#housing = new Mesh(
      new CylinderGeometry(radius, radius, length, 32),
      this.#materials.machine,
    );
    this.#housing.rotation.x = Math.PI / 2;
    this.#plate = new Mesh(new CylinderGeometry(1, 1, plateThickness, 48), this.#materials.machine);
    this.#plate.matrixAutoUpdate = this.#work.matrixAutoUpdate = false;
    this.#root.matrixAutoUpdate = false;
    this.#housing.visible = this.#plate.visible = this.#work.visible = false;
    this.#root.add(this.#grid, new AxesHelper(20), this.#work, this.#tool, this.workpiece.group);
    this.#root.add(this.#measured, this.#limits, this.#plate);
    this.#scene.add(this.#root);
    this.#renderer.localClippingEnabled = true;
    // The light comes from where the picture is looked at.
    const light = new DirectionalLight('white', 1.6);
    light.position.set(0.4, 0.6, 1);
    this.#camera.add(light);
    this.#scene.add(this.#camera, new HemisphereLight('white', '#8a8f98', 1.4));
    for (const { line } of Object.values(this.#lines)) this.#root.add(line);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.addEventListener('change', () => this.draw());
    this.#controls.addEventListener('start', () => (this.#follows = false));
    this.look(firstLook[lie]);
    if (standpoint !== undefined) this.#standAt(standpoint);
    setTimeout(() => void this.#compile());
  }

  async #compile(): Promise<void> {
    if (this.#isClosed) return;
    // A line that has no points yet is shaded by another program.
    this.#showLines('moving');
    await this.#renderer.compileAsync(this.#scene, this.#camera);
    // Each waits a moment for the graphics, and so does a picture of another size.
    for (const program of this.#renderer.info.programs ?? []) {
      await this.#whenDone();
      if (this.#isClosed) return;
      program.getUniforms();
      const gl = this.#renderer.getContext();
      const made = program.program as WebGLProgram;
      if (gl.getProgramParameter(made, gl.LINK_STATUS) === false)
        console.error(`a shader: ${gl.getProgramInfoLog(made)}`);
    }
    await this.#whenDone();
    this.#fit(this.#pace.share());
    await this.#whenDone();
    this.#isCompiled = true;
    this.draw();
  }

  #whenDone(): Promise<void> {
    return whenDone(this.#renderer.getContext() as WebGL2RenderingContext);
  }

  /** The graphics have forgotten what was in their memory. */
  get isLost(): boolean {
    return this.#renderer.getContext().isContextLost();
  }

  /** From where it is seen now. */
  standpoint(): Standpoint {
    const from = {
      eye: this.#camera.position.toArray(),
      target: this.#controls.target.toArray(),
    };
    return { of: this.#of, look: this.#look, from: this.#follows ? null : from };
  }

  #standAt({ of, look, from }: Standpoint): void {
    this.#of = of;
    this.look(look);
    if (from === null) return;
    this.#follows = false;
    this.#camera.position.set(...from.eye);
    this.#controls.target.set(...from.target);
    this.#controls.update();
  }

  colours(colours: Colours): void {
    const now = JSON.stringify(colours);
    if (now === this.#coloursNow) return;
    this.#coloursNow = now;
    this.#scene.background = new Color(colours.ground);
    this.#colourOf.feed = bytesOf(colours.feed);
    this.#colourOf.arc = bytesOf(colours.arc);
    this.#colourOf.rapid = bytesOf(colours.rapid);
    this.#colours.repaint();
    this.#materials.trace.color.set(colours.feed);
    this.#materials.marked.color.set(colours.tool);
    this.#materials.measured.color.set(colours.tool);
    (this.#limits.material as LineBasicMaterial).color.set(colours.rapid);
    this.#materials.done.color.set(colours.done);
    this.#materials.tool.color.set(colours.tool);
    this.#materials.machine.color.set(colours.line);
    const lines = this.#grid.material;
    lines.color.set(colours.line);
    lines.vertexColors = false;
    lines.transparent = true;
    lines.opacity = 0.4;
    lines.needsUpdate = true;
    this.draw();
  }

  /** By what the moves at feed have their colours; a legend is complete when the path is. */
  shade(shading: Shading): Shade[] {
    const isOther = shading !== this.#shading;
    this.#shading = shading;
    const hasOthers = shading === 'feed' && this.#feeds.grow();
    if (isOther || hasOthers) this.#colours.repaint(this.#painter());
    this.draw();
    if (shading === 'kind') return [];
    return shading === 'feed' ? this.#feeds.legend() : toolsOf(this.planned);
  }

  // A colour is read once for each of its values.
  #painter(): Painter {
    const known = new Map<number, Colour>();
    const colour = (value: number, read: () => string): Colour => {
      const found = known.get(value) ?? bytesOf(read());
      known.set(value, found);
      return found;
    };
    return (index) => {
      const { ways, feeds, tools } = this.planned;
      if (ways[index] === way.rapid) return this.#colourOf.rapid;
      if (this.#shading === 'kind')
        return ways[index] === way.arc ? this.#colourOf.arc : this.#colourOf.feed;
      const value = (this.#shading === 'feed' ? feeds : tools)[index] ?? 0;
      return colour(value, () =>
        this.#shading === 'feed' ? this.#feeds.colourOf(value) : colourOfTool(value),
      );
    };
  }

  /** The tool stands with its tip at the origin of its group. */
  tool({ radius, length, ball, holder }: ToolShape): void {
    this.#tool.clear();
    const r = Math.max(radius, 0.5);
    const h = Math.max(length, 4 * r);
    const shank = new Mesh(
      new CylinderGeometry(r, r, h - (ball ? r : 0), 24),
      this.#materials.tool,
    );
    shank.rotation.x = Math.PI / 2;
    shank.position.z = (h + (ball ? r : 0)) / 2;
    this.#tool.add(shank);
    if (holder.radius > 0 && holder.length > 0) {
      const body = new Mesh(
        new CylinderGeometry(holder.radius, holder.radius, holder.length, 24),
        this.#materials.tool,
      );
      body.rotation.x = Math.PI / 2;
      body.position.z = h + holder.length / 2;
      this.#tool.add(body);
    }
    this.#housing.position.z = h + holder.length + housing.length / 2;
    this.#tool.add(this.#housing);
    this.direct(this.lie === 'turned' ? [1, 0, 0] : [0, 0, 1]);
    if (ball) {
      const tip = new Mesh(new SphereGeometry(r, 24, 12), this.#materials.tool);
      tip.position.z = r;
      this.#tool.add(tip);
    }
    this.draw();
  }

  /** Along which the tool stands, from its tip into the spindle. */
  direct(direction: Place): void {
    if (direction.every((part, k) => part === this.#direction[k])) return;
    this.#direction = [...direction];
    this.#tool.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...direction));
    this.draw();
  }

  /** How the workpiece system that is active lies; null: it is not known. */
  work(pose: Pose | null): void {
    const matrix = matrixOf(pose ?? []);
    const isElsewhere = !matrix.equals(new Matrix4());
    if (isElsewhere === this.#work.visible && matrix.equals(this.#work.matrix)) return;
    this.#work.visible = isElsewhere;
    this.#work.matrix.copy(matrix);
    this.draw();
  }

  /** The machine stands still in the picture, and the part turns with its table: `machine` is how it lies
      in the part system; null: the part stands still. `part` is how that lies on a table; null: there is
      no table that turns. */
  stand(machine: Pose | null, part: Carried | null): void {
    const turned = matrixOf(machine ?? []);
    const isSame = turned.equals(this.#fromRoot) && part === this.#carried;
    if (isSame && this.#housing.visible === (machine !== null)) return;
    this.#carried = part;
    this.#fromRoot.copy(turned);
    this.#root.matrix.copy(this.#fromRoot).invert();
    this.#root.updateMatrixWorld(true);
    const isOther = this.#housing.visible !== (machine !== null);
    this.#housing.visible = machine !== null;
    this.#grid.visible = machine === null;
    this.#plate.visible = machine !== null && part !== null;
    if (this.#plate.visible && part !== null) {
      const radius = this.#radiusAbout(matrixOf(part.pose));
      this.#plate.matrix
        .copy(matrixOf(part.pose))
        .invert()
        .multiply(new Matrix4().makeTranslation(0, 0, -plateThickness / 2))
        .multiply(new Matrix4().makeRotationX(Math.PI / 2))
        .multiply(new Matrix4().makeScale(radius, 1, radius));
    }
    this.workpiece.turned();
    if (isOther && this.#follows) this.#frame();
    else this.draw();
  }

  // So that a plate about the zero of the base carries what is drawn at feed.
  #radiusAbout(base: Matrix4): number {
    const box = this.#box().applyMatrix4(base);
    const [x, y] = [Math.max(-box.min.x, box.max.x), Math.max(-box.min.y, box.max.y)];
    return Math.min(Math.max(Math.hypot(x, y), 40), 600);
  }

  /** The box in which the axes travel; null: it is not shown. */
  limits(box: { low: Place; high: Place } | null): void {
    const next = new Box3();
    if (box !== null) next.set(new Vector3(...box.low), new Vector3(...box.high));
    if (this.#limits.visible === (box !== null) && this.#limits.box.equals(next)) return;
    this.#limits.visible = box !== null;
    this.#limits.box.copy(next);
    this.draw();
  }

  /** A line between two places that are measured; none with fewer. */
  measure(places: readonly Place[]): void {
    this.#measured.visible = places.length === 2;
    this.#measured.geometry.setFromPoints(places.map((place) => new Vector3(...place)));
    this.draw();
  }

  /** More of the planned path has come; that of another program is shown with the usual look. */
  grew(of: string): void {
    if (this.#of !== of) {
      this.#of = of;
      this.look(firstLook[this.lie]);
    } else if (this.#follows) {
      this.#frame();
    } else {
      this.draw();
    }
  }

  moveTool(x: number, y: number, z: number): void {
    this.#tool.position.set(x, y, z);
    const mayGrow = this.#follows && this.planned.count === 0;
    const there = new Vector3(x, y, z).applyMatrix4(this.#root.matrix);
    if (mayGrow && !this.#framed.containsPoint(there)) this.#frame();
    this.draw();
  }

  #showWorkpiece(): void {
    this.canvas.dataset['triangles'] = String(this.workpiece.triangles);
    if (this.#follows && this.planned.count === 0) this.#frame();
    this.draw();
  }

  /** `done` is the index of the planned point that the tool has reached. */
  progress(done: number): void {
    if (this.#reached === done) return;
    this.#reached = done;
    this.draw();
  }

  /** Shows which part of the planned path comes from a line of the program. */
  markLine(line: number | null): void {
    this.#markedLine = line;
    this.#markedOf.generation = -1;
    this.draw();
  }

  #growMarked(): void {
    const { lines, ways, count, generation } = this.planned;
    const isSame = generation === this.#markedOf.generation;
    if (!isSame) this.#marked.clear();
    for (let i = isSame ? Math.max(1, this.#markedOf.count) : 1; i < count; ++i) {
      if (lines[i] === this.#markedLine && ways[i] !== way.none) this.#marked.add(i - 1, i);
    }
    this.#markedOf = { count, generation };
  }

  #prepare(until: number): boolean {
    const { levels } = this.planned.count > 0 ? this.#planned : this.#traced;
    return levels.grow(until) && this.#colours.grow(until);
  }

  #showLines(how: keyof typeof fineness): void {
    const { planned, traced } = this;
    const [plan, trace] = [this.#planned, this.#traced];
    const sight = this.#sight(how);
    const { levels, pairs } = planned.count > 0 ? plan : trace;
    levels.choose(sight, pairs);
    this.#growMarked();
    if (this.#coloured !== this.#colours.version) this.#colourValues.replaced();
    this.#coloured = this.#colours.version;
    this.#lines.marked.show(this.#marked, -1, planned.count);
    this.#lines.done.show(plan.pairs, -1, this.#reached);
    this.#lines.plan.show(plan.pairs, this.#reached, planned.count);
    this.#lines.trace.show(trace.pairs, -1, planned.count > 0 ? -1 : traced.count);
  }

  #sight(how: keyof typeof fineness): Sight {
    const camera = this.#camera;
    camera.updateMatrixWorld();
    const seen = new Matrix4()
      .multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
      .multiply(this.#root.matrix);
    const { off_px, segmentsAtMost } = fineness[how];
    const pixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / (this.#screen[1] * this.#ratio);
    return {
      frustum: this.#frustum.setFromProjectionMatrix(seen),
      eye: camera.position.clone().applyMatrix4(this.#fromRoot),
      tolerance: off_px * pixel,
      segmentsAtMost,
    };
  }

  look(look: Look): void {
    this.#look = look;
    this.#follows = true;
    this.#frame();
  }

  // In the part system.
  #box(): Box3 {
    const bounds = (this.planned.count > 0 ? this.planned : this.traced).bounds();
    const box = new Box3();
    if (bounds !== null) box.set(new Vector3(...bounds.low), new Vector3(...bounds.high));
    if (this.planned.count === 0) box.expandByPoint(this.#tool.position);
    return box.union(this.workpiece.bounds());
  }

  // Puts the planned path into view, or else the trace and the tool, with some room for what comes.
  #frame(): void {
    const box = this.#framed.copy(this.#box()).applyMatrix4(this.#root.matrix);
    const centre = box.getCenter(new Vector3());
    const size = Math.max(box.getSize(new Vector3()).length() * 1.1, 40);
    box.expandByScalar(size / 20);
    const narrow = Math.min(1, this.#camera.aspect);
    const distance = size / 2 / Math.tan((this.#camera.fov * Math.PI) / 360) / narrow;
    const direction = new Vector3(...directions[this.lie][this.#look]).normalize();
    this.#controls.target.copy(centre);
    this.#camera.position.copy(centre).addScaledVector(direction, distance);
    this.#controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    // A line is as wide as a pixel of the picture: on a large screen these are larger ones.
    const coarser = Math.max(1, magnification() / 1.3);
    this.#ratio = Math.min(window.devicePixelRatio, 2) / coarser;
    this.#screen = [width, height];
    this.#camera.aspect = width / Math.max(height, 1);
    this.#camera.updateProjectionMatrix();
    this.draw();
  }

  /** The index of the planned or traced point under a place of the canvas; -1 when there is none. */
  pick(x: number, y: number): number {
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2(
      ((x - box.left) / box.width) * 2 - 1,
      1 - ((y - box.top) / box.height) * 2,
    );
    this.#camera.updateMatrixWorld();
    const caster = new Raycaster();
    caster.setFromCamera(at, this.#camera);
    const within = this.#camera.position.distanceTo(this.#controls.target) / 100;
    const { levels } = this.planned.count > 0 ? this.#planned : this.#traced;
    levels.grow();
    return levels.metBy(caster.ray.applyMatrix4(this.#fromRoot), within);
  }

  draw(): void {
    if (this.#isCompiled) this.#pace.wake();
  }

  // True where nothing was to be done.
  #fit(share: number): boolean {
    const [width, height] = this.#screen;
    const size = new Vector2(width, height).multiplyScalar(this.#ratio * share).floor();
    const fits = this.#renderer.getSize(new Vector2()).equals(size);
    if (!fits) this.#renderer.setSize(size.x, size.y, false);
    return fits;
  }

  #render(how: keyof typeof fineness): void {
    this.#showLines(how);
    this.#renderer.render(this.#scene, this.#camera);
    this.#pictures += 1;
    const { dataset } = this.canvas;
    dataset['pictures'] = String(this.#pictures);
    dataset['drawn'] = String(this.planned.count);
    dataset['segments'] = String(
      (this.planned.count > 0 ? this.#planned : this.#traced).pairs.count,
    );
    dataset['how'] = how;
  }

  close(): void {
    this.#isClosed = true;
    this.#pace.close();
    this.#controls.dispose();
    this.workpiece.close();
    for (const line of Object.values(this.#lines)) line.dispose();
    for (const material of Object.values(this.#materials)) material.dispose();
    this.#measured.geometry.dispose();
    this.#limits.dispose();
    this.#housing.geometry.dispose();
    this.#plate.geometry.dispose();
    this.#renderer.dispose();
  }
}
