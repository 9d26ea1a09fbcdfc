// Jogging as the page does it: armed by a person, one axis at a time, by buttons or arrow keys.
import { JogLease, type JogMotion } from '../rpc/jog_lease';
import { store } from './machine.svelte';
import { refusals } from './refusal.svelte';

export const steps = ['hold', '10', '1', '0.1', '0.01', '0.001'] as const;
export type Step = (typeof steps)[number];
export const frames = ['machine', 'tool', 'plane'] as const;
export type Frame = (typeof frames)[number];

// Which key moves which axis word, and in which direction.
const keys: Record<string, [word: string, direction: 1 | -1]> = {
  ArrowLeft: ['X', -1],
  ArrowRight: ['X', 1],
  ArrowDown: ['Y', -1],
  ArrowUp: ['Y', 1],
  PageDown: ['Z', -1],
  PageUp: ['Z', 1],
};

class Jogging {
  armed = $state(false);
  step = $state<Step>('hold');
  /** mm/s of linear axes; rotary axes turn with as many degrees a second. */
  velocity = $state(10);
  /** Whose directions; each arming begins with the axes of the machine. */
  frame = $state<Frame>('machine');
  moving = $state.raw<JogMotion | null>(null);
  /** The refusals of jogging are shown here. */
  place: Element | null = null;

  // The place of the key that is down, not what it writes: that changes with Shift and Num Lock.
  #key: string | null = null;
  // The channel of the last step, which goes on when the key or button is let go.
  #stepped: number | null = null;
  #lease = new JogLease(
    {
      jog: (motion) => store.call('jog', { ...motion }),
      hold: (channel) => store.call('program.hold', { channel }),
      mayGoOn: () =>
        this.armed && store.live && document.visibilityState === 'visible' && document.hasFocus(),
      refused: (error) => refusals.show(error, this.place),
      now: () => performance.now(),
    },
    (motion) => (this.moving = motion),
  );

  /** What can be moved, word and name: the axes of the chosen channel that take part, or directions. */
  axes(): { word: string; name: string }[] {
    if (this.frame !== 'machine') return ['X', 'Y', 'Z'].map((word) => ({ word, name: word }));
    const { words = [], axis_names: names = [], axes = {} } = store.channel ?? {};
    return words
      .map((word, i) => ({ word, name: names[i] ?? word }))
      .filter(({ name }) => axes[name]?.takes_part === true);
  }

  press(axis: string, direction: 1 | -1, place: Element | null): void {
    if (!this.armed) return;
    this.place = place;
    const velocity = this.velocity * direction;
    const frame = this.frame === 'machine' ? {} : { frame: this.frame };
    // Renewals say what was seen when the key went down: behind the end of their jog they begin none.
    const seen_cycle = store.seenCycle;
    const motion = { channel: store.chosen, axis, velocity, seen_cycle, ...frame };
    if (this.step === 'hold') this.#lease.press(motion);
    else this.#increment(motion, Number(this.step));
  }

  /** The wheel over the button of an axis is a handwheel: one notch is one step. */
  turn(axis: string, notches: number, place: Element | null): void {
    if (!this.armed || this.step === 'hold' || this.frame !== 'machine' || notches === 0) return;
    this.place = place;
    const way = notches * Number(this.step);
    store.call('handwheel', { channel: store.chosen, axis, way }).catch((error: unknown) => {
      refusals.show(error, this.place);
    });
  }

  release(): void {
    this.#key = null;
    this.#lease.release();
  }

  disarm(): void {
    this.release();
    this.#endStep();
    this.armed = false;
    this.frame = 'machine';
  }

  /** True when the key is one of jogging and jogging is armed. */
  keyDown(event: KeyboardEvent): boolean {
    const [word, direction] = keys[event.key] ?? [];
    if (!this.armed || word === undefined || direction === undefined) return false;
    if (event.repeat || this.#key !== null) return true;
    this.#key = event.code;
    this.pressWord(word, direction);
    return true;
  }

  /** A key or a pendant: refusals are shown at the button that does the same. */
  pressWord(word: string, direction: 1 | -1): void {
    const axis = this.axes().find((one) => one.word === word);
    if (axis === undefined) return;
    this.press(axis.name, direction, document.querySelector(`[data-jog="${word}${direction}"]`));
  }

  keyUp(event: KeyboardEvent): void {
    if (event.code === this.#key) this.release();
  }

  // A step of ten millimetres may take long. What a program moves by now is not jogging's to hold.
  #endStep(): void {
    const channel = this.#stepped;
    this.#stepped = null;
    const status = store.channels.find((one) => one.id === channel)?.program_status;
    if (channel === null || status === 'Running' || status === 'Waiting') return;
    store.call('program.hold', { channel }).catch(() => undefined);
  }

  #increment(motion: JogMotion, increment: number): void {
    this.#stepped = motion.channel;
    store.call('jog', { ...motion, increment }).catch((error: unknown) => {
      refusals.show(error, this.place);
    });
  }
}

export const jogging = new Jogging();
