// Curves in a plane: y over x, with ticks, names at the axes, and x from left to right or the other way.
import { contextOf, fitted } from './fitted';
import { extremesOf, ticks } from './samples';
import type { Look } from './scope_picture';

export interface Curve {
  xs: Float32Array;
  ys: Float32Array;
  colour: string;
  dashed?: boolean;
}

export interface Axes {
  x: string;
  y: string;
  /** x falls from left to right. */
  falls: boolean;
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
    const [, top] = range(curves.map((curve) => curve.ys));
    const width = this.#width - left_px - right_px;
    const height = this.#height - top_px - foot_px;
    const x = (value: number): number => {
      const part = (value - low) / (high - low);
      return left_px + width * (axes.falls ? 1 - part : part);
    };
    // Removal, times and feeds begin at nought.
    const y = (value: number): number => top_px + height * (1 - value / (top * 1.06));
    context.strokeStyle = look.line;
    context.fillStyle = look.text;
    context.lineWidth = 1;
    context.strokeRect(left_px, top_px, width, height);
    this.#ticks(ticks(0, top, Math.max(2, height / 45)), (value) => [left_px - 6, y(value)]);
    const across = ticks(low, high, Math.max(2, width / 110));
    this.#ticks(across, (value) => [x(value), this.#height - foot_px + 16], 'center');
    context.textAlign = 'left';
    context.fillText(axes.y, 6, top_px / 2);
    context.textAlign = 'right';
    context.fillText(axes.x, this.#width - right_px, this.#height - 9);
    context.save();
    context.beginPath();
    context.rect(left_px, top_px, width, height);
    context.clip();
    for (const curve of curves) this.#curve(curve, x, y);
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
  }
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
