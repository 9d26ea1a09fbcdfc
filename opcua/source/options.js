// What the command line says, and what is refused.
import { isIP } from 'node:net';
import { homedir } from 'node:os';
import { basename, extname, join } from 'node:path';
import { parseArgs } from 'node:util';

/**
 * @import { Address, Wanted } from '../types/view.js'
 */

/** The command line is wrong; the message says what to write instead. */
export class Usage extends Error {}

export const usage = `stanok-opcua: serves machines of this computer by OPC UA for Machine Tools (OPC 40501-1)

usage: stanok-opcua --daemon NAME=SOCKET ... [OPTION ...]

  --daemon NAME=SOCKET  socket of a daemon and the name of its machine; may be repeated
  --host ADDRESS        IP address to listen on; default 127.0.0.1. On any address other than loopback
                        all messages are signed, and only the users of --users can log in
  --port PORT           TCP port; default 4840. 0: any free port
  --users FILE          file of the users: the lines that --add-user prints
  --add-user NAME       print the line of a user; the password is the first line of standard input
  --identity FILE       JSON file: manufacturer, serial number and similar data of each machine
  --rate HZ             rate at which states are read, 0.1 to 10; default 2
  --sessions NUMBER     maximum number of sessions, 1 to 100; default 20
  --state FOLDER        folder of the certificates; default: $STATE_DIRECTORY
  --version             print the version and exit
  -h, --help            print help and exit
`;

/** @satisfies {import('node:util').ParseArgsConfig['options']} */
const words_of = /** @type {const} */ ({
  daemon: { type: 'string', multiple: true },
  host: { type: 'string', default: '127.0.0.1' },
  port: { type: 'string', default: '4840' },
  users: { type: 'string' },
  'add-user': { type: 'string' },
  identity: { type: 'string' },
  rate: { type: 'string', default: '2' },
  sessions: { type: 'string', default: '20' },
  state: { type: 'string' },
  version: { type: 'boolean' },
  help: { type: 'boolean', short: 'h' },
});

/** @param {string[]} words */
function parsed(words) {
  try {
    return parseArgs({ args: words, options: words_of }).values;
  } catch (error) {
    throw new Usage(error instanceof Error ? error.message : String(error));
  }
}

/**
 * @param {string} name
 * @param {string} text
 * @param {number} smallest
 * @param {number} largest
 * @param {boolean} is_whole
 */
function number_in(name, text, smallest, largest, is_whole) {
  const number = Number(text);
  const is_good = text.trim() !== '' && number >= smallest && number <= largest;
  if (is_good && (!is_whole || Number.isInteger(number))) return number;
  throw new Usage(
    `--${name} needs a ${is_whole ? 'whole ' : ''}number from ${smallest} to ${largest}`,
  );
}

/**
 * @param {string} text
 * @returns {Address}
 */
function machine_from(text) {
  const sign = text.indexOf('=');
  const socket = text.slice(sign + 1);
  const name = sign < 0 ? basename(socket, extname(socket)) : text.slice(0, sign);
  if (/^[\w.]+$/.test(name) && socket) return { name, socket };
  throw new Usage(
    `--daemon ${text}: a machine needs a name of letters, digits, _ and .: --daemon NAME=SOCKET`,
  );
}

function default_state_folder() {
  if (process.env.STATE_DIRECTORY) return process.env.STATE_DIRECTORY.split(':')[0];
  const base = process.env.XDG_STATE_HOME || join(homedir(), '.local', 'state');
  return join(base, 'stanok', 'opcua');
}

/** @param {string} host */
export function is_loopback(host) {
  return host === '::1' || host.startsWith('127.');
}

/**
 * Throws Usage.
 * @param {string[]} words
 * @returns {Wanted}
 */
export function options_from(words) {
  const given = parsed(words);
  if (given.help) return { kind: 'help' };
  if (given.version) return { kind: 'version' };
  if (given['add-user'] !== undefined) return { kind: 'user', name: given['add-user'] };
  const machines = (given.daemon ?? []).map(machine_from);
  if (machines.length === 0)
    throw new Usage('no machine: name the socket of a daemon with --daemon NAME=SOCKET');
  const twice = machines.find(({ name }, k) => machines.findIndex((one) => one.name === name) < k);
  if (twice) throw new Usage(`two machines have the name ${twice.name}: --daemon NAME=SOCKET`);
  if (!isIP(given.host))
    throw new Usage('--host needs an IP address of this computer, such as 127.0.0.1');
  if (!is_loopback(given.host) && !given.users)
    throw new Usage('--host is not a loopback address, so users are required: add --users FILE');
  const options = {
    machines,
    host: given.host,
    port: number_in('port', given.port, 0, 65535, true),
    users: given.users,
    identity: given.identity,
    rate_hz: number_in('rate', given.rate, 0.1, 10, false),
    sessions: number_in('sessions', given.sessions, 1, 100, true),
    state: given.state ?? default_state_folder(),
  };
  return { kind: 'server', options };
}
