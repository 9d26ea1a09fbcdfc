// The refusal that is shown, and where: beside what was pressed.
import { Question, Refusal, ownNumbers } from '../rpc/json_rpc';
import type { TextKey } from '../text/catalogue';
import { t } from '../text/text';
import { roleRefusal, withPeople } from './people';

/** The command was meant for another situation than the one that the channel is in. */
export const situationChanged = 'E6090';

/** A value above what the machine file thinks likely: it wants to be confirmed. */
export const unlikelyValue = 'E6095';

export interface Shown {
  code: string | null;
  sentence: string;
  remedy: string | null;
  place: string | null;
  at: { left: number; top: number; bottom: number };
  /** Of a question: what yes does; null: nothing is asked. */
  again: (() => Promise<unknown>) | null;
}

/** What an error says, in a sentence. */
export function sentenceOf(error: unknown): string {
  if (error instanceof Refusal) return words(error).sentence;
  return error instanceof Error ? error.message : String(error);
}

class RefusalStore {
  shown = $state.raw<Shown | null>(null);

  /** Shows why something was not done, beside the element that asked for it. */
  show(error: unknown, beside: Element | null): void {
    const box = (beside ?? document.body).getBoundingClientRect();
    const at = { left: box.left, top: box.top, bottom: Math.min(box.bottom, window.innerHeight) };
    const again = error instanceof Question ? () => attempt(beside, error.again) : null;
    const said =
      error instanceof Refusal
        ? words(error)
        : { code: null, sentence: sentenceOf(error), remedy: null, place: null };
    this.shown = { ...said, at, again };
  }

  clear(): void {
    this.shown = null;
  }
}

// What the page says in its own words, and what to do.
function ownWords({ number, data }: Refusal): [TextKey, TextKey] | null {
  if (number === ownNumbers.notConnected) return ['refusal.not_sent', 'refusal.not_sent_remedy'];
  if (number === ownNumbers.connectionLost)
    return ['refusal.no_answer', 'refusal.no_answer_remedy'];
  if (number === ownNumbers.jogLate) return ['refusal.jog_late', 'refusal.jog_late_remedy'];
  if (data.code === situationChanged) return ['refusal.changed', 'refusal.changed_remedy'];
  return null;
}

function words(refusal: Refusal): Omit<Shown, 'at' | 'again'> {
  const own = ownWords(refusal);
  if (own !== null) {
    const [sentence, remedy] = own;
    return { code: refusal.data.code, sentence: t(sentence), remedy: t(remedy), place: null };
  }
  const { code, remedy, file, line } = refusal.data;
  const place = file !== null && line !== null && line > 0 ? `${file}:${line}` : null;
  const ofRole = roleRefusal(refusal.message);
  if (ofRole !== null)
    return { code, sentence: ofRole, remedy: t('refusal.not_permitted_remedy'), place };
  return { code, sentence: withPeople(refusal.message), remedy, place };
}

export const refusals = new RefusalStore();

/** Does what was asked for; a refusal is shown beside `beside`. True when it was done. */
export async function attempt(
  beside: Element | null,
  act: () => Promise<unknown>,
): Promise<boolean> {
  refusals.clear();
  try {
    await act();
    return true;
  } catch (error) {
    refusals.show(error, beside);
    return false;
  }
}
