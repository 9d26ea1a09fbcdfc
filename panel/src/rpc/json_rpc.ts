// JSON-RPC 2.0 as the daemon speaks it: the shapes of its messages and the error that a call throws.
import type { MethodName, Methods } from '../generated/client';

/** What the daemon says about a refusal, besides its sentence. */
export interface RefusalData {
  code: string | null;
  channel: number | null;
  file: string | null;
  line: number | null;
  column: number | null;
  reaction: number | null;
  remedy: string | null;
}

export interface Message {
  id?: number | null;
  method?: string;
  params?: unknown;
  result?: unknown;
  error?: { code: number; message: string; data?: Partial<RefusalData> };
}

/** A call that did not do what it was asked for: refused by the daemon, or never sent. */
export class Refusal extends Error {
  constructor(
    readonly number: number,
    message: string,
    readonly data: RefusalData,
  ) {
    super(message);
    this.name = 'Refusal';
  }
}

/** A refusal that becomes a question: what is meant all the same is done again, confirmed. */
export class Question extends Refusal {
  constructor(
    { number, message, data }: Refusal,
    readonly again: () => Promise<unknown>,
  ) {
    super(number, message, data);
  }
}

export const noData: RefusalData = {
  code: null,
  channel: null,
  file: null,
  line: null,
  column: null,
  reaction: null,
  remedy: null,
};

/** Numbers of refusals that the page itself makes; the daemon uses none of them. */
export const ownNumbers = { notConnected: 1, connectionLost: 2, jogLate: 3 } as const;

export type Params<M extends MethodName> = Methods[M]['params'];
export type Result<M extends MethodName> = Methods[M]['result'];

/** Parameters may be left out where a method wants none. */
export type Arguments<M extends MethodName> =
  Record<string, never> extends Params<M> ? [params?: Params<M>] : [params: Params<M>];

export type Call = <M extends MethodName>(method: M, ...params: Arguments<M>) => Promise<Result<M>>;

export function refusalOf(error: NonNullable<Message['error']>): Refusal {
  return new Refusal(error.code, error.message, { ...noData, ...error.data });
}
