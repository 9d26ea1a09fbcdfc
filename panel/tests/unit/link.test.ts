// The connection: what is asked without one fails at once, what was asked fails when it goes, values
// are old within a second of silence, and it comes back by itself.
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { ownNumbers, Refusal } from '../../src/rpc/json_rpc';
import { greeting_ms, Link, silence_ms, type LinkState, type Socket } from '../../src/rpc/link';

class FakeSocket implements Socket {
  onopen: (() => void) | null = null;
  onclose: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  sent: { id: number; method: string }[] = [];
  closed = false;

  send(text: string): void {
    this.sent.push(JSON.parse(text) as { id: number; method: string });
  }
  close(): void {
    this.closed = true;
  }
  say(message: object): void {
    this.onmessage?.({ data: JSON.stringify(message) });
  }
}

const hello = { jsonrpc: '2.0', method: 'hello', params: { machine: 'mill' } };
const status = { jsonrpc: '2.0', method: 'status', params: { full: false, state: {} } };

let sockets: FakeSocket[];
let states: LinkState[];
let signedOut: boolean;
let link: Link;
const socket = (): FakeSocket => sockets.at(-1) as FakeSocket;

beforeEach(() => {
  vi.useFakeTimers();
  sockets = [];
  states = [];
  signedOut = false;
  link = new Link(
    () => {
      sockets.push(new FakeSocket());
      return socket();
    },
    {
      changed: (state) => states.push(state),
      greeted: () => undefined,
      notified: () => undefined,
      binary: () => undefined,
      refused: () => Promise.resolve(signedOut),
    },
  );
  link.start();
});

afterEach(() => {
  link.stop();
  vi.useRealTimers();
});

test('before the daemon has greeted nothing is sent', async () => {
  await expect(link.request('machine.on', {})).rejects.toMatchObject({
    number: ownNumbers.notConnected,
  });
  expect(socket().sent).toHaveLength(0);
});

test('an answer belongs to the request of its id, in whatever order they come', async () => {
  socket().say(hello);
  const first = link.request('machine.status', {});
  const second = link.request('alarm.list', {});
  const [one, two] = socket().sent;
  socket().say({ jsonrpc: '2.0', id: two?.id, result: 'two' });
  socket().say({ jsonrpc: '2.0', id: one?.id, result: 'one' });
  expect(await first).toBe('one');
  expect(await second).toBe('two');
});

test('a refusal carries code, place and remedy', async () => {
  socket().say(hello);
  const asked = link.request('program.load', { program: 'a.nc' });
  const data = { code: 'E1002', file: 'a.nc', line: 12, remedy: 'write digits' };
  socket().say({ id: socket().sent[0]?.id, error: { code: -32004, message: 'bad number', data } });
  const refusal = (await asked.catch((error: unknown) => error)) as Refusal;
  expect(refusal).toBeInstanceOf(Refusal);
  expect(refusal.message).toBe('bad number');
  expect(refusal.data).toMatchObject({ ...data, column: null });
});

test('silence makes the values old within a second; the next message makes them new', () => {
  socket().say(hello);
  expect(states).toEqual(['live']);
  vi.advanceTimersByTime(silence_ms - 100);
  expect(states).toEqual(['live']);
  vi.advanceTimersByTime(300);
  expect(states).toEqual(['live', 'lost']);
  expect(silence_ms + 200).toBeLessThanOrEqual(1000);
  socket().say(status);
  expect(states).toEqual(['live', 'lost', 'live']);
  expect(sockets).toHaveLength(1);
});

test('while nothing is heard only stops are sent', async () => {
  socket().say(hello);
  vi.advanceTimersByTime(silence_ms + 300);
  for (const method of ['program.start', 'jog', 'mdi', 'override.feed', 'machine.on']) {
    await expect(link.request(method, {})).rejects.toMatchObject({
      number: ownNumbers.notConnected,
    });
  }
  expect(socket().sent).toHaveLength(0);
  link.request('machine.estop', {}).catch(() => undefined);
  link.request('program.hold', {}).catch(() => undefined);
  expect(socket().sent.map((one) => one.method)).toEqual(['machine.estop', 'program.hold']);
});

test('a connection that stays silent is given up for a new one', async () => {
  socket().say(hello);
  await vi.advanceTimersByTimeAsync(5000);
  expect(sockets.length).toBeGreaterThan(1);
  expect(sockets[0]?.closed).toBe(true);
});

test('a connection that nobody greets is given up for a new one', async () => {
  await vi.advanceTimersByTimeAsync(greeting_ms - 300);
  expect(sockets).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(1000);
  expect(sockets).toHaveLength(2);
  expect(sockets[0]?.closed).toBe(true);
  socket().say(hello);
  expect(states.at(-1)).toBe('live');
});

test('what was asked fails when the connection goes, and is not asked again', async () => {
  socket().say(hello);
  const asked = link.request('program.start', {}).catch((error: unknown) => error);
  socket().onclose?.();
  expect(await asked).toMatchObject({ number: ownNumbers.connectionLost });
  await vi.advanceTimersByTimeAsync(1000);
  socket().say(hello);
  expect(sockets).toHaveLength(2);
  expect(socket().sent).toHaveLength(0);
});

test('it tries again more and more slowly, and not at all when signed out', async () => {
  socket().onclose?.();
  await vi.advanceTimersByTimeAsync(300);
  expect(sockets).toHaveLength(2);
  socket().onclose?.();
  await vi.advanceTimersByTimeAsync(300);
  expect(sockets).toHaveLength(2);
  await vi.advanceTimersByTimeAsync(300);
  expect(sockets).toHaveLength(3);
  signedOut = true;
  socket().onclose?.();
  await vi.advanceTimersByTimeAsync(60_000);
  expect(sockets).toHaveLength(3);
});
