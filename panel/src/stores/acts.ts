// What the page asks of the machine from more than one place.
import { t } from '../text/text';
import { duration } from './format';
import type { GlanceChannel } from './cell.svelte';
import { store, type Channel } from './machine.svelte';

/** Feed hold of every channel, asked for at once; the first refusal is thrown when all were sent. */
export async function holdAll(): Promise<void> {
  const channels = store.hello?.channels ?? store.channels;
  const asked = channels.map((channel) => store.call('program.hold', { channel: channel.id }));
  if (asked.length === 0) await store.call('program.hold');
  await Promise.all(asked);
}

/** Every channel that is held goes on; the first refusal is thrown when all were asked for. */
export async function resumeAll(): Promise<void> {
  const held = store.channels.filter(
    (channel) => channel.state === 'Interrupted' && channel.alarm == null,
  );
  await Promise.all(held.map(({ id }) => store.call('program.resume', { channel: id })));
}

/** Every one of these channels is reset; the first refusal is thrown when all were asked for. */
export async function resetAll(channels: readonly number[]): Promise<void> {
  await Promise.all(channels.map((channel) => store.call('program.reset', { channel })));
}

const stopAllCode = 'A1001';

/** What an alarm says. That of STOP ALL has the words of the button: it is not that of the emergency stop. */
export const textOf = ({ code, text }: { code: string; text: string }): string =>
  code === stopAllCode ? t('alarm.stop_all') : text;

/** By software, not the E-stop: along the path to rest, then the drives off. */
export const stopAll = (): Promise<unknown> => store.call('machine.estop');

export type StateKind =
  'running' | 'waiting' | 'standing' | 'held' | 'alarm' | 'ready' | 'idle' | 'off';

/** What the motion of a channel is judged by; not all who show a channel have it. */
type Motion = Partial<Pick<Channel, 'override' | 'speed_mm_s' | 'g_codes' | 'words'>>;

/** Which override lets nothing move; null: none does, or something moves all the same. */
export function stoppingOverride(channel: Motion): 'feed' | 'rapid' | null {
  const { override, speed_mm_s: speed, g_codes: codes = [], words = [] } = channel;
  if (override === undefined || speed !== 0 || words.length === 0) return null;
  const of = codes.includes('G0') ? 'rapid' : 'feed';
  return override[of] === 0 ? of : null;
}

/** Which override may be why nothing has moved for a while: behind a rapid move, that of the feed move that follows. */
export function overrideAtZero({ override }: Motion): 'feed' | 'rapid' | null {
  if (override?.feed === 0) return 'feed';
  return override?.rapid === 0 ? 'rapid' : null;
}

/** In words, why a channel stands in the middle of its program. */
export function whyStands(channel: Motion): string {
  const stopping = stoppingOverride(channel) ?? overrideAtZero(channel);
  return stopping === null ? t('stands.unknown') : t(`stands.${stopping}`);
}

/** In one word what a channel is doing: running is what moves, not what a program is loaded for. */
export function stateOf(channel: GlanceChannel & Motion, on: boolean): StateKind {
  if (channel.alarm != null) return 'alarm';
  if (channel.state === 'Interrupted') return 'held';
  if (channel.program_status === 'Waiting') return 'waiting';
  if (channel.state === 'Active')
    return stoppingOverride(channel) === null ? 'running' : 'standing';
  if (!on) return 'off';
  return channel.program != null ? 'ready' : 'idle';
}

/** Whether a program is under way. */
export const isUnderWay = (state: StateKind): boolean =>
  ['running', 'waiting', 'standing', 'held'].includes(state);

export const kindOfMark = {
  running: 'running',
  standing: 'attention',
  waiting: 'running',
  held: 'attention',
  alarm: 'alarm',
  ready: 'ready',
  idle: 'idle',
  off: 'off',
} satisfies Record<StateKind, string>;

/** How long the run still takes. The prediction is for overrides of 100 %. */
export function timeLeft({ remaining_s, override }: GlanceChannel & Motion): string {
  const { feed = 100, rapid = 100 } = override ?? {};
  const time = duration(remaining_s ?? 0);
  return t(feed === 100 && rapid === 100 ? 'channel.left' : 'channel.left_full', { time });
}

/** How much of the run is over by the predicted time, 0 to 1; null without a prediction. */
export function progressOf(channel: GlanceChannel): number | null {
  const { predicted_s: predicted, remaining_s: remaining } = channel;
  if (predicted == null || remaining == null || predicted <= 0) return null;
  return Math.min(1, Math.max(0, 1 - remaining / predicted));
}

/** The file in which the line of a channel stands: its program, or what that calls; null: none. */
export const fileOf = ({ file, program }: Pick<Channel, 'file' | 'program'>): string | null =>
  file ?? program ?? null;

/** Where a channel is, behind the name of its program: with the file where that is another one. */
export function placeOf(channel: Pick<Channel, 'file' | 'program' | 'line'>): string {
  const { file, program, line = 0 } = channel;
  return file != null && file !== program ? `${file}:${line}` : t('channel.line', { line });
}
