// The cutting process of a channel while somebody looks at it: what it is now, and its last minute.
import type { Signal } from '../plot/samples';
import type { Result } from '../rpc/json_rpc';
import { store } from './machine.svelte';

/** An automatic feed law: what the cycle makes of a sensor. */
export interface AutomaticLaw {
  law: 'modulated' | 'linear';
  state: 'reset' | 'ready' | 'running' | 'fault'; // reset: off
  feed_part: number;
}

export interface Interruption {
  la_mm: number;
  lb_mm: number;
  rests: number;
}

/** Control of the cutting force. */
export interface ForceControl {
  state: 'off' | 'idle_power' | 'holding' | 'regulating' | 'fault';
  force_set_n: number;
  force_n: number;
  power_w: number | null;
  power_idle_w: number;
  radius_mm: number;
  feed_min_mm_min: number;
  feed_max_mm_min: number;
  vibration_um: number;
  vibration_hz: number;
  level_um: number;
  reduced_mass_kg: number;
  oscillation_n: number;
  oscillation_hz: number;
  doubt?: 'none' | 'lost' | 'below_idle' | 'no_answer' | 'stays_high';
  reference?: 'none' | 'programmed' | 'cut';
  force_worst_n?: number | null;
}

export type ProcessStatus = Omit<
  Result<'process.status'>,
  'adaptive' | 'automatic' | 'interruption'
> & {
  adaptive: ForceControl | null;
  automatic: AutomaticLaw[];
  interruption: Interruption | null;
};

export const period_s = 0.2;
const kept = 300;

type Reading = (status: ProcessStatus) => number | null;
const readings: [name: 'feed' | 'force' | 'force_set' | 'power' | 'vibration', string, Reading][] =
  [
    ['feed', 'mm/min', (now) => now.feed_mm_min],
    ['force', 'N', (now) => now.adaptive?.force_n ?? null],
    ['force_set', 'N', (now) => now.adaptive?.force_set_n ?? null],
    ['power', 'W', (now) => now.adaptive?.power_w ?? null],
    ['vibration', 'µm', (now) => now.adaptive?.vibration_um ?? null],
  ];
export type ReadingName = (typeof readings)[number][0];

/** The newest values stand at the end; what was not there yet is no number. */
export class History {
  readonly #columns = readings.map(() => new Float32Array(kept).fill(NaN));

  add(status: ProcessStatus): void {
    readings.forEach(([, , read], i) => {
      const values = this.#columns[i];
      values?.copyWithin(0, 1);
      values?.set([read(status) ?? NaN], kept - 1);
    });
  }

  /** Those of which there is a value. */
  signals(nameOf: (name: ReadingName) => string): Signal[] {
    return readings.flatMap(([name, unit], i) => {
      const values = this.#columns[i] ?? new Float32Array();
      const isThere = values.some((value) => !Number.isNaN(value));
      return isThere ? [{ name: nameOf(name), unit, limit: null, values }] : [];
    });
  }
}

export class ProcessFollower {
  status = $state.raw<ProcessStatus | null>(null);
  /** Grows with every reading. */
  readings = $state(0);
  history = new History();

  /** Looks at the channel until the function that it gives back is called. */
  follow(channel: number): () => void {
    this.history = new History();
    // What comes when another channel is looked at is not of that one.
    let isOver = false;
    const timer = setInterval(() => {
      if (!store.live) return;
      store.call('process.status', { channel }).then(
        (answer) => (isOver ? undefined : this.#take(answer as ProcessStatus)),
        () => undefined,
      );
    }, period_s * 1000);
    return () => {
      isOver = true;
      clearInterval(timer);
      this.status = null;
    };
  }

  #take(status: ProcessStatus): void {
    this.status = status;
    this.history.add(status);
    this.readings += 1;
  }
}
