// Tools and work offsets, and what this page changed of them, so that it can be taken back.
import type { Result } from '../rpc/json_rpc';
import type { Methods } from '../generated/client';
import { t } from '../text/text';
import { programNumber } from './format';
import { store } from './machine.svelte';

export type Tool = Result<'tool.list'>['tools'][number];
export type ToolKey = Methods['tool.set']['params']['key'];

export interface Change {
  what: string;
  from: number;
  to: number;
  at: number;
  /** The value as the tables have it. */
  now: () => number;
  send: (value: number) => Promise<unknown>;
}

/** In the order of the numbers that G10 gives them. */
export const offsetsOfG10 = 'G54 G55 G56 G57 G58 G59 G59.1 G59.2 G59.3'.split(' ');

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
    await this.#change({
      what: `T${number}.${edge} ${key}`,
      to: value,
      now: () => this.tools?.find((one) => one.number === number && one.edge === edge)?.[key] ?? 0,
      send: (next) => store.call('tool.set', { number, edge, key, value: next }),
    });
  }

  async setOffset(offset: string, axis: string, value: number): Promise<void> {
    await this.#change({
      what: `${offset} ${axis}`,
      to: value,
      now: () => this.offsets[offset]?.[axis] ?? 0,
      send: (next) => store.call('offset.set', { offset, axis, value: next }),
    });
  }

  /** Makes the point where the axes stand have this coordinate. */
  async touchOff(offset: string, word: string, value: number, channel: number): Promise<void> {
    const number = offsetsOfG10.indexOf(offset) + 1;
    const text = `G10 L20 P${number} ${word}${programNumber(value)}`;
    await store.call('mdi', { text, channel, wait: 'done' });
    await this.read();
  }

  /** Refused when somebody has changed the value since. */
  async undo(): Promise<void> {
    const [last, ...older] = this.changes;
    if (last === undefined) return;
    await this.read();
    if (last.now() !== last.to) throw new Error(t('tables.changed_since', { what: last.what }));
    await last.send(last.from);
    this.changes = older;
    await this.read();
  }

  async #change(wanted: Omit<Change, 'from' | 'at'>): Promise<void> {
    const from = wanted.now();
    await wanted.send(wanted.to);
    await this.read();
    this.changes = [{ ...wanted, from, at: Date.now() }, ...this.changes].slice(0, changesKept);
  }
}

export const tables = new Tables();
