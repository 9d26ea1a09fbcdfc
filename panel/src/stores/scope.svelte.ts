// A recording of the scope: asked for in parts while it grows, kept outside of what the framework watches.
import type { Methods } from '../generated/client';
import { columnsOf, type Signal } from '../plot/samples';
import type { Result } from '../rpc/json_rpc';
import { store } from './machine.svelte';

export type ScopeOrder = Methods['scope.start']['params'];
type Reading = Result<'scope.read'>;

const period_ms = 200;
const farBehind = 1_000_000_000;

export class Recording {
  state = $state<'off' | 'waiting' | 'recording' | 'complete'>('off');
  /** Grows with what there is to be drawn. */
  count = $state(0);
  trigger = $state(0);
  cycle_s = $state(0.001);
  signals: Signal[] = [];
  #id = 0;

  async start(order: ScopeOrder): Promise<void> {
    await store.call('scope.start', order);
    await this.read();
  }

  async stop(): Promise<void> {
    await store.call('scope.stop');
    await this.read();
  }

  /** What is new of it. Before the trigger the oldest samples go as new ones come: nothing is read then. */
  async read(): Promise<void> {
    const now = await store.call('scope.read', { from: farBehind });
    if (now.id !== this.#id) this.#begin(now);
    this.state = now.state as Recording['state'];
    if (this.state === 'waiting' || this.state === 'off') return;
    this.trigger = now.trigger ?? 0;
    for (let have = this.count; have < now.cycles;) {
      const part = await store.call('scope.read', { from: have });
      if (part.id !== this.#id || part.count === 0) return;
      this.#append(part);
      have = this.count;
    }
  }

  /** Reads on until the function that it gives back is called. */
  follow(failed: (error: unknown) => void): () => void {
    let isOver = false;
    const look = async (): Promise<void> => {
      while (!isOver) {
        if (store.live && this.state !== 'complete') await this.read().catch(failed);
        await new Promise((resolve) => setTimeout(resolve, period_ms));
      }
    };
    // Later: who calls this from an effect must not depend on what it reads.
    void Promise.resolve().then(look);
    return () => (isOver = true);
  }

  #begin({ id, signals, cycle_us }: Reading): void {
    this.#id = id;
    this.cycle_s = cycle_us / 1e6;
    this.signals = signals.map((one) => ({ ...one, values: new Float32Array() }));
    this.count = 0;
  }

  #append({ values, count }: Reading): void {
    const columns = columnsOf(values, this.signals.length);
    this.signals = this.signals.map((signal, i) => {
      const longer = new Float32Array(signal.values.length + count);
      longer.set(signal.values);
      longer.set(columns[i] ?? [], signal.values.length);
      return { ...signal, values: longer };
    });
    this.count += count;
  }
}

export const recording = new Recording();
