// Continuous jogging, and the way back along a path: a lease of 200 ms that is renewed only while the key or button is down.
//
// The daemon stops the axis by itself when no renewal comes. Renewals go out by the clock and do not wait
// for the way there and back, so that an axis goes on behind a slow connection, too. What keeps it from
// moving late or unasked:
//   - when as many as fit into the lease and one more are unanswered, it ends: no more than these wait in
//     a connection that hangs, and the hold waits behind them;
//   - a page that was asleep for longer than the lease does not go on: the key must be pressed anew;
//   - one refusal ends it.
// When it ends, the channel is held: the axis stops at once and not when the lease is over. Whoever
// presses is told why it ended, unless it was let go.
import { noData, ownNumbers, Refusal } from './json_rpc';

/** What moves as long as it is asked for again. */
export interface LeasedMotion {
  channel: number;
  /** The newest cycle of the machine that was seen when it was pressed. */
  seen_cycle?: number;
}

export interface JogMotion extends LeasedMotion {
  axis: string;
  /** mm/s or deg/s; the sign is the direction. */
  velocity: number;
  /** Whose directions: left out, an axis of the machine; else `axis` is X, Y or Z. */
  frame?: 'tool' | 'plane';
}

export interface RetraceMotion extends LeasedMotion {
  direction: 'back' | 'forward';
}

export interface JogPort<Motion extends LeasedMotion = JogMotion> {
  jog(motion: Motion): Promise<unknown>;
  hold(channel: number): Promise<unknown>;
  /** Connection live, page visible and in focus. */
  mayGoOn(): boolean;
  refused(error: unknown): void;
  now(): number;
}

export const renewal_ms = 80;
export const lease_ms = 200;
export const unansweredAtMost = Math.floor(lease_ms / renewal_ms) + 1;

/** Of one press: its renewals are numbered as they are sent, and answered in that order. */
interface Press {
  sent: number;
  answered: number;
  isTold: boolean;
  isReleased: boolean;
}

/** A stop that was given later came before it. */
const overtakenByStop = 'E6072';

export class JogLease<Motion extends LeasedMotion = JogMotion> {
  #motion: Motion | null = null;
  #press: Press = { sent: 0, answered: 0, isTold: false, isReleased: false };
  #timer: ReturnType<typeof setInterval> | null = null;
  #sentAt = 0;

  constructor(
    private readonly port: JogPort<Motion>,
    private readonly changed: (motion: Motion | null) => void = () => undefined,
  ) {}

  get motion(): Motion | null {
    return this.#motion;
  }

  press(motion: Motion): void {
    this.release();
    if (!this.port.mayGoOn()) return;
    this.#motion = motion;
    this.#press = { sent: 0, answered: 0, isTold: false, isReleased: false };
    this.changed(motion);
    this.#send();
    this.#timer = setInterval(() => this.#renew(), renewal_ms);
  }

  release(): void {
    const motion = this.#end();
    this.#press.isReleased = true;
    if (motion !== null) this.port.hold(motion.channel).catch(() => undefined);
  }

  #end(): Motion | null {
    const motion = this.#motion;
    if (this.#timer !== null) clearInterval(this.#timer);
    this.#timer = null;
    this.#motion = null;
    if (motion !== null) this.changed(null);
    return motion;
  }

  #renew(): void {
    if (!this.port.mayGoOn()) return this.release();
    const { sent, answered } = this.#press;
    const isAsleep = this.port.now() - this.#sentAt > lease_ms;
    if (!isAsleep && sent - answered < unansweredAtMost) return this.#send();
    this.release();
    this.#tell(this.#press, new Refusal(ownNumbers.jogLate, '', noData));
  }

  #send(): void {
    const motion = this.#motion;
    if (motion === null) return;
    const press = this.#press;
    const number = ++press.sent;
    this.#sentAt = this.port.now();
    this.port.jog(motion).then(
      () => (press.answered = Math.max(press.answered, number)),
      (error: unknown) => {
        if (press === this.#press) this.#end();
        this.#tell(press, error);
      },
    );
  }

  // Also when it has been let go meanwhile: a short press may be over before its refusal comes.
  #tell(press: Press, error: unknown): void {
    const isOwnStop =
      press.isReleased && error instanceof Refusal && error.data.code === overtakenByStop;
    if (press.isTold || isOwnStop) return;
    press.isTold = true;
    this.port.refused(error);
  }
}
