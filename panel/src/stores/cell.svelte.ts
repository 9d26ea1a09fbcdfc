// The machines that the server of this page shows, and whether it has their history.
import { sessionFields } from '../rpc/session';
import type { Channel } from './machine.svelte';

export type GlanceChannel = Pick<
  Channel,
  | 'id'
  | 'name'
  | 'state'
  | 'program_status'
  | 'program'
  | 'line'
  | 'predicted_s'
  | 'remaining_s'
  | 'alarm'
  | 'held_by'
> &
  Partial<Pick<Channel, 'override' | 'speed_mm_s' | 'g_codes' | 'words' | 'cycle' | 'position'>> & {
    /** Nothing has moved since it was seen before. */
    stands?: boolean;
  };

/** What the server saw of a machine within the last second or two. */
export interface Glance {
  id: string;
  name: string;
  answers: boolean;
  /** null: not known. */
  on: boolean | null;
  channels: GlanceChannel[];
}

interface Overview {
  machines: Glance[];
  history: boolean;
}

/** What was seen of a machine now and before: where the axes of a channel are as they were, it stands. Not seen anew
    is what the server had seen before. */
export function withMotion(now: Glance, before: Glance | undefined): Glance {
  const channels = now.channels.map((channel) => {
    const known = before?.channels.find((one) => one.id === channel.id);
    const [there, then] = [channel, known].map((one) => JSON.stringify(one?.position));
    const isSame = known?.cycle === channel.cycle;
    return { ...channel, stands: isSame ? known?.stands === true : there === then };
  });
  return { ...now, channels };
}

const every_ms = 1000;
const patience_ms = 5000;

/** The machine that this page shows: its id, empty for the first one. */
export const machineOf = (place: { search: string }): string =>
  new URLSearchParams(place.search).get('machine') ?? '';

/** The page of another machine. It is loaded anew: nothing of one machine is left for the other. */
export const pageOf = (id: string): string => `/?machine=${encodeURIComponent(id)}`;

class CellStore {
  machines = $state.raw<Glance[]>([]);
  hasHistory = $state(false);
  /** When the server answered last; 0: not yet. */
  heardAt = $state(0);
  failed = $state(false);

  /** Whether there is more than the one machine of this page. */
  readonly isShown = $derived(this.machines.length > 1 || this.hasHistory);

  async read(): Promise<void> {
    try {
      const signal = AbortSignal.timeout(patience_ms);
      const answer = await fetch('/api/machines', { headers: sessionFields(), signal });
      if (!answer.ok) throw new Error(String(answer.status));
      const overview = (await answer.json()) as Overview;
      const before = this.machines;
      this.machines = overview.machines.map((now) =>
        withMotion(
          now,
          before.find(({ id }) => id === now.id),
        ),
      );
      this.hasHistory = overview.history;
      this.heardAt = Date.now();
      this.failed = false;
    } catch {
      this.failed = true;
    }
  }

  /** Reads again and again until the function that it gives back is called. */
  watch(): () => void {
    let timer: ReturnType<typeof setTimeout> | null = null;
    let over = false;
    const again = async (): Promise<void> => {
      await this.read();
      if (!over) timer = setTimeout(() => void again(), every_ms);
    };
    void again();
    return () => {
      over = true;
      if (timer !== null) clearTimeout(timer);
    };
  }
}

export const cell = new CellStore();
