// Daemon: one stanokd as an observer sees it, over the socket of the operators; connects again
// whenever it went away.
//
// `on_view(view)` is called with everything that is known, at most `rate_hz` times a second, and
// with null once when the daemon is away. A view has `info` (system.info), `machine` and `channels`
// (machine.status, channel.status), `tools`, `alarms` and `runs` as the daemon answers them.
import { connect } from 'node:net';

const again_after_ms = 1000;
const silence_max_ms = 10_000; // a status has a new cycle at each period
const line_bytes_max = 16 * 2 ** 20;
const lists_period_max_ms = 10_000; // tables change without an event

/**
 * @import { Address, Lists, Method, Parameters, Result, View } from '../types/view.js'
 * @import { Socket } from 'node:net'
 * @typedef {{ resolve: (result: any) => void, reject: (reason: Error) => void }} Waiting
 * @typedef {{
 *   id?: number,
 *   method?: string,
 *   params?: any,
 *   result?: unknown,
 *   error?: { message: string },
 * }} Message
 */

/**
 * RFC 7396.
 * @param {any} target
 * @param {any} patch
 * @returns {any}
 */
export function merge_patch(target, patch) {
  if (patch === null || typeof patch !== 'object' || Array.isArray(patch)) return patch;
  const merged =
    target !== null && typeof target === 'object' && !Array.isArray(target) ? { ...target } : {};
  for (const [name, value] of Object.entries(patch)) {
    if (value === null) delete merged[name];
    else merged[name] = merge_patch(merged[name], value);
  }
  return merged;
}

/** @param {unknown} error */
function first_line(error) {
  return (error instanceof Error ? error.message : String(error)).split('\n')[0];
}

// A row of a history is new, or a run that has ended meanwhile.
/** @type {(keyof import('../types/view.js').Channel)[]} */
const followed_members = ['run', 'state', 'program_status', 'alarm', 'program'];

export class Daemon {
  /** @type {Socket | undefined} */
  socket;
  /** @type {NodeJS.Timeout | undefined} */
  again;
  /** @type {Map<number, Waiting>} */
  answers = new Map();
  /** @type {any} status as it is told: {machine, channels}; null: none yet */
  state = null;
  /** @type {Lists | null} */
  lists = null;
  /** @type {Result<'system.info'> | undefined} */
  info;
  text = '';
  last_id = 0;
  reason = '';
  told = '';
  followed = '';
  stopped = false;
  are_lists_old = false;
  lists_read_ms = 0;

  /**
   * @param {Address} address
   * @param {number} rate_hz
   * @param {(view: View | null) => void} on_view
   */
  constructor({ name, socket }, rate_hz, on_view) {
    this.name = name;
    this.path = socket;
    this.rate_hz = rate_hz;
    this.on_view = on_view;
  }

  start() {
    this.#connect();
  }

  stop() {
    this.stopped = true;
    clearTimeout(this.again);
    this.socket?.destroy();
  }

  #connect() {
    this.text = '';
    this.answers = new Map();
    this.last_id = 0;
    this.state = null;
    this.lists = null;
    this.reason = 'the connection was closed';
    const socket = connect(this.path);
    this.socket = socket;
    socket.setEncoding('utf8');
    socket.setTimeout(silence_max_ms, () => this.#end('the daemon does not send anything'));
    socket.on('data', (/** @type {string} */ text) => this.#take(text));
    socket.on('error', (error) => (this.reason = error.message));
    socket.on('close', () => this.#closed());
  }

  /** @param {string} reason */
  #end(reason) {
    this.reason = reason;
    this.socket?.destroy();
  }

  #closed() {
    for (const { reject } of this.answers.values()) reject(new Error(this.reason));
    if (this.stopped) return; // who shows views may be gone
    try {
      this.on_view(null);
    } catch (error) {
      this.reason = `cannot show that the daemon is away: ${first_line(error)}`;
    }
    if (this.stopped) return;
    if (this.reason !== this.told) console.error(`${this.name}: ${this.reason}; trying again`);
    this.told = this.reason;
    this.again = setTimeout(() => this.#connect(), again_after_ms);
  }

  /** @param {string} text */
  #take(text) {
    const lines = (this.text + text).split('\n');
    this.text = lines.pop() ?? '';
    if (this.text.length > line_bytes_max)
      return this.#end('the daemon sent a message that is too long');
    for (const line of lines) {
      try {
        this.#take_message(JSON.parse(line));
      } catch (error) {
        return this.#end(`cannot show a message of the daemon: ${first_line(error)}`);
      }
    }
  }

  /** @param {Message} message */
  #take_message({ id, method, params, result, error }) {
    if (method === 'hello') return this.#guarded(this.#greet());
    if (method === 'status') return this.#take_status(params);
    if (method === 'event') return void (this.are_lists_old = true);
    if (method === 'dropped')
      return this.#end(params?.reason ?? params?.message ?? 'the daemon has no free connection');
    if (id === undefined) return;
    const waits = this.answers.get(id);
    this.answers.delete(id);
    if (error) waits?.reject(new Error(error.message));
    else waits?.resolve(result);
  }

  /** @param {Promise<void>} promise */
  #guarded(promise) {
    promise.catch((error) => this.#end(error.message));
  }

  /**
   * @template {Method} Name
   * @param {Name} method
   * @param {Parameters<Name> | {}} params
   * @returns {Promise<Result<Name>>}
   */
  #ask(method, params = {}) {
    const id = ++this.last_id;
    this.socket?.write(JSON.stringify({ jsonrpc: '2.0', id, method, params }) + '\n');
    return new Promise((resolve, reject) => this.answers.set(id, { resolve, reject }));
  }

  async #greet() {
    await this.#ask('session.role', { role: 'observer', name: 'stanok-opcua' });
    this.info = await this.#ask('system.info');
    await this.#read_lists();
    await this.#ask('subscribe', {
      topics: ['machine', 'channels', 'events'],
      rate_hz: this.rate_hz,
    });
    console.error(`${this.name}: connected to ${this.path}`);
    this.told = '';
  }

  async #read_lists() {
    this.are_lists_old = false;
    this.lists_read_ms = Date.now();
    const [tools, alarms, runs] = await Promise.all([
      this.#ask('tool.list'),
      this.#ask('alarm.list'),
      this.#ask('program.history'),
    ]);
    this.lists = { tools: tools.tools, alarms: alarms.alarms, runs: runs.runs };
    this.#tell();
  }

  /** @param {{ full?: boolean, state: any }} status */
  #take_status({ full, state }) {
    this.state = merge_patch(full ? {} : this.state, state);
    const followed = JSON.stringify(
      Object.values(this.state.channels ?? {}).map((/** @type {any} */ one) =>
        followed_members.map((name) => one[name]),
      ),
    );
    if (followed !== this.followed) this.are_lists_old = true;
    this.followed = followed;
    const age_ms = Date.now() - this.lists_read_ms;
    if (this.are_lists_old || age_ms > lists_period_max_ms) this.#guarded(this.#read_lists());
    this.#tell();
  }

  #tell() {
    const { info, lists, state } = this;
    if (!state?.machine || !state.channels || !lists || !info) return;
    /** @type {View['channels']} */
    const channels = Object.values(state.channels);
    channels.sort((a, b) => a.id - b.id);
    this.on_view({ info, machine: state.machine, channels, ...lists });
  }
}
