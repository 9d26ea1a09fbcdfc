// Tools and work offsets, and what this page changed of them, so that it can be taken back.
import type { Result } from '../rpc/json_rpc';
import type { Methods } from '../generated/client';
import { store } from './machine.svelte';

export type Tool = Result<'tool.list'>['tools'][number];
export type ToolKey = Methods['tool.set']['params']['key'];

export interface Change {
  what: string;
  from: number;
  to: number;
  at: number;
  undo: () => Promise<unknown>;
}

const changesKept = 100;

class Tables {
  tools = $state.raw<Tool[] | null>(null);
  axes = $state.raw<string[]>([]);
  offsets = $state.raw<Record<string, Record<string, number>>>({});
  changes = $state.raw<Change[]>([]);

  async read(): Promise<void> {
    const [tools, offsets] = await Promise.all([
      store.call('tool.list'),
      store.call('offset.list'),
    ]);
    this.tools = tools.tools;
    this.axes = offsets.axes;
    this.offsets = offsets.offsets;
  }

  async setTool(tool: Tool, key: ToolKey, value: number): Promise<void> {
    const { number, edge } = tool;
    const send = (next: number): Promise<unknown> =>
      store.call('tool.set', { number, edge, key, value: next }).then(() => this.read());
    await send(value);
    this.#remember(`T${number}.${edge} ${key}`, tool[key] ?? 0, value, send);
  }

  async setOffset(offset: string, axis: string, value: number): Promise<void> {
    const before = this.offsets[offset]?.[axis] ?? 0;
    const send = (next: number): Promise<unknown> =>
      store.call('offset.set', { offset, axis, value: next }).then(() => this.read());
    await send(value);
    this.#remember(`${offset} ${axis}`, before, value, send);
  }

  /** Makes the point where the axes stand have this coordinate. */
  async touchOff(offset: string, word: string, value: number, channel: number): Promise<void> {
    const index = Object.keys(this.offsets).indexOf(offset) + 1;
    await store.call('mdi', { text: `G10 L20 P${index} ${word}${value}`, channel, wait: 'done' });
    await this.read();
  }

  async undo(): Promise<void> {
    const [last, ...older] = this.changes;
    if (last === undefined) return;
    await last.undo();
    this.changes = older;
  }

  #remember(what: string, from: number, to: number, send: (v: number) => Promise<unknown>): void {
    const change = { what, from, to, at: Date.now(), undo: () => send(from) };
    this.changes = [change, ...this.changes].slice(0, changesKept);
  }
}

export const tables = new Tables();
