// Continuous jogging: a lease of 200 ms that is renewed only while the key or button is down.
//
// The daemon stops the axis by itself when no renewal comes. What is added here keeps an axis from
// moving late or unasked:
//   - a renewal is sent only when the one before was answered: nothing piles up in a connection that
//     hangs and moves the axis when it comes alive again;
//   - a page that was asleep for longer than the lease does not go on: the key must be pressed anew;
//   - one refusal ends it.
// When it ends, the channel is held: the axis stops at once and not when the lease is over.

export interface JogMotion {
  channel: number;
  axis: string;
  /** mm/s or deg/s; the sign is the direction. */
  velocity: number;
  /** Whose directions: left out, an axis of the machine; else `axis` is X, Y or Z. */
  frame?: 'tool' | 'plane';
}

export interface JogPort {
  jog(motion: JogMotion): Promise<unknown>;
  hold(channel: number): Promise<unknown>;
  /** Connection live, page visible and in focus. */
  mayGoOn(): boolean;
  refused(error: unknown): void;
  now(): number;
}

export const renewal_ms = 80;
export const lease_ms = 200;

export class JogLease {
  #motion: JogMotion | null = null;
  #press = 0;
  #timer: ReturnType<typeof setInterval> | null = null;
  #unanswered = false;
  #sentAt = 0;

  constructor(
    private readonly port: JogPort,
    private readonly changed: (motion: JogMotion | null) => void = () => undefined,
  ) {}

  get motion(): JogMotion | null {
    return this.#motion;
  }

  press(motion: JogMotion): void {
    this.release();
    if (!this.port.mayGoOn()) return;
    this.#motion = motion;
    this.#press += 1;
    this.#unanswered = false;
    this.changed(motion);
    this.#send();
    this.#timer = setInterval(() => this.#renew(), renewal_ms);
  }

  release(): void {
    const motion = this.#end();
    if (motion !== null) this.port.hold(motion.channel).catch(() => undefined);
  }

  #end(): JogMotion | null {
    const motion = this.#motion;
    if (this.#timer !== null) clearInterval(this.#timer);
    this.#timer = null;
    this.#motion = null;
    if (motion !== null) this.changed(null);
    return motion;
  }

  #renew(): void {
    const late = this.port.now() - this.#sentAt > lease_ms;
    if (late || !this.port.mayGoOn()) this.release();
    else if (!this.#unanswered) this.#send();
  }

  #send(): void {
    const motion = this.#motion;
    if (motion === null) return;
    const press = this.#press;
    this.#unanswered = true;
    this.#sentAt = this.port.now();
    this.port.jog(motion).then(
      () => {
        if (press === this.#press) this.#unanswered = false;
      },
      (error: unknown) => {
        if (press !== this.#press || this.#motion === null) return;
        this.#end();
        this.port.refused(error);
      },
    );
  }
}
