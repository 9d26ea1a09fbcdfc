// Tools and work offsets, and what this page changed of them, so that it can be taken back.
import { Question, Refusal, type Params, type Result } from '../rpc/json_rpc';
import type { Methods } from '../generated/client';
import { t } from '../text/text';
import { store } from './machine.svelte';
import { unlikelyValue } from './refusal.svelte';

export type Tool = Result<'tool.list'>['tools'][number];
export type ToolKey = Methods['tool.set']['params']['key'];

type Confirmed = { confirmed?: 1 };

export interface Change {
  what: string;
  from: number;
  to: number;
  at: number;
  /** The value as the tables have it. */
  now: () => number;
  /** Confirmed where somebody was asked about it. */
  send: (value: number, confirmed: Confirmed) => Promise<unknown>;
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
    await this.#change({
      what: `T${number}.${edge} ${key}`,
      to: value,
      now: () => this.tools?.find((one) => one.number === number && one.edge === edge)?.[key] ?? 0,
      send: (next, confirmed) =>
        store.call('tool.set', { number, edge, key, value: next, ...confirmed }),
    });
  }

  async setOffset(offset: string, axis: string, value: number): Promise<void> {
    await this.#change({
      what: `${offset} ${axis}`,
      to: value,
      now: () => this.offsets[offset]?.[axis] ?? 0,
      send: (next, confirmed) =>
        store.call('offset.set', { offset, axis, value: next, ...confirmed }),
    });
  }

  /** An axis stands at a value from now on; taken back by the daemon, which knows the value before. */
  async touchOff(wanted: Params<'offset.touch'>): Promise<Change> {
    const { offset, axis: word, channel } = wanted;
    const { undo, old, new: to } = await store.call('offset.touch', wanted);
    const { words = [], axis_names: names = [] } =
      store.channels.find((one) => one.id === channel) ?? {};
    const axis = names[words.indexOf(word)] ?? word;
    const change: Change = {
      what: `${offset} ${axis}`,
      from: old,
      to,
      at: Date.now(),
      now: () => this.offsets[offset]?.[axis] ?? 0,
      send: () => store.call('offset.undo', { undo }),
    };
    this.#keep(change);
    await this.read();
    return change;
  }

  /** Refused when somebody has changed the value since. */
  async undo(): Promise<void> {
    const [last, ...older] = this.changes;
    if (last === undefined) return;
    await this.read();
    if (last.now() !== last.to) throw new Error(t('tables.changed_since', { what: last.what }));
    await this.#send(last, last.from, async () => {
      this.changes = older;
      await this.read();
    });
  }

  async #change(wanted: Omit<Change, 'from' | 'at'>): Promise<void> {
    const from = wanted.now();
    await this.#send(wanted, wanted.to, async () => {
      await this.read();
      this.#keep({ ...wanted, from, at: Date.now() });
    });
  }

  // A value that the daemon wants to have confirmed is a question.
  async #send(
    change: Pick<Change, 'send'>,
    value: number,
    then: () => Promise<void>,
    confirmed: Confirmed = {},
  ): Promise<void> {
    try {
      await change.send(value, confirmed);
    } catch (error) {
      if (!(error instanceof Refusal) || error.data.code !== unlikelyValue) throw error;
      throw new Question(error, () => this.#send(change, value, then, { confirmed: 1 }));
    }
    await then();
  }

  #keep(change: Change): void {
    this.changes = [change, ...this.changes].slice(0, changesKept);
  }
}

export const tables = new Tables();
