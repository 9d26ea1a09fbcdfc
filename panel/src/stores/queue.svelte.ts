// The queue of the chosen channel: programs that begin one after the other. Read again when the daemon says that it is
// another one.
import type { Result } from '../rpc/json_rpc';
import { store } from './machine.svelte';

export type Queue = Result<'queue.list'>['queues'][number];

class QueueStore {
  shown = $state.raw<Queue | null>(null);

  take({ queues }: Result<'queue.list'>): void {
    this.shown = queues.find((one) => one.channel === store.chosen) ?? null;
  }

  async read(): Promise<void> {
    this.take(await store.call('queue.list', { channel: store.chosen }));
  }

  async add(program: string): Promise<void> {
    this.take(await store.call('queue.add', { program, channel: store.chosen }));
  }
}

export const queue = new QueueStore();
