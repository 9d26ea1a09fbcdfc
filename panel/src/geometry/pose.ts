// How systems lie in each other, as the daemon tells it: twelve numbers row by row, three of the rotation
// and the shift in mm.
import { Matrix4 } from 'three';

export type Pose = readonly number[];

/** A system that the base of a kinematic scheme carries. */
export interface Carried {
  scheme: number;
  pose: Pose;
}

export function matrixOf(pose: Pose): Matrix4 {
  const [a = 1, b = 0, c = 0, x = 0, d = 0, e = 1, f = 0, y = 0, g = 0, h = 0, i = 1, z = 0] = pose;
  return new Matrix4().set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
}

/** From `inner` to `outer`; no change where nothing carries both, or one of them is not known. */
export function between(inner: Carried | null, outer: Carried | null): Matrix4 {
  if (inner === null || outer?.scheme !== inner.scheme) return new Matrix4();
  return matrixOf(outer.pose).invert().multiply(matrixOf(inner.pose));
}
