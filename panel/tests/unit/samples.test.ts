// Samples of the scope: bytes to columns, peaks that no picture may lose, round numbers, CSV.
import { expect, test } from 'vitest';
import { columnsOf, csvOf, envelope, extremesOf, lanesOf, ticks } from '../../src/plot/samples';

const signal = (name: string, unit: string, ...values: number[]) => ({
  name,
  unit,
  limit: null,
  values: Float32Array.from(values),
});

test('a value of each signal, cycle by cycle', () => {
  const floats = new DataView(new ArrayBuffer(24));
  [1, -2.5, 3, NaN, 5, 6].forEach((value, i) => floats.setFloat32(4 * i, value, true));
  const base64 = btoa(String.fromCharCode(...new Uint8Array(floats.buffer)));
  expect(columnsOf(base64, 2)).toEqual([Float32Array.of(1, 3, 5), Float32Array.of(-2.5, NaN, 6)]);
  expect(columnsOf('', 3)).toEqual([new Float32Array(), new Float32Array(), new Float32Array()]);
});

test('a peak of one cycle among 60,000 is in the picture', () => {
  const values = new Float32Array(60_000);
  values[41_234] = 7;
  const columns = envelope(values, 0, values.length, 800);
  expect(columns).toHaveLength(800);
  expect(columns.filter((one) => one?.high === 7)).toHaveLength(1);
});

test('columns meet: each one reaches to the first sample of the next', () => {
  const columns = envelope(
    Float32Array.from({ length: 100 }, (_, i) => i),
    0,
    100,
    10,
  );
  expect(columns.map((one) => one?.low)).toEqual([0, 10, 20, 30, 40, 50, 60, 70, 80, 90]);
  expect(columns.slice(0, 9).map((one) => one?.high)).toEqual([10, 20, 30, 40, 50, 60, 70, 80, 90]);
});

test('what is no number is no extreme', () => {
  expect(extremesOf(Float32Array.of(NaN, 2, NaN, -1), 0, 4)).toEqual({ low: -1, high: 2 });
  expect(extremesOf(Float32Array.of(NaN), 0, 1)).toBeNull();
});

test('ticks are round numbers within their range', () => {
  expect(ticks(-1.1, 1.1, 4)).toEqual([-1, 0, 1]);
  expect(ticks(0, 100, 5)).toEqual([0, 20, 40, 60, 80, 100]);
  expect(ticks(3, 3, 5)).toEqual([]);
});

test('signals of one unit share a lane', () => {
  const all = [signal('X.position', 'mm'), signal('cycle.time', 'us'), signal('Y.position', 'mm')];
  expect(lanesOf(all)).toEqual([
    { unit: 'mm', members: [0, 2] },
    { unit: 'us', members: [1] },
  ]);
});

test('CSV counts from the trigger and leaves fields empty where there is no value', () => {
  const all = [signal('X.position', 'mm', 1, 1.5, 2), signal('channel1.line', '', 10, NaN, 12)];
  expect(csvOf(all, 0.001, 1)).toBe(
    'time (s),X.position (mm),channel1.line\n-0.001000,1,10\n0.000000,1.5,\n0.001000,2,12\n',
  );
});
