// Something of the process that the daemon calculates: its answer, and whether it is under way.
import type { MethodName } from '../generated/client';
import { Refusal, type Params, type Result } from '../rpc/json_rpc';
import { numberIn } from './format';
import { store } from './machine.svelte';
import { t } from '../text/text';

/** What a calculation says that was given up. */
export const cancelled = 'E9017';

type Calculated = 'process.stability' | 'process.figures' | 'process.forces';

export class Calculation<M extends Calculated & MethodName> {
  answer = $state.raw<Result<M> | null>(null);
  busy = $state(false);

  constructor(private readonly method: M) {}

  async begin(params: Params<M>): Promise<void> {
    this.busy = true;
    this.answer = null;
    try {
      this.answer = await (store.call as (method: M, params: Params<M>) => Promise<Result<M>>)(
        this.method,
        params,
      );
    } catch (error) {
      if (!(error instanceof Refusal && error.data.code === cancelled)) throw error;
    } finally {
      this.busy = false;
    }
  }

  end(): Promise<unknown> {
    return store.call('process.cancel');
  }
}

/** The numbers of fields, without those that are empty; what is no number is told. */
export function numbersOf<Name extends string>(
  fields: Record<Name, string>,
): Partial<Record<Name, number>> {
  const numbers: Partial<Record<Name, number>> = {};
  for (const [name, text] of Object.entries<string>(fields) as [Name, string][]) {
    if (text.trim() === '') continue;
    const number = numberIn(text);
    if (number === null) throw new Error(t('number.none'));
    numbers[name] = number;
  }
  return numbers;
}
