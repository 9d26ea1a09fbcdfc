// The picture of the scope: a lane for each unit, dense signals by their extremes in every column, limits as
// dashed lines, the trigger, and two cursors.
import { magnification } from '../style/resolved';
import { colourOfTool } from '../geometry/tool_colours';
import { t } from '../text/text';
import { contextOf, fitted } from './fitted';
import { envelope, extremesOf, lanesOf, ticks, type Extremes, type Signal } from './samples';

export interface View {
  /** Samples that are shown: [from, to). */
  from: number;
  to: number;
  trigger: number;
  cycle_s: number;
  cursors: readonly [number, number];
  /** Lanes reach to the limits, too. */
  limits: boolean;
}

export interface Look {
  text: string;
  line: string;
  limit: string;
  cursor: string;
  font: string;
}

export const colourOfSignal = (index: number): string => colourOfTool(index + 1);

const left_px = 76;
const right_px = 8;
const foot_px = 24;
const gap_px = 8;

/** The sample under a place of the picture. */
export function sampleAt(x: number, width: number, { from, to }: View): number {
  const zoom = magnification();
  const part = (x / zoom - left_px) / Math.max(1, width / zoom - left_px - right_px);
  return Math.round(from + Math.min(1, Math.max(0, part)) * Math.max(0, to - 1 - from));
}

// What a lane shows from top to bottom: all values of its signals, with some room.
function rangeOf(members: Signal[], { from, to, limits }: View): Extremes {
  const found = members.map(({ values }) => extremesOf(values, from, to));
  const ends = found.flatMap((one) => (one === null ? [] : [one.low, one.high]));
  if (limits) ends.push(...members.flatMap(({ limit }) => (limit === null ? [] : [limit, -limit])));
  if (ends.length === 0) return { low: -1, high: 1 };
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const room = high > low ? (high - low) * 0.06 : Math.max(Math.abs(high) * 0.1, 1e-3);
  return { low: low - room, high: high + room };
}

export class ScopePicture {
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

  draw(signals: readonly Signal[], view: View, look: Look): void {
    const context = this.#context;
    context.clearRect(0, 0, this.#width, this.#height);
    context.font = look.font;
    const lanes = lanesOf(signals);
    const height = (this.#height - foot_px) / Math.max(1, lanes.length) - gap_px;
    lanes.forEach(({ unit, members }, i) => {
      const top = i * (height + gap_px);
      const range = rangeOf(
        members.flatMap((k) => signals[k] ?? []),
        view,
      );
      const y = (value: number): number =>
        top + height * (1 - (value - range.low) / (range.high - range.low));
      this.#frame(top, height, unit, range, y, look);
      context.save();
      context.beginPath();
      context.rect(left_px, top, this.#width - left_px - right_px, height);
      context.clip();
      for (const k of members) {
        const signal = signals[k];
        if (signal === undefined) continue;
        this.#signal(signal, colourOfSignal(k), view, y);
        if (signal.limit !== null) this.#limits(signal.limit, y, look);
      }
      context.restore();
    });
    this.#times(view, look);
    this.#upright(view.trigger, view, look.limit, 'T');
    view.cursors.forEach((sample, i) => this.#upright(sample, view, look.cursor, 'AB'[i] ?? ''));
  }

  #x(sample: number, { from, to }: View): number {
    const part = (sample - from) / Math.max(1, to - 1 - from);
    return left_px + part * (this.#width - left_px - right_px);
  }

  #frame(
    top: number,
    height: number,
    unit: string,
    range: Extremes,
    y: (value: number) => number,
    look: Look,
  ): void {
    const context = this.#context;
    context.strokeStyle = look.line;
    context.fillStyle = look.text;
    context.lineWidth = 1;
    context.strokeRect(left_px, top, this.#width - left_px - right_px, height);
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const value of ticks(range.low, range.high, Math.max(2, height / 45))) {
      context.beginPath();
      context.moveTo(left_px, y(value));
      context.lineTo(this.#width - right_px, y(value));
      context.globalAlpha = 0.4;
      context.stroke();
      context.globalAlpha = 1;
      if (y(value) > top + 26) context.fillText(shortNumber(value), left_px - 6, y(value));
    }
    context.fillText(unit, left_px - 6, top + 9);
  }

  #signal(signal: Signal, colour: string, view: View, y: (value: number) => number): void {
    const context = this.#context;
    const columns = Math.max(1, Math.round(this.#width - left_px - right_px));
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    if (view.to - view.from > 2 * columns) {
      envelope(signal.values, view.from, view.to, columns).forEach((part, column) => {
        if (part === null) return;
        context.moveTo(left_px + column + 0.5, y(part.low) + 0.5);
        context.lineTo(left_px + column + 0.5, y(part.high) - 0.5);
      });
    } else {
      let open = false;
      for (let i = view.from; i < view.to; ++i) {
        const value = signal.values[i] ?? NaN;
        if (Number.isNaN(value)) open = false;
        else if (open) context.lineTo(this.#x(i, view), y(value));
        else context.moveTo(this.#x(i, view), y(value));
        open = !Number.isNaN(value);
      }
    }
    context.stroke();
  }

  #limits(limit: number, y: (value: number) => number, look: Look): void {
    const context = this.#context;
    context.strokeStyle = look.limit;
    context.setLineDash([6, 4]);
    for (const value of [limit, -limit]) {
      context.beginPath();
      context.moveTo(left_px, y(value));
      context.lineTo(this.#width - right_px, y(value));
      context.stroke();
    }
    context.setLineDash([]);
  }

  #times(view: View, look: Look): void {
    const context = this.#context;
    const seconds = (sample: number): number => (sample - view.trigger) * view.cycle_s;
    context.fillStyle = look.text;
    context.textAlign = 'center';
    context.textBaseline = 'alphabetic';
    const count = Math.max(2, (this.#width - left_px) / 110);
    for (const time of ticks(seconds(view.from), seconds(view.to - 1), count)) {
      const x = this.#x(time / view.cycle_s + view.trigger, view);
      if (x > left_px + 10 && x < this.#width - 40)
        context.fillText(`${shortNumber(time)} ${t('unit.s')}`, x, this.#height - 6);
    }
  }

  #upright(sample: number, view: View, colour: string, name: string): void {
    if (sample < view.from || sample >= view.to) return;
    const context = this.#context;
    const x = this.#x(sample, view);
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, this.#height - foot_px);
    context.stroke();
    context.textAlign = 'left';
    context.textBaseline = 'top';
    // The trigger below, the cursors above: they may stand at the same place.
    context.fillText(name, x + 3, name === 'T' ? this.#height - foot_px - 18 : 2);
  }
}

const shortNumber = (value: number): string =>
  String(Number(value.toPrecision(6))).replace('-', '\u2212');
