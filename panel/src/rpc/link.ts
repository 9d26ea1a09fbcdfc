// The WebSocket to stanok-web: one JSON-RPC message a text frame, paged geometry in binary frames.
//
// It connects again by itself, notices within a second that nothing comes any more, and never sends
// anything later than it was asked for: a call without a connection fails at once, and calls that
// have not been answered when the connection goes fail then. While nothing is heard only stops are
// sent: what else waited in a network that hangs would be done when it comes alive again.
import { stop_methods } from '../generated/client';
import { noData, ownNumbers, Refusal, refusalOf, type Message } from './json_rpc';

export type LinkState = 'connecting' | 'live' | 'lost';

export interface LinkHooks {
  /** The state, and when the daemon was heard last (ms since 1970). */
  changed(state: LinkState, heardAt: number): void;
  /** The first message of a connection has come. */
  greeted(hello: unknown): void;
  notified(method: string, params: unknown): void;
  binary(frame: ArrayBuffer): void;
  /** No connection comes about; true when it is no use to try again (signed out). */
  refused(): Promise<boolean>;
}

/** What the link wants of a WebSocket; tests have one of their own. */
export interface Socket {
  onopen: (() => void) | null;
  onclose: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  send(text: string): void;
  close(): void;
}

/** Stops are sent while nothing is heard, and as often as they are asked for. */
export const isStop = (method: string): boolean => stop_methods.includes(method);

interface Waiting {
  resolve(result: unknown): void;
  reject(error: Refusal): void;
}

/** The daemon speaks 20 times a second; after this silence its values are old. */
export const silence_ms = 800;
const hopeless_ms = 4000;
/** A connection that has brought no greeting by then leads nowhere: browsers wait for minutes. */
export const greeting_ms = 6000;
const watch_ms = 200;
const retry_ms = [250, 500, 1000, 2000, 4000];

export class Link {
  #state: LinkState = 'connecting';
  #socket: Socket | null = null;
  #greeted = false;
  #heardAt = Date.now();
  #begunAt = Date.now();
  #attempt = 0;
  #nextId = 1;
  #waiting = new Map<number, Waiting>();
  #watch: ReturnType<typeof setInterval> | null = null;
  #retry: ReturnType<typeof setTimeout> | null = null;

  constructor(
    private readonly open: () => Socket,
    private readonly hooks: LinkHooks,
  ) {}

  start(): void {
    this.#watch ??= setInterval(() => this.#look(), watch_ms);
    this.#connect();
  }

  stop(): void {
    if (this.#watch !== null) clearInterval(this.#watch);
    if (this.#retry !== null) clearTimeout(this.#retry);
    this.#watch = this.#retry = null;
    this.#drop();
  }

  /** Begins a new connection, with the rights that the session has now. */
  again(): void {
    this.#drop();
    if (this.#retry !== null) clearTimeout(this.#retry);
    this.#state = 'connecting';
    this.#attempt = 0;
    this.#connect();
  }

  get live(): boolean {
    return this.#state === 'live';
  }

  /** The refusal says so when nothing was sent, or when no answer came. */
  request(method: string, params: object): Promise<unknown> {
    const socket = this.#socket;
    const isHeard = this.#state === 'live' || isStop(method);
    if (socket === null || !this.#greeted || !isHeard) {
      return Promise.reject(new Refusal(ownNumbers.notConnected, '', noData));
    }
    const id = this.#nextId++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      socket.send(JSON.stringify({ jsonrpc: '2.0', id, method, params }));
    });
  }

  #connect(): void {
    const socket = this.open();
    this.#socket = socket;
    this.#greeted = false;
    this.#begunAt = Date.now();
    socket.onmessage = (event) => this.#receive(event.data);
    socket.onclose = () => this.#closed();
  }

  // Nothing of this connection is heard any more.
  #drop(): void {
    const socket = this.#socket;
    this.#socket = null;
    if (socket !== null) {
      socket.onmessage = socket.onclose = null;
      socket.close();
    }
    this.#forget();
  }

  #closed(): void {
    const heard = this.#greeted;
    this.#drop();
    this.#set('lost');
    if (heard) this.#attempt = 0;
    const wait = retry_ms[Math.min(this.#attempt, retry_ms.length - 1)] ?? 1000;
    this.#attempt += 1;
    this.#retry = setTimeout(() => void this.#tryAgain(heard), wait);
  }

  async #tryAgain(heard: boolean): Promise<void> {
    if (!heard && (await this.hooks.refused())) return;
    if (this.#socket === null && this.#watch !== null) this.#connect();
  }

  #forget(): void {
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const one of waiting) one.reject(new Refusal(ownNumbers.connectionLost, '', noData));
  }

  #look(): void {
    const silent = Date.now() - this.#heardAt;
    if (this.#state === 'live' && silent > silence_ms) this.#set('lost');
    if (this.#socket === null) return;
    const ungreeted = Date.now() - this.#begunAt;
    if (this.#greeted ? silent > hopeless_ms : ungreeted > greeting_ms) this.#closed();
  }

  #set(state: LinkState): void {
    if (state === this.#state) return;
    this.#state = state;
    this.hooks.changed(state, this.#heardAt);
  }

  #receive(data: unknown): void {
    this.#heardAt = Date.now();
    if (this.#greeted) this.#set('live');
    if (data instanceof ArrayBuffer) this.hooks.binary(data);
    else if (typeof data === 'string') this.#take(JSON.parse(data) as Message);
  }

  #take(message: Message): void {
    if (message.method === 'hello') {
      this.#greeted = true;
      this.#attempt = 0;
      this.#set('live');
      this.hooks.greeted(message.params);
    } else if (message.method !== undefined) {
      this.hooks.notified(message.method, message.params);
    } else {
      this.#answer(message);
    }
  }

  #answer(message: Message): void {
    const waiting = this.#waiting.get(message.id ?? -1);
    if (waiting === undefined) return;
    this.#waiting.delete(message.id ?? -1);
    if (message.error !== undefined) waiting.reject(refusalOf(message.error));
    else waiting.resolve(message.result);
  }
}
