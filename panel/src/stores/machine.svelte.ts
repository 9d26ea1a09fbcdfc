// What the page knows of the machine: one store, filled by the subscription, read by every view.
//
// Nothing of a job is kept here: what is shown is the daemon's, and a reload loses nothing.
import type { MethodName } from '../generated/client';
import { aged_methods, method_roles } from '../generated/client';
import { Refusal, noData, ownNumbers, type Arguments, type Result } from '../rpc/json_rpc';
import { Link, type LinkState, type Socket } from '../rpc/link';
import { mergePatch, type Json } from '../rpc/merge_patch';
import { currentSession, keyMessage, type Session } from '../rpc/session';
import { machineOf } from './cell.svelte';
import { Freshness } from './freshness';
import { seldom } from './seldom';

export type Machine = Result<'machine.status'>;
export type Drives = Result<'drive.status'>;
/** `at`: Unix time in s, where the daemon knows it. */
export type Alarm = Result<'alarm.list'>['alarms'][number] & { at?: number | null };
// `axes` belongs to the status of a channel of axes; a merge patch takes members away that are null.
export type Channel = Partial<Result<'channel.status'>> &
  Pick<Result<'channel.status'>, 'id' | 'name' | 'state' | 'program_status' | 'override'>;

export interface MachineEvent {
  seq: number;
  cycle: number;
  channel: number;
  code: string;
  text: string;
  line: number;
}

export interface Hello {
  server: string;
  version: string;
  api: number;
  machine: string;
  cycle?: number;
  channels: { id: number; name: string }[];
  session: number;
  role: string;
}

interface Status {
  machine?: Machine;
  drives?: Drives;
  channels?: Record<string, Channel>;
}

export type Phase = LinkState | 'signed_out';

const status_hz = 20;
const eventsKept = 500;
const roleOrder = ['observer', 'operator', 'programmer', 'integrator'];

class MachineStore {
  phase = $state<Phase>('connecting');
  heardAt = $state(Date.now());
  hello = $state.raw<Hello | null>(null);
  session = $state.raw<Session | null>(null);
  machine = $state.raw<Machine | null>(null);
  drives = $state.raw<Drives | null>(null);
  channels = $state.raw<Channel[]>([]);
  alarms = $state.raw<Alarm[]>([]);
  events = $state.raw<MachineEvent[]>([]);
  droppedFor = $state<string | null>(null);
  /** The status that is shown is older than an operator may take it for. */
  isOld = $state(false);
  /** The channel whose axes, MDI and jog are shown. */
  chosen = $state(1);

  #status: Status = {};
  #link: Link | null = null;
  #askAlarms = seldom(100, () => {
    this.call('alarm.list').then(
      (result) => (this.alarms = result.alarms),
      () => undefined,
    );
  });
  #freshness = new Freshness((isOld) => (this.isOld = isOld));
  #listeners = new Map<string, ((params: unknown) => void)[]>();
  #frames: ((frame: ArrayBuffer) => void)[] = [];

  readonly role = $derived(this.hello?.role ?? 'observer');
  readonly live = $derived(this.phase === 'live');
  /** What the status says is so now. */
  readonly fresh = $derived(this.live && !this.isOld);
  readonly channel = $derived(this.channels.find((one) => one.id === this.chosen));

  start(): void {
    if (this.#link !== null) return;
    this.phase = 'connecting';
    this.#link = new Link(openSocket, {
      changed: (state, heardAt) => {
        this.phase = state;
        this.heardAt = heardAt;
      },
      greeted: (hello) => void this.#greet(hello as Hello),
      notified: (method, params) => this.#notified(method, params),
      binary: (frame) => this.#frames.forEach((take) => take(frame)),
      refused: () => this.#refused(),
    });
    this.#link.start();
  }

  /** After signing in: a new connection with the rights of the session. */
  reconnect(): void {
    if (this.#link === null) return this.start();
    this.phase = 'connecting';
    this.#link.again();
  }

  signedOut(): void {
    this.#link?.stop();
    this.#link = null;
    this.phase = 'signed_out';
  }

  may(method: MethodName): boolean {
    const wanted = method_roles[method];
    return roleOrder.indexOf(this.role) >= roleOrder.indexOf(wanted);
  }

  /** The newest cycle of which the page has heard. */
  get seenCycle(): number {
    return Math.max(this.hello?.cycle ?? 0, ...this.channels.map((one) => one.cycle ?? 0));
  }

  call<M extends MethodName>(method: M, ...params: Arguments<M>): Promise<Result<M>> {
    const link = this.#link;
    if (link === null) return Promise.reject(new Refusal(ownNumbers.notConnected, '', noData));
    const seen = aged_methods.includes(method) ? { seen_cycle: this.seenCycle } : {};
    return link.request(method, { ...seen, ...params[0] }) as Promise<Result<M>>;
  }

  on(method: string, take: (params: unknown) => void): () => void {
    const listeners = this.#listeners.get(method) ?? [];
    this.#listeners.set(method, [...listeners, take]);
    return () => {
      const others = (this.#listeners.get(method) ?? []).filter((one) => one !== take);
      this.#listeners.set(method, others);
    };
  }

  onFrame(take: (frame: ArrayBuffer) => void): () => void {
    this.#frames = [...this.#frames, take];
    return () => {
      this.#frames = this.#frames.filter((one) => one !== take);
    };
  }

  async #greet(hello: Hello): Promise<void> {
    this.hello = hello;
    this.droppedFor = null;
    this.#status = {};
    if (!hello.channels.some((one) => one.id === this.chosen)) {
      this.chosen = hello.channels[0]?.id ?? 1;
    }
    try {
      await this.call('subscribe', {
        topics: ['machine', 'channels', 'drives', 'events'],
        rate_hz: status_hz,
      });
      this.#askAlarms();
      await this.#readSession();
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
    }
  }

  async #readSession(): Promise<void> {
    const answer = await currentSession();
    this.session = typeof answer === 'string' ? null : answer;
  }

  async #refused(): Promise<boolean> {
    if ((await currentSession()) !== 'signed_out') return false;
    this.signedOut();
    return true;
  }

  #notified(method: string, params: unknown): void {
    if (method === 'status') this.#patch(params as { full: boolean; state: Json });
    if (method === 'event') this.#event(params as MachineEvent);
    if (method === 'dropped') this.droppedFor = (params as { reason?: string }).reason ?? '';
    this.#listeners.get(method)?.forEach((take) => take(params));
  }

  #patch({ full, state }: { full: boolean; state: Json }): void {
    const before = this.#status;
    const after = (full ? state : mergePatch(before as Json, state)) as Status;
    this.#status = after;
    this.#freshness.came(ageOf(after));
    if (after.machine !== before.machine) this.machine = after.machine ?? null;
    if (after.drives !== before.drives) this.drives = after.drives ?? null;
    if (after.channels === before.channels) return;
    const channels = Object.values(after.channels ?? {}).sort((a, b) => a.id - b.id);
    const old = this.channels;
    if (channels.some((one, i) => one.alarm?.code !== old[i]?.alarm?.code)) this.#askAlarms();
    this.channels = channels;
  }

  #event(event: MachineEvent): void {
    this.events = [event, ...this.events].slice(0, eventsKept);
    this.#askAlarms();
  }
}

function ageOf({ machine, channels = {} }: Status): number {
  return Math.max(machine?.age_ms ?? 0, ...Object.values(channels).map((one) => one.age_ms ?? 0));
}

function openSocket(): Socket {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  const machine = machineOf(location);
  const path = machine === '' ? '/ws' : `/ws/${encodeURIComponent(machine)}`;
  const socket = new WebSocket(`${scheme}://${location.host}${path}`);
  socket.binaryType = 'arraybuffer';
  socket.addEventListener('open', () => socket.send(keyMessage()));
  return socket as unknown as Socket;
}

export const store = new MachineStore();
