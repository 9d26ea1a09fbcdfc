// Curves in a plane: y over x, with ticks, names at the axes, and x from left to right or the other way.
import { contextOf, fitted } from './fitted';
import { extremesOf, ticks } from './samples';
import type { Look } from './scope_picture';

export interface Curve {
  xs: Float32Array;
  ys: Float32Array;
  colour: string;
  dashed?: boolean;
  /** Points of their own, instead of a line through them. */
  marks?: 'disc' | 'cross';
  /** What lies above the line is coloured, too. */
  above?: boolean;
}

export interface Axes {
  x: string;
  y: string;
  /** x falls from left to right. */
  falls: boolean;
  /** Each power of ten of x takes as much room as another. */
  powers?: boolean;
  /** Where y ends; what is greater runs out of the picture. */
  top?: number;
}

const left_px = 76;
const right_px = 10;
const top_px = 26;
const foot_px = 44;

export class CurvePicture {
  #context: CanvasRenderingContext2D;
  #width = 0;
  #height = 0;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.#context = contextOf(canvas);
  }

  resize(width: number, height: number): void {
    const { width: across, height: down, context } = fitted(this.canvas, width, height);
    [this.#context, this.#width, this.#height] = [context, across, down];
  }

  draw(curves: readonly Curve[], axes: Axes, look: Look): void {
    const context = this.#context;
    context.clearRect(0, 0, this.#width, this.#height);
    context.font = look.font;
    const [low, high] = range(curves.map((curve) => curve.xs));
    const top = axes.top ?? range(curves.map((curve) => curve.ys))[1];
    const along = axes.powers === true ? Math.log : (value: number): number => value;
    const width = this.#width - left_px - right_px;
    const height = this.#height - top_px - foot_px;
    const x = (value: number): number => {
      const part = (along(value) - along(low)) / (along(high) - along(low));
      return left_px + width * (axes.falls ? 1 - part : part);
    };
    // Removal, times and feeds begin at nought.
    const y = (value: number): number => top_px + height * (1 - value / (top * 1.06));
    context.strokeStyle = look.line;
    context.fillStyle = look.text;
    context.lineWidth = 1;
    context.strokeRect(left_px, top_px, width, height);
    this.#ticks(ticks(0, top, Math.max(2, height / 45)), (value) => [left_px - 6, y(value)]);
    const across =
      axes.powers === true ? powerTicks(low, high) : ticks(low, high, Math.max(2, width / 110));
    // The last one stays in the picture with all its digits.
    const end = this.#width - 24;
    const under = this.#height - foot_px + 16;
    this.#ticks(across, (value) => [Math.min(x(value), end), under], 'center');
    context.textAlign = 'left';
    context.fillText(axes.y, 6, top_px / 2);
    context.textAlign = 'right';
    context.fillText(axes.x, this.#width - right_px, this.#height - 9);
    context.save();
    context.beginPath();
    context.rect(left_px, top_px, width, height);
    context.clip();
    for (const curve of curves) {
      if (curve.marks !== undefined) this.#marks(curve, x, y);
      else this.#curve(curve, x, y);
    }
    context.restore();
  }

  #ticks(
    values: number[],
    place: (value: number) => [number, number],
    align: CanvasTextAlign = 'right',
  ): void {
    this.#context.textAlign = align;
    this.#context.textBaseline = 'middle';
    for (const value of values) {
      this.#context.fillText(String(Number(value.toPrecision(6))), ...place(value));
    }
  }

  #curve(curve: Curve, x: (value: number) => number, y: (value: number) => number): void {
    const context = this.#context;
    context.strokeStyle = curve.colour;
    context.lineWidth = 2;
    context.setLineDash(curve.dashed === true ? [6, 4] : []);
    context.beginPath();
    curve.xs.forEach((value, i) => context.lineTo(x(value), y(curve.ys[i] ?? 0)));
    context.stroke();
    context.setLineDash([]);
    if (curve.above !== true) return;
    context.lineTo(x(curve.xs[curve.xs.length - 1] ?? 0), 0);
    context.lineTo(x(curve.xs[0] ?? 0), 0);
    context.globalAlpha = 0.2;
    context.fillStyle = curve.colour;
    context.fill();
    context.globalAlpha = 1;
  }

  #marks(curve: Curve, x: (value: number) => number, y: (value: number) => number): void {
    const context = this.#context;
    context.strokeStyle = context.fillStyle = curve.colour;
    context.lineWidth = 3;
    const size = 6;
    curve.xs.forEach((value, i) => {
      const [across, down] = [x(value), y(curve.ys[i] ?? 0)];
      context.beginPath();
      if (curve.marks === 'disc') {
        context.arc(across, down, size, 0, 2 * Math.PI);
        context.fill();
        return;
      }
      for (const side of [-1, 1]) {
        context.moveTo(across - size, down - side * size);
        context.lineTo(across + size, down + side * size);
      }
      context.stroke();
    });
  }
}

/** 1, 2 and 5 of each power of ten. */
export function powerTicks(low: number, high: number): number[] {
  const all: number[] = [];
  for (let power = 10 ** Math.floor(Math.log10(low)); power <= high; power *= 10) {
    for (const one of [1, 2, 5]) all.push(one * power);
  }
  return all.filter((value) => value >= low && value <= high);
}

function range(all: Float32Array[]): [number, number] {
  const ends = all.flatMap((values) => {
    const found = extremesOf(values, 0, values.length);
    return found === null ? [] : [found.low, found.high];
  });
  if (ends.length === 0) return [0, 1];
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  return high > low ? [low, high] : [low - 1, high + 1];
}
