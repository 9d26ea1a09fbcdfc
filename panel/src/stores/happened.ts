// When something happened, and how a run ended. Daemons that do not say so are shown as far as they do.
import type { Result } from '../rpc/json_rpc';
import type { TextKey } from '../text/catalogue';
import { t } from '../text/text';
import { dateAndTime, duration, fixed } from './format';
import { store } from './machine.svelte';

const ends: Record<string, TextKey> = {
  done: 'history.ok',
  stopped: 'end.stopped',
  reset: 'end.reset',
  estop: 'stop_all',
  alarm: 'end.alarm',
  cut_off: 'end.cut_off',
  off: 'end.off',
};

export type Run = Result<'program.history'>['runs'][number] & {
  /** Unix time in s; null: the daemon does not know it. */
  begun_at?: number | null;
  ended_at?: number | null;
  end?: string | null;
};

/** By the clock on the wall; without it the time since the daemon started, by its cycles. */
export function whenOf(at_s: number | null | undefined, cycle: number | null): string {
  if (at_s != null) return dateAndTime(at_s);
  return cycle === null ? '–' : duration((cycle * (store.machine?.cycle_us ?? 1000)) / 1e6);
}

/** Periods of the clock without a cycle during a run, with the longest gap where there was one. */
export function lostPeriodsOf({ ended, lost_periods, longest_gap_ms }: Run): string {
  if (!ended || lost_periods === undefined) return '–';
  return lost_periods === 0 ? '0' : `${lost_periods} (${fixed(longest_gap_ms, 0)} ${t('unit.ms')})`;
}

/** In words, how a run ended, or that it has not. */
export function endOf({ end, ended, ok }: Run): string {
  const known = ends[end ?? ''];
  if (known !== undefined) return t(known);
  if (!ended) return t('state.running');
  return t(ok ? 'history.ok' : 'history.failed');
}
