// How far the part is off the surface that it is to have, as colours: told apart without red and green,
// blue where too much is cut away, orange where material is left.
/** From too much cut away to too much left; the middle one is right. */
const ramp = ['#214e9c', '#5a96d6', '#aacce8', '#c4c4bc', '#f4cc8c', '#eb943c', '#b0520a'];

/** Greatest deviation of a scale, mm. */
export const scales_mm = [0.05, 0.1, 0.2, 0.5, 1, 2] as const;

const steps_per_mm = 1e4;

/** In mm, of the number of a corner (docs/reference/protocol.md, workpiece.surface). */
export const deviationOf = (number: number): number => (number | 0) / steps_per_mm;

/** Classes of equal width from -scale to scale, and what lies beyond in the last ones. */
function classOf(deviation: number, scale: number): number {
  const part = (deviation / scale + 1) / 2;
  return Math.min(ramp.length - 1, Math.max(0, Math.floor(part * ramp.length)));
}

export function colourOfDeviation(deviation: number, scale: number): string {
  return ramp[classOf(deviation, scale)] ?? '';
}

/** The colours of a scale with where each begins and ends, mm; null: there is no end. */
export function scaleOf(
  scale: number,
): { colour: string; from: number | null; to: number | null }[] {
  const width = (2 * scale) / ramp.length;
  return ramp.map((colour, k) => ({
    colour,
    from: k === 0 ? null : k * width - scale,
    to: k === ramp.length - 1 ? null : (k + 1) * width - scale,
  }));
}
