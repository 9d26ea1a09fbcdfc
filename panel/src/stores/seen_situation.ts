// The situation that is before the eyes of somebody who writes: what is written was meant for it. A command
// that goes with its number is refused where codes, tool or tables have changed since.
import type { Channel } from './machine.svelte';

type Shown = Pick<Channel, 'id' | 'state' | 'situation' | 'run'>;

export class SeenSituation {
  #seen: Pick<Channel, 'id' | 'situation'> | null = null;
  // The run before the own line that was sent last; null: nothing of it is awaited any more.
  #sent: Pick<Channel, 'id' | 'run'> | null = null;

  /** The line and the status as they are now: what was seen when the writing began counts. While an own
      line runs its end is waited for, so that the next one can be written meanwhile. */
  write(text: string, channel: Shown): void {
    if (text.trim() === '' || this.#ownLineRuns(channel)) this.#seen = null;
    else if (this.#seen?.id !== channel.id)
      this.#seen = { id: channel.id, ...situationOf(channel) };
  }

  /** The line goes to this channel. */
  send({ id, run }: Shown): void {
    this.#sent = { id, ...(run === undefined ? {} : { run }) };
  }

  /** It was not taken. Who goes on has the status of now before the eyes. */
  refuse(): void {
    this.#seen = this.#sent = null;
  }

  /** As parameters of a command to this channel. */
  of(channel: Shown): { situation?: number } {
    return situationOf(this.#seen?.id === channel.id ? this.#seen : channel);
  }

  #ownLineRuns({ id, run = 0, state }: Shown): boolean {
    if (this.#sent?.id !== id) return false;
    const before = this.#sent.run ?? 0;
    if (run === before || (run === before + 1 && state === 'Active')) return true;
    this.#sent = null;
    return false;
  }
}

/** The situation that is shown, as parameters of a command. */
export const situationOf = ({ situation }: Pick<Channel, 'situation'>): { situation?: number } =>
  situation === undefined ? {} : { situation };
