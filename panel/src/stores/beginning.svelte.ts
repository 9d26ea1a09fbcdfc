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
  approach?: {
    number: number;
    changes: string[];
    moves: { kind: string; length_mm: number; feed_mm_min: number | null }[];
  };
}

/** "lift 10 mm, lateral 120.8 mm, plunge 6 mm at 600 mm/min" */
export const wayOf = ({ approach }: Found): string =>
  (approach?.moves ?? [])
    .map(({ kind, length_mm, feed_mm_min }) => {
      const feed = feed_mm_min === null ? '' : ` · F${Math.round(feed_mm_min)}`;
      return `${t(`search.${kind}` as 'search.lift')} ${length_mm.toFixed(1)} mm${feed}`;
    })
    .join(', ');

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

  /** What is asked before a start in the middle. */
  get question(): string | null {
    const found = this.found;
    if (found?.approach === undefined) return null;
    const changes = found.approach.changes.join(', ');
    const way = wayOf(found);
    return t('start.question', {
      place: found.target,
      way: way === '' ? '–' : way,
      changes: changes === '' ? '–' : changes,
    });
  }

  async start(channel: Channel): Promise<void> {
    if (this.isUnsearched(channel)) {
      const remedy = t('start.unsearched_remedy');
      throw new Refusal(0, this.sentence(channel), { ...noData, remedy });
    }
    const approach = this.found?.approach?.number;
    const way = channel.begins_at != null && approach !== undefined ? { approach, restore: 1 } : {};
    await store.call('program.start', { channel: channel.id, ...way, ...situationOf(channel) });
    this.target = this.#searched = '';
    this.found = null;
  }
}

const beginnings: Record<number, Beginning> = {};

export const beginningOf = (channel: number): Beginning =>
  (beginnings[channel] ??= new Beginning());
