// Touching off: an axis stands at a value from now on. What is sent is a value of the machine, in mm or
// deg, with the situation that was looked at; no code in force changes its meaning.
import { Refusal, type Params } from '../rpc/json_rpc';
import { t } from '../text/text';
import type { Channel } from './machine.svelte';
import { isDiameter, unitsOf, wordIn } from './position_words';
import { situationChanged, unlikelyValue } from './refusal.svelte';
import { tables, type Change } from './tables.svelte';

type Wanted = Params<'offset.touch'>;

/** Of refusals: the change, or the value, is larger than is likely. */
const largeCodes = ['E6093', unlikelyValue];

class TouchOff {
  /** Why the daemon wants to have it confirmed, in its words; null: nothing waits for an answer. */
  question = $state.raw<string | null>(null);
  /** Codes, tool or tables became others after the value was written; it was not touched off. */
  hasChanged = $state(false);
  #last = $state.raw<Change | null>(null);
  /** The last one, as long as no other change of this page came behind it. */
  readonly done = $derived(this.#last === tables.changes[0] ? this.#last : null);

  // In which situation the value was written; null: none was since the last one was touched off.
  #seen: number | null = null;
  #asked: Wanted | null = null;

  /** Somebody writes what is to be touched off, with this status before the eyes. */
  look({ situation }: Channel): void {
    this.#seen = situation ?? null;
    this.forget();
  }

  /** Nobody looks any more. */
  leave(): void {
    this.#seen = null;
    this.forget();
  }

  /** Takes nothing for asked and nothing for told any more. */
  forget(): void {
    this.question = this.#asked = null;
    this.hasChanged = false;
  }

  /** `written`: in the unit of the channel, a diameter where the word is one. */
  async touch(channel: Channel, offset: string, word: string, written: string): Promise<void> {
    const value = wordIn(written, word, unitsOf(channel));
    if (value === null) throw new Error(t('number.none'));
    const situation = this.#seen ?? channel.situation;
    this.forget();
    await this.#send({
      channel: channel.id,
      offset,
      axis: word,
      value,
      ...(isDiameter(channel, word) ? { as: 'diameter' as const } : {}),
      ...(situation === undefined ? {} : { situation }),
    });
  }

  /** Sends what was asked about again: it is meant. */
  async confirm(): Promise<void> {
    const asked = this.#asked;
    this.forget();
    if (asked !== null) await this.#send({ ...asked, confirmed: 1 });
  }

  async #send(wanted: Wanted): Promise<void> {
    try {
      this.#last = await tables.touchOff(wanted);
      this.#seen = null;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      if (error.data.code === situationChanged) {
        this.hasChanged = true;
        // Who goes on has the new numbers before the eyes.
        this.#seen = null;
      } else if (largeCodes.includes(error.data.code ?? '')) {
        this.question = error.message;
        this.#asked = wanted;
      } else throw error;
    }
  }
}

export const touchOff = new TouchOff();
