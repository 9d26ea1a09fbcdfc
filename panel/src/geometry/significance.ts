// How much a picture of a line needs each of its points. Source: D. H. Douglas, T. K. Peucker, Algorithms for
// the reduction of the number of points required to represent a digitized line (1973), with all tolerances
// at once: a point is kept at tolerances below its significance, and then none of the points that
// are left out is further than the tolerance from the line through those that are kept.

/** Of the points between two ends, in mm, into `into[index - from]`. The ends stand for all others
    and are always needed: Infinity. */
export function significance(
  points: Float32Array,
  from: number,
  to: number,
  into: Float32Array,
  begin = from,
): void {
  into[from - begin] = into[to - begin] = Infinity;
  const open: [first: number, last: number, above: number][] = [[from, to, Infinity]];
  for (let piece = open.pop(); piece !== undefined; piece = open.pop()) {
    const [first, last, above] = piece;
    if (last - first < 2) continue;
    const [furthest, offset2] = furthestFrom(points, first, last);
    const weight = Math.min(above, Math.sqrt(offset2));
    if (weight === 0) {
      into.fill(0, first + 1 - begin, last - begin);
      continue;
    }
    into[furthest - begin] = weight;
    open.push([first, furthest, weight], [furthest, last, weight]);
  }
}

// The point between two others that is furthest from the line between them, and the square of how far.
function furthestFrom(p: Float32Array, first: number, last: number): [number, number] {
  const [ax = 0, ay = 0, az = 0] = p.subarray(3 * first, 3 * first + 3);
  const ux = (p[3 * last] ?? 0) - ax;
  const uy = (p[3 * last + 1] ?? 0) - ay;
  const uz = (p[3 * last + 2] ?? 0) - az;
  const length2 = ux * ux + uy * uy + uz * uz;
  let furthest = first + 1;
  let offset2 = -1;
  for (let i = first + 1; i < last; ++i) {
    const x = (p[3 * i] ?? 0) - ax;
    const y = (p[3 * i + 1] ?? 0) - ay;
    const z = (p[3 * i + 2] ?? 0) - az;
    const along = length2 > 0 ? (x * ux + y * uy + z * uz) / length2 : 0;
    const share = Math.min(1, Math.max(0, along));
    const [dx, dy, dz] = [x - share * ux, y - share * uy, z - share * uz];
    const off2 = dx * dx + dy * dy + dz * dz;
    if (off2 > offset2) [furthest, offset2] = [i, off2];
  }
  return [furthest, offset2];
}
