// Words of stanok as those of OPC 40501-1 and 40001-1: pure functions of a view (daemon.js).

/**
 * @import { Axis, Channel, Parts, Run, Spindle, View } from '../types/view.js'
 */

// OPC 40501-1 ChannelState, ChannelMode and MachineOperationMode.
/** @type {Record<string, number>} */
export const ChannelState = { Active: 0, Interrupted: 1, Reset: 2 };
export const ChannelMode = { Automatic: 0, MdaMdi: 1, JogManual: 2 };
export const OperationMode = { Manual: 0, Automatic: 1 };

/**
 * stanok has no switch of modes: the mode is that of what the channel does, or would do at a start.
 * @param {Channel} channel
 */
export function channel_mode(channel) {
  if (channel.program === 'MDI') return ChannelMode.MdaMdi;
  return channel.program ? ChannelMode.Automatic : ChannelMode.JogManual;
}

/** @param {View} view */
export function operation_mode(view) {
  const is_automatic = view.channels.some((one) => channel_mode(one) === ChannelMode.Automatic);
  return is_automatic ? OperationMode.Automatic : OperationMode.Manual;
}

/**
 * OPC 40001-1, MachineryItemState.
 * @param {View} view
 */
export function item_state(view) {
  if (view.channels.some((one) => one.program_status === 'Canceled')) return 'OutOfService';
  if (!view.machine.on) return 'NotAvailable';
  const is_active = view.channels.some((one) => one.state === 'Active');
  return is_active ? 'Executing' : 'NotExecuting';
}

/**
 * OPC 40001-1, MachineryOperationMode: programs are Processing, movement by hand is Setup.
 * @param {View} view
 */
export function machinery_mode(view) {
  const active = view.channels.filter((one) => one.state !== 'Reset');
  if (active.length === 0) return 'None';
  const is_program = active.some((one) => channel_mode(one) === ChannelMode.Automatic);
  return is_program ? 'Processing' : 'Setup';
}

/**
 * The run of a channel that is under way or was last, a row of program.history; null: none yet.
 * @param {View} view
 * @param {Channel} channel
 * @returns {Run | null}
 */
export function newest_run(view, channel) {
  return view.runs.filter((run) => run.channel === channel.id).at(-1) ?? null;
}

/**
 * OPC 40501-1, states of a ProductionProgram.
 * @param {View} view
 * @param {Channel} channel
 */
export function program_state(view, channel) {
  if (channel.program_status === 'Canceled') return 'Aborted';
  if (channel.state === 'Active') return 'Running';
  if (channel.state === 'Interrupted') return 'Interrupted';
  const run = newest_run(view, channel);
  // A program that was loaded after the last run has not begun.
  if (!run || run.program !== channel.program) return 'Initializing';
  return run.ok ? 'Ended' : 'Aborted';
}

/**
 * The channel whose program is the active one: the first that runs, else the first that has one.
 * @param {View} view
 * @returns {Channel | undefined}
 */
export function leading_channel(view) {
  const active = view.channels.find((one) => one.state !== 'Reset' && one.program);
  return active ?? view.channels.find((one) => one.program) ?? view.channels[0];
}

/**
 * Runs of the program of a channel that ended well since the daemon started.
 * @param {View} view
 * @param {Channel} channel
 */
export function runs_completed(view, channel) {
  return view.runs.filter(
    (run) => run.channel === channel.id && run.program === channel.program && run.ended && run.ok,
  ).length;
}

/**
 * An axis as the channel sees it in which it takes part; null: of no channel.
 * @param {View} view
 * @param {string} name
 * @returns {Axis | null}
 */
export function axis_in(view, name) {
  const seen = view.channels.flatMap((one) => one.axes[name] ?? []);
  return seen.find((axis) => axis.takes_part) ?? seen[0] ?? null;
}

/**
 * A spindle as the channel sees it that turns it.
 * @param {View} view
 * @param {number} id
 * @returns {Spindle | null}
 */
export function spindle_in(view, id) {
  const seen = view.channels.flatMap((one) => one.spindles).filter((one) => one.id === id);
  return seen.find((one) => one.commanded_rev_min !== 0) ?? seen[0] ?? null;
}

/** @param {Spindle} spindle */
export function is_rotating(spindle) {
  return (spindle.actual_rev_min ?? spindle.commanded_rev_min) !== 0;
}

/**
 * What the machine is made of; it has other nodes when this changes.
 * @param {View} view
 * @returns {Parts}
 */
export function parts_of(view) {
  const axes = new Set(view.channels.flatMap((one) => Object.keys(one.axes)));
  const spindles = new Set(view.channels.flatMap((one) => one.spindles).map((one) => one.id));
  return {
    channels: view.channels.map(({ id, name, words }) => ({ id, name, words })),
    axes: [...axes],
    spindles: [...spindles].sort((a, b) => a - b),
  };
}
