// Daemon: what comes over the socket becomes views; what cannot be shown ends a connection, not the server.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { Daemon, merge_patch } from '../source/daemon.js';

/** @import { Socket } from 'node:net' */
/** @import { View } from '../types/view.js' */

const folder = mkdtempSync(join(tmpdir(), 'stanok-opcua-'));
after(() => rmSync(folder, { recursive: true }));
console.error = () => {};

const answers = {
  'session.role': { role: 'observer' },
  'system.info': { server: 'stanok', version: '1' },
  'tool.list': { tools: [] },
  'alarm.list': { alarms: [] },
  'program.history': { runs: [] },
  subscribe: {},
};

/** @param {Socket} socket @param {object} message */
const say = (socket, message) => socket.write(JSON.stringify(message) + '\n');

/**
 * What a daemon says, with these states behind the answer to `subscribe`.
 * @param {Socket} socket
 * @param {object[]} states
 */
function converse(socket, states) {
  say(socket, { method: 'hello', params: {} });
  socket.on('data', (lines) => {
    for (const line of lines.toString().split('\n').filter(Boolean)) {
      const { id, method } = JSON.parse(line);
      const known = /** @type {Record<string, object>} */ (answers);
      say(socket, { id, result: known[method] });
      if (method === 'subscribe') for (const state of states) say(socket, state);
    }
  });
}

/**
 * A socket; `talk` is called with each connection and its number from 0.
 * @param {string} name
 * @param {(socket: Socket, number: number) => void} talk
 */
async function listening(name, talk) {
  let count = 0;
  const path = join(folder, name);
  const server = createServer((socket) => {
    socket.on('error', () => {});
    talk(socket, count++);
  });
  server.listen(path);
  await once(server, 'listening');
  after(() => server.close());
  return path;
}

/**
 * The first view for which the condition holds.
 * @param {string} path
 * @param {(view: View | null) => boolean | undefined} condition
 * @returns {Promise<View | null>}
 */
function first_view(path, condition) {
  return new Promise((resolve) => {
    const daemon = new Daemon({ name: 'mill', socket: path }, 10, (view) => {
      if (!condition(view)) return;
      daemon.stop();
      resolve(view);
    });
    daemon.start();
  });
}

test('states are merged into views of all channels', async () => {
  const channels = { 2: { id: 2, program: 'b.nc' }, 1: { id: 1, program: null } };
  const path = await listening('merged.sock', (socket) =>
    converse(socket, [
      { method: 'status', params: { full: true, state: { machine: { on: false }, channels } } },
      {
        method: 'status',
        params: { state: { machine: { on: true }, channels: { 1: { program: 'a.nc' } } } },
      },
    ]),
  );
  const view = await first_view(path, (one) => one?.machine.on);
  assert.deepEqual(
    view?.channels.map(({ id, program }) => [id, program]),
    [
      [1, 'a.nc'],
      [2, 'b.nc'],
    ],
  );
  assert.equal(view?.info.server, 'stanok');
});

for (const [k, nonsense] of ['null\n', 'SSH-2.0\r\n', '[1]\n{"method":"status"}\n'].entries())
  test(`behind ${JSON.stringify(nonsense)} there is another connection`, async () => {
    const state = { machine: { on: true }, channels: { 1: { id: 1 } } };
    const path = await listening(`nonsense${k}.sock`, (socket, number) =>
      number === 0
        ? socket.write(nonsense)
        : converse(socket, [{ method: 'status', params: { full: true, state } }]),
    );
    const view = await first_view(path, (one) => one !== null);
    assert.equal(view?.machine.on, true);
  });

test('what cannot be shown ends no server, also when a daemon goes', async () => {
  let shown = 0;
  await new Promise((resolve) => {
    const daemon = new Daemon({ name: 'mill', socket: join(folder, 'none.sock') }, 10, () => {
      if (++shown === 2) {
        daemon.stop();
        resolve(undefined);
      }
      throw new Error('a node of the address space refuses its value');
    });
    daemon.start();
  });
  assert.equal(shown, 2);
});

// RFC 7396, appendix A.
for (const [target, patch, wanted] of [
  [{ a: 'b' }, { a: 'c' }, { a: 'c' }],
  [{ a: 'b' }, { b: 'c' }, { a: 'b', b: 'c' }],
  [{ a: 'b' }, { a: null }, {}],
  [{ a: ['b'] }, { a: 'c' }, { a: 'c' }],
  [{ a: { b: 'c' } }, { a: { b: 'd', c: null } }, { a: { b: 'd' } }],
  [
    ['a', 'b'],
    ['c', 'd'],
    ['c', 'd'],
  ],
  [{ a: 'foo' }, null, null],
  [{ e: null }, { a: 1 }, { e: null, a: 1 }],
  [[1, 2], { a: 'b', c: null }, { a: 'b' }],
  [{}, { a: { bb: { ccc: null } } }, { a: { bb: {} } }],
])
  test(`${JSON.stringify(target)} with ${JSON.stringify(patch)}`, () =>
    assert.deepEqual(merge_patch(target, patch), wanted));
