// The picture of the path view: planned path, what is done of it, the trace of the live positions, the
// tool, work zero and a grid. It draws when something changed, at most once a frame, and knows nothing
// of the framework.
import {
  AxesHelper,
  Box3,
  Box3Helper,
  BufferGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  GridHelper,
  Group,
  HemisphereLight,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { magnification } from '../style/resolved';
import { Pairs, Segments } from './segments';
import { way, type Track } from './track';
import { TrackLine, TrackPoints } from './track_line';
import { WorkpieceMesh } from './workpiece_mesh';

export type Look = 'iso' | 'top' | 'front' | 'side';
/** Milled parts stand on XY with Z up; turned ones lie with Z to the right and X up. */
export type Lie = 'milled' | 'turned';
export type Place = readonly [x: number, y: number, z: number];

export interface ToolShape {
  radius: number;
  length: number;
  ball: boolean;
}

export interface Colours {
  ground: string;
  line: string;
  feed: string;
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
const firstLook: Record<Lie, Look> = { milled: 'iso', turned: 'front' };

export class PathScene {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(40, 1, 0.1, 50_000);
  readonly #controls: OrbitControls;
  readonly #tool = new Group();
  readonly #grid = new GridHelper(1000, 20);
  readonly #materials = {
    feed: new LineBasicMaterial(),
    rapid: new LineBasicMaterial(),
    done: new LineBasicMaterial(),
    trace: new LineBasicMaterial(),
    marked: new LineBasicMaterial({ depthTest: false }),
    measured: new LineBasicMaterial({ depthTest: false }),
    tool: new MeshBasicMaterial({ transparent: true, opacity: 0.55 }),
  };
  readonly #planned: Segments;
  readonly #traced: Segments;
  readonly #lines: Record<
    'feed' | 'rapid' | 'doneFeed' | 'doneRapid' | 'trace' | 'marked',
    TrackLine
  >;
  readonly workpiece = new WorkpieceMesh(() => this.#showWorkpiece());
  readonly #marked = new Pairs();
  readonly #measured: Line;
  readonly #limits = new Box3Helper(new Box3());
  #markedLine: number | null = null;
  #markedCount = 0;
  readonly #framed = new Box3();
  #size_mm = 100;
  #distance_mm = 100;
  #reached = 0;
  #look: Look;
  /** Until a person turns or zooms the picture, it keeps the whole path in view. */
  #follows = true;
  #wanted = false;
  #closed = false;
  #pictures = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly planned: Track,
    private readonly traced: Track,
    private readonly lie: Lie,
  ) {
    this.#look = firstLook[lie];
    this.#renderer = new WebGLRenderer({ canvas, antialias: true });
    this.#planned = new Segments(planned);
    this.#traced = new Segments(traced);
    const [plan, trace] = [new TrackPoints(planned), new TrackPoints(traced)];
    const { feed, rapid, done, trace: traceLook, marked } = this.#materials;
    this.#lines = {
      feed: new TrackLine(plan, feed),
      rapid: new TrackLine(plan, rapid),
      doneFeed: new TrackLine(plan, done),
      doneRapid: new TrackLine(plan, done),
      trace: new TrackLine(trace, traceLook),
      marked: new TrackLine(plan, marked),
    };
    this.#camera.up.set(...upward[lie]);
    if (lie === 'milled') this.#grid.rotation.x = Math.PI / 2;
    this.#measured = new Line(new BufferGeometry(), this.#materials.measured);
    this.#measured.frustumCulled = false;
    this.#measured.visible = this.#limits.visible = false;
    this.#scene.add(this.#grid, new AxesHelper(20), this.#tool, this.workpiece.group);
    this.#scene.add(this.#measured, this.#limits);
    this.#renderer.localClippingEnabled = true;
    // The light comes from where the picture is looked at.
    const light = new DirectionalLight('white', 1.6);
    light.position.set(0.4, 0.6, 1);
    this.#camera.add(light);
    this.#scene.add(this.#camera, new HemisphereLight('white', '#8a8f98', 1.4));
    for (const { line } of Object.values(this.#lines)) this.#scene.add(line);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.addEventListener('change', () => {
      this.#showLines();
      this.draw();
    });
    this.#controls.addEventListener('start', () => (this.#follows = false));
    this.look(firstLook[lie]);
  }

  colours(colours: Colours): void {
    this.#scene.background = new Color(colours.ground);
    this.#materials.feed.color.set(colours.feed);
    this.#materials.rapid.color.set(colours.rapid);
    this.#materials.trace.color.set(colours.feed);
    this.#materials.marked.color.set(colours.tool);
    this.#materials.measured.color.set(colours.tool);
    (this.#limits.material as LineBasicMaterial).color.set(colours.rapid);
    this.#materials.done.color.set(colours.done);
    this.#materials.tool.color.set(colours.tool);
    const lines = this.#grid.material;
    lines.color.set(colours.line);
    lines.vertexColors = false;
    lines.transparent = true;
    lines.opacity = 0.4;
    lines.needsUpdate = true;
    this.draw();
  }

  /** The tool stands with its tip at the origin of its group. */
  tool({ radius, length, ball }: ToolShape): void {
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
    this.#tool.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...direction));
    this.draw();
  }

  /** The box in which the axes travel; null: it is not shown. */
  limits(box: { low: Place; high: Place } | null): void {
    this.#limits.visible = box !== null;
    if (box !== null) this.#limits.box.set(new Vector3(...box.low), new Vector3(...box.high));
    this.draw();
  }

  /** A line between two places that are measured; none with fewer. */
  measure(places: readonly Place[]): void {
    this.#measured.visible = places.length === 2;
    this.#measured.geometry.setFromPoints(places.map((place) => new Vector3(...place)));
    this.draw();
  }

  /** The look with which a new path is shown. */
  showWhole(): void {
    this.look(firstLook[this.lie]);
  }

  moveTool(x: number, y: number, z: number): void {
    this.#tool.position.set(x, y, z);
    const mayGrow = this.#follows && this.planned.count === 0;
    if (mayGrow && !this.#framed.containsPoint(this.#tool.position)) this.#frame();
    this.draw();
  }

  #showWorkpiece(): void {
    this.canvas.dataset['triangles'] = String(this.workpiece.triangles);
    if (this.#follows && this.planned.count === 0) this.#frame();
    this.draw();
  }

  /** `done` is the index of the planned point that the tool has reached. */
  progress(done: number): void {
    this.#reached = done;
    this.#showLines();
    this.draw();
  }

  /** Shows which part of the planned path comes from a line of the program. */
  markLine(line: number | null): void {
    this.#markedLine = line;
    this.#markedCount = 0;
    this.#marked.clear();
    this.#showLines();
    this.draw();
  }

  #growMarked(): void {
    const { lines, ways, count } = this.planned;
    if (count < this.#markedCount) this.#marked.clear();
    for (let i = Math.max(1, count < this.#markedCount ? 1 : this.#markedCount); i < count; ++i) {
      if (lines[i] === this.#markedLine && ways[i] !== way.none) this.#marked.add(i - 1, i);
    }
    this.#markedCount = count;
  }

  // From near, all segments; from further away fewer, which look the same there.
  #showLines(): void {
    const near = this.#camera.position.distanceTo(this.#controls.target) < this.#distance_mm / 2;
    this.#planned.grow(this.#size_mm);
    this.#traced.grow(this.#size_mm);
    this.#growMarked();
    this.#lines.marked.show(this.#marked, -1, this.planned.count);
    this.#show(near);
  }

  #show(whole: boolean): void {
    const plan = whole ? this.#planned.whole : this.#planned.seenFromAfar;
    const trace = whole ? this.#traced.whole : this.#traced.seenFromAfar;
    const { feed, rapid, doneFeed, doneRapid, trace: traceLine } = this.#lines;
    doneFeed.show(plan.feed, -1, this.#reached);
    doneRapid.show(plan.rapid, -1, this.#reached);
    feed.show(plan.feed, this.#reached, this.planned.count);
    rapid.show(plan.rapid, this.#reached, this.planned.count);
    traceLine.show(trace.feed, -1, this.planned.count > 0 ? -1 : this.traced.count);
  }

  look(look: Look): void {
    this.#look = look;
    this.#follows = true;
    this.#frame();
  }

  // Puts the planned path into view, or else the trace and the tool, with some room for what comes.
  #frame(): void {
    const bounds = (this.planned.count > 0 ? this.planned : this.traced).bounds();
    const box = this.#framed.makeEmpty();
    if (bounds !== null) box.set(new Vector3(...bounds.low), new Vector3(...bounds.high));
    if (this.planned.count === 0) box.expandByPoint(this.#tool.position);
    box.union(this.workpiece.bounds());
    const centre = box.getCenter(new Vector3());
    const size = Math.max(box.getSize(new Vector3()).length() * 1.1, 40);
    box.expandByScalar(size / 20);
    const narrow = Math.min(1, this.#camera.aspect);
    const distance = size / 2 / Math.tan((this.#camera.fov * Math.PI) / 360) / narrow;
    this.#size_mm = size;
    this.#distance_mm = distance;
    const direction = new Vector3(...directions[this.lie][this.#look]).normalize();
    this.#controls.target.copy(centre);
    this.#camera.position.copy(centre).addScaledVector(direction, distance);
    this.#controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    // A line is as wide as a pixel of the picture: on a large screen these are larger ones.
    const coarser = Math.max(1, magnification() / 1.3);
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2) / coarser);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / Math.max(height, 1);
    this.#camera.updateProjectionMatrix();
    this.draw();
  }

  /** The index of the planned or traced point under a place of the canvas; -1 when there is none. */
  pick(x: number, y: number): number {
    const box = this.canvas.getBoundingClientRect();
    const ray = new Raycaster();
    ray.params.Line.threshold = this.#camera.position.distanceTo(this.#controls.target) / 100;
    const at = new Vector2(
      ((x - box.left) / box.width) * 2 - 1,
      1 - ((y - box.top) / box.height) * 2,
    );
    this.#camera.updateMatrixWorld();
    ray.setFromCamera(at, this.#camera);
    this.#show(true);
    const hits = Object.values(this.#lines).flatMap((line) => line.met(ray));
    this.#showLines();
    const [nearest] = hits.sort((a, b) => a.distance - b.distance);
    return nearest?.point ?? -1;
  }

  draw(): void {
    if (this.#wanted || this.#closed) return;
    this.#wanted = true;
    requestAnimationFrame(() => {
      this.#wanted = false;
      if (this.#closed) return;
      this.#renderer.render(this.#scene, this.#camera);
      this.#pictures += 1;
      this.canvas.dataset['pictures'] = String(this.#pictures);
      this.canvas.dataset['drawn'] = String(this.planned.count);
    });
  }

  close(): void {
    this.#closed = true;
    this.#controls.dispose();
    this.workpiece.close();
    for (const line of Object.values(this.#lines)) line.dispose();
    for (const material of Object.values(this.#materials)) material.dispose();
    this.#measured.geometry.dispose();
    this.#limits.dispose();
    this.#renderer.dispose();
  }
}
