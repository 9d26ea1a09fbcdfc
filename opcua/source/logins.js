// Logins: who may come in with a name and a password, and how long who failed waits: for the answer,
// and with the next try of that name from that address. Other names and addresses wait for nothing.
import { isIPv6 } from 'node:net';
import { setTimeout as pause } from 'node:timers/promises';
import { is_password } from './users.js';

/**
 * @import { Users } from '../types/view.js'
 */

const first_delay_ms = 500;
const delay_max_ms = 16_000;
const forgotten_after_ms = 15 * 60_000;
const claimants_max = 4096;

/**
 * Of IPv6 the network part: each computer has many addresses there.
 * @param {string} address
 */
export function network_of(address) {
  const plain = address.replace(/^::ffff:(?=\d+\.)/i, '').replace(/%.*$/, '');
  if (!isIPv6(plain)) return plain;
  const [head, tail] = plain
    .split('::')
    .map((part) => part.split(':').filter((group) => group !== ''));
  const zeros = tail ? Array(Math.max(0, 8 - head.length - tail.length)).fill('0') : [];
  return [...head, ...zeros, ...(tail ?? [])].slice(0, 4).join(':') + '::';
}

export class Logins {
  /** @type {Map<string, { count: number; last: number; next_try: number }>} the newest failure last */
  #failures = new Map();
  /** @type {Set<string>} */
  #under_way = new Set();

  /**
   * @param {Users} users
   * @param {{ now: () => number; wait: (ms: number) => Promise<void>; log: (text: string) => void }} surroundings
   */
  constructor(
    users,
    surroundings = {
      now: Date.now,
      wait: (ms) => pause(ms, undefined, { ref: false }),
      log: (text) => console.error(text),
    },
  ) {
    this.users = users;
    this.surroundings = surroundings;
  }

  /**
   * @param {string} name
   * @param {string} password
   * @param {string} address
   * @returns {Promise<boolean>}
   */
  async is_admitted(name, password, address) {
    const { now, wait, log } = this.surroundings;
    // All names that nobody can have are one.
    const shown = /^[\w.@-]{1,64}$/.test(name) ? name : '?';
    const place = network_of(address);
    const claimant = `${shown} from ${place}`;
    const is_early = now() < (this.#failures.get(claimant)?.next_try ?? 0);
    if (is_early || this.#under_way.has(claimant)) return false;
    this.#under_way.add(claimant);
    let is_right = false;
    try {
      is_right = await is_password(this.users, name, password);
    } finally {
      this.#under_way.delete(claimant);
    }
    if (is_right) {
      this.#failures.delete(claimant);
      return true;
    }
    log(`a login as ${claimant} failed`);
    await wait(this.#note_failure(claimant, now()));
    return false;
  }

  /**
   * The delay, in ms.
   * @param {string} claimant
   * @param {number} now
   */
  #note_failure(claimant, now) {
    const before = this.#failures.get(claimant);
    const is_old = before === undefined || now - before.last > forgotten_after_ms;
    const count = is_old ? 0 : before.count;
    const delay = Math.min(first_delay_ms * 2 ** Math.min(count, 6), delay_max_ms);
    this.#failures.delete(claimant);
    this.#failures.set(claimant, { count: count + 1, last: now, next_try: now + delay });
    const [oldest] = this.#failures.keys();
    if (this.#failures.size > claimants_max) this.#failures.delete(oldest);
    return delay;
  }
}
