// Samples of signals, a value of each in every cycle, and what a picture and a table want of them.

export interface Signal {
  name: string;
  unit: string;
  limit: number | null;
  values: Float32Array;
}

/** Float32, little endian, in base64: `width` values a cycle; one array for each of them. */
export function columnsOf(base64: string, width: number): Float32Array[] {
  const text = atob(base64);
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const rows = Math.floor(bytes.length / 4 / Math.max(width, 1));
  return Array.from({ length: width }, (_, column) =>
    Float32Array.from({ length: rows }, (__, row) =>
      view.getFloat32(4 * (row * width + column), true),
    ),
  );
}

export interface Extremes {
  low: number;
  high: number;
}

/** The least and the greatest of some samples; null where none of them is a number. */
export function extremesOf(values: Float32Array, from: number, to: number): Extremes | null {
  let low = Infinity;
  let high = -Infinity;
  for (let i = Math.max(from, 0); i < Math.min(to, values.length); ++i) {
    const value = values[i] ?? NaN;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low > high ? null : { low, high };
}

/** Extremes in each of `columns` parts of [from, to): what a column of a picture shows of a dense signal,
    so that no peak is lost. */
export function envelope(
  values: Float32Array,
  from: number,
  to: number,
  columns: number,
): (Extremes | null)[] {
  const width = (to - from) / columns;
  return Array.from({ length: columns }, (_, column) => {
    const first = Math.floor(from + column * width);
    // At least one sample, and the first one of the next column, so that the line is unbroken.
    const behind = Math.max(Math.floor(from + (column + 1) * width) + 1, first + 1);
    return extremesOf(values, first, Math.min(behind, to + 1));
  });
}

/** Round numbers between two values, about `count` of them. */
export function ticks(low: number, high: number, count: number): number[] {
  const raw = (high - low) / Math.max(count, 1);
  if (!(raw > 0) || !Number.isFinite(raw)) return [];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((one) => one * power >= raw) ?? 10);
  const all: number[] = [];
  for (let k = Math.ceil(low / step); k * step <= high + step * 1e-9; ++k) all.push(k * step);
  return all;
}

/** Signals of one unit share a lane of the picture. */
export function lanesOf(signals: readonly Signal[]): { unit: string; members: number[] }[] {
  const lanes = new Map<string, number[]>();
  signals.forEach(({ unit }, i) => lanes.set(unit, [...(lanes.get(unit) ?? []), i]));
  return [...lanes].map(([unit, members]) => ({ unit, members }));
}

/** With a head line, time in s from the trigger, and empty fields where there was no value. */
export function csvOf(signals: readonly Signal[], cycle_s: number, trigger: number): string {
  const head = signals.map(({ name, unit }) => (unit === '' ? name : `${name} (${unit})`));
  const rows = [['time (s)', ...head].join(',')];
  const count = Math.max(0, ...signals.map(({ values }) => values.length));
  for (let i = 0; i < count; ++i) {
    const fields = signals.map(({ values }) => {
      const value = values[i] ?? NaN;
      return Number.isNaN(value) ? '' : String(value);
    });
    rows.push([((i - trigger) * cycle_s).toFixed(6), ...fields].join(','));
  }
  return `${rows.join('\n')}\n`;
}
