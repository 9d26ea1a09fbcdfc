// The way back along a held path and forward again, as long as a button is down.
import { JogLease, type RetraceMotion } from '../rpc/jog_lease';
import { Refusal } from '../rpc/json_rpc';
import { store } from './machine.svelte';
import { refusals } from './refusal.svelte';

/** Nothing is left in this direction: the axes are at the end of the way. */
const atEnd = 'E6102';

class Retracing {
  moving = $state.raw<RetraceMotion | null>(null);
  #place: Element | null = null;
  #lease = new JogLease<RetraceMotion>(
    {
      jog: (motion) => store.call('program.retrace', { ...motion }),
      hold: (channel) => store.call('program.hold', { channel }),
      mayGoOn: () => store.live && document.visibilityState === 'visible' && document.hasFocus(),
      refused: (error) => {
        if (!(error instanceof Refusal && error.data.code === atEnd))
          refusals.show(error, this.#place);
      },
      now: () => performance.now(),
    },
    (motion) => (this.moving = motion),
  );

  press(channel: number, direction: 'back' | 'forward', place: Element): void {
    this.#place = place;
    this.#lease.press({ channel, direction, seen_cycle: store.seenCycle });
  }

  release(): void {
    this.#lease.release();
  }
}

export const retracing = new Retracing();
