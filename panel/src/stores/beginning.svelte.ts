// Where Start begins, channel by channel: at the top, at the block that was searched, or nowhere, while a place is
// written on this page that nobody has searched.
import { noData, Refusal } from '../rpc/json_rpc';
import { t } from '../text/text';
import { store, type Channel } from './machine.svelte';
import { situationOf } from './seen_situation';

export interface Found {
  target: string;
  calculated: boolean;
  units?: string;
  diameter?: string[];
  position?: Record<string, number>;
  stands_at?: Record<string, number>;
  work_offset?: string;
  tool?: number;
  coolant?: unknown;
  spindles?: { spindle: number; turns: string; speed_rev_per_min: number }[];
  not_executed?: { what: string; count: number; first_line: number }[];
}

type Loaded = Pick<Channel, 'id' | 'begins_at' | 'program'>;

export class Beginning {
  /** What is written in the field. */
  target = $state('');
  found = $state.raw<Found | null>(null);
  #searched = $state('');

  /** Something is written that the next start would not begin at. */
  isUnsearched({ begins_at }: Loaded): boolean {
    const target = this.target.trim();
    return target !== '' && (target !== this.#searched || begins_at == null);
  }

  async search(channel: number): Promise<void> {
    const target = this.target.trim();
    this.found = null;
    this.#searched = '';
    this.found = (await store.call('program.search', { target, channel })) as Found;
    this.#searched = target;
  }

  /** What Start will do, in a sentence; none without a program. */
  sentence(channel: Loaded): string {
    if (this.isUnsearched(channel)) return t('start.unsearched', { place: this.target.trim() });
    if (channel.program == null) return '';
    if (channel.begins_at != null) return t('start.at', { place: channel.begins_at });
    return t('start.top', { program: channel.program });
  }

  async start(channel: Channel): Promise<void> {
    if (this.isUnsearched(channel)) {
      const remedy = t('start.unsearched_remedy');
      throw new Refusal(0, this.sentence(channel), { ...noData, remedy });
    }
    await store.call('program.start', { channel: channel.id, ...situationOf(channel) });
    this.target = this.#searched = '';
    this.found = null;
  }
}

const beginnings: Record<number, Beginning> = {};

export const beginningOf = (channel: number): Beginning =>
  (beginnings[channel] ??= new Beginning());
