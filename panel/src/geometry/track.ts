// Points of a path with the line of the program that leads to each: grows in place, never copied for
// a view, and not watched by the framework.

const firstCapacity = 4096;

/** What leads to a point: a move at feed, in rapid, nothing (a new beginning), or an arc at feed. */
export const way = { feed: 0, rapid: 1, none: 2, arc: 3 } as const;
export type Way = (typeof way)[keyof typeof way];

type Place = [x: number, y: number, z: number];
export interface Bounds {
  low: Place;
  high: Place;
}

const nowhere = (): Bounds => ({
  low: [Infinity, Infinity, Infinity],
  high: [-Infinity, -Infinity, -Infinity],
});

function include({ low, high }: Bounds, points: Float32Array, index: number): void {
  for (const axis of [0, 1, 2] as const) {
    const value = points[3 * index + axis] ?? 0;
    low[axis] = Math.min(low[axis], value);
    high[axis] = Math.max(high[axis], value);
  }
}

export class Track {
  points: Float32Array = new Float32Array(firstCapacity * 3);
  lines: Uint32Array = new Uint32Array(firstCapacity);
  ways: Uint8Array = new Uint8Array(firstCapacity);
  /** Of what leads to a point: mm/min, 0 where it is rapid or not known, and the number of the tool. */
  feeds: Float32Array = new Float32Array(firstCapacity);
  tools: Uint16Array = new Uint16Array(firstCapacity);
  count = 0;
  /** Grows with every clear(), so that who draws the track knows that it is another one. */
  generation = 0;
  #bounded: { generation: number; count: number; feed: Bounds; all: Bounds } | null = null;

  clear(): void {
    this.count = 0;
    this.generation += 1;
  }

  /** What leads to the points from one index to before another. */
  mark(from: number, to: number, how: Way): void {
    this.ways.fill(how, from, Math.min(to, this.count));
  }

  /** Whether what leads to a point is drawn in another way than what leads on from it. */
  turnsAt(index: number): boolean {
    const next = this.ways[index + 1];
    return this.ways[index] !== next || next === way.none;
  }

  /** True when the arrays were replaced by larger ones. */
  add(x: number, y: number, z: number, line: number): boolean {
    const grown = this.#reserve(this.count + 1);
    this.points.set([x, y, z], this.count * 3);
    this.lines[this.count] = line;
    for (const values of [this.ways, this.feeds, this.tools]) values[this.count] = 0;
    this.count += 1;
    return grown;
  }

  append(points: Float32Array, lines: Uint32Array): boolean {
    const grown = this.#reserve(this.count + lines.length);
    this.points.set(points, this.count * 3);
    this.lines.set(lines, this.count);
    for (const values of [this.ways, this.feeds, this.tools])
      values.fill(0, this.count, this.count + lines.length);
    this.count += lines.length;
    return grown;
  }

  /** Forgets the older half: what a live trace does when it has been running for hours. */
  halve(): void {
    const from = this.count >> 1;
    this.points.copyWithin(0, from * 3, this.count * 3);
    this.lines.copyWithin(0, from, this.count);
    this.ways.copyWithin(0, from, this.count);
    this.count -= from;
    this.generation += 1;
  }

  /** The first point of a line at or after `from`; -1 when there is none. */
  indexOfLine(line: number, from = 0): number {
    for (let i = from; i < this.count; ++i) if (this.lines[i] === line) return i;
    return -1;
  }

  /** Of the points that feed leads to, where there are some: rapid moves come from far away. */
  bounds(): Bounds | null {
    if (this.count === 0) return null;
    const { generation, count } = this;
    if (this.#bounded?.generation !== generation || this.#bounded.count > count)
      this.#bounded = { generation, count: 0, feed: nowhere(), all: nowhere() };
    const known = this.#bounded;
    for (let i = known.count; i < count; ++i) {
      include(known.all, this.points, i);
      const how = this.ways[i];
      if (i > 0 && (how === way.feed || how === way.arc)) include(known.feed, this.points, i);
    }
    known.count = count;
    return known.feed.low[0] <= known.feed.high[0] ? known.feed : known.all;
  }

  #reserve(count: number): boolean {
    if (count <= this.lines.length) return false;
    const capacity = Math.max(count, this.lines.length * 2);
    const points = new Float32Array(capacity * 3);
    points.set(this.points.subarray(0, this.count * 3));
    const lines = new Uint32Array(capacity);
    lines.set(this.lines.subarray(0, this.count));
    const ways = new Uint8Array(capacity);
    ways.set(this.ways.subarray(0, this.count));
    const feeds = new Float32Array(capacity);
    feeds.set(this.feeds.subarray(0, this.count));
    const tools = new Uint16Array(capacity);
    tools.set(this.tools.subarray(0, this.count));
    this.points = points;
    this.lines = lines;
    this.ways = ways;
    this.feeds = feeds;
    this.tools = tools;
    return true;
  }
}

export interface PagePart {
  points: Float32Array;
  lines: Uint32Array;
}

/** Points of a page, counted in it, as ranges [first, behind the last]. */
type Ranges = readonly (readonly [number, number])[];
/** Values, each from a point of the page on. */
type Steps = readonly (readonly [from: number, value: number])[];
export interface PageWays {
  rapid?: Ranges;
  arcs?: Ranges;
  begins?: Ranges;
  feeds?: Steps;
  tools?: Steps;
}

function fill(values: Float32Array | Uint16Array, first: number, last: number, steps: Steps): void {
  steps.forEach(([from, value], k) => {
    values.fill(value, first + from, Math.min(last, first + (steps[k + 1]?.[0] ?? Infinity)));
  });
}

/** Puts the pages of one path together, in whatever order they and what is said of them come. */
export class PagedTrack {
  readonly track = new Track();
  #id: number | null = null;
  #next = 0;
  #parts = new Map<number, PagePart>();
  #ways = new Map<number, PageWays>();

  /** Waits for the pages of another path: those of any other that are still under way are left alone. */
  expect(id: number | null): void {
    this.#id = id;
    this.#next = 0;
    this.#parts.clear();
    this.#ways.clear();
    this.track.clear();
  }

  /** How many points have come into place. */
  take(id: number, page: number, part: PagePart): number {
    if (!this.#isWanted(id, page)) return 0;
    this.#parts.set(page, part);
    return this.#place();
  }

  /** What leads to the points of a page; how many points have come into place with that. */
  say(id: number, page: number, ways: PageWays): number {
    if (!this.#isWanted(id, page)) return 0;
    this.#ways.set(page, ways);
    return this.#place();
  }

  #isWanted(id: number, page: number): boolean {
    return id === this.#id && page >= this.#next;
  }

  // The next pages of which all is known.
  #place(): number {
    const before = this.track.count;
    for (;;) {
      const part = this.#parts.get(this.#next);
      const ways = this.#ways.get(this.#next);
      if (part === undefined || ways === undefined) return this.track.count - before;
      const start = this.track.count;
      this.track.append(part.points, part.lines);
      for (const [from, to] of ways.arcs ?? []) this.track.mark(start + from, start + to, way.arc);
      for (const [from, to] of ways.rapid ?? [])
        this.track.mark(start + from, start + to, way.rapid);
      for (const [from, to] of ways.begins ?? [])
        this.track.mark(start + from, start + to, way.none);
      fill(this.track.feeds, start, this.track.count, ways.feeds ?? []);
      fill(this.track.tools, start, this.track.count, ways.tools ?? []);
      this.#parts.delete(this.#next);
      this.#ways.delete(this.#next);
      this.#next += 1;
    }
  }
}
