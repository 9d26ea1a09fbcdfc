// What a test of the page stands on: the real daemon with simulated drives and the real server of the
// page, in a folder of their own, and Debian's Chromium without a screen. close() ends all of them.
//
// The folder of the programs is $STANOK_BIN.
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const root = fileURLToPath(new URL('../../', import.meta.url));
export const bin = process.env.STANOK_BIN ?? join(root, 'build/release/bin');
const chromiumPath = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(existsSync);

const patience_ms = 60_000;

/** Whether every size, language and look of a view is to be looked at, and not some of each. */
export const full = process.env.STANOK_FULL === '1';

/** Of the users `observer` and `operator`. */
export const password = 'a long password';

/** Asks `condition` until it is true; never trusts a time, except for giving up. */
export async function until(what, condition, { limit_s = 120, shown } = {}) {
  const end = Date.now() + limit_s * 1000;
  for (;;) {
    const value = await condition();
    if (value) return value;
    if (Date.now() > end) {
      const seen = shown ? `\n${JSON.stringify(await shown())}` : '';
      throw new Error(`waited ${limit_s} s in vain for: ${what}${seen}`);
    }
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** Tests that follow each other: when one fails, the ones behind it are left out. */
export function storyOf() {
  let failed = false;
  return (name, act) =>
    test(name, async (context) => {
      if (failed) return context.skip('an earlier step failed');
      failed = true;
      await act(context);
      failed = false;
    });
}

/** A client of the daemon's socket beside the page, to look at the machine with other eyes. */
async function openClient(socket) {
  const stream = connect(socket);
  const waiting = new Map();
  let next = 1;
  let greet;
  const hello = new Promise((resolve, reject) => {
    greet = resolve;
    stream.on('error', reject);
  });
  // The interface tells errors of its stream again, for example that nobody listens yet.
  const lines = createInterface({ input: stream }).on('error', () => undefined);
  lines.on('line', (line) => {
    const message = JSON.parse(line);
    if (message.method === 'hello') greet(message.params);
    const one = waiting.get(message.id);
    waiting.delete(message.id);
    if (message.error)
      one?.reject(new Error(`${message.error.data.code} ${message.error.message}`));
    else one?.resolve(message.result);
  });
  await hello;
  return {
    call(method, params = {}) {
      const id = next++;
      return new Promise((resolve, reject) => {
        waiting.set(id, { resolve, reject });
        stream.write(`${JSON.stringify({ jsonrpc: '2.0', id, method, params })}\n`);
      });
    },
    close: () => stream.destroy(),
  };
}

/** Ends a process that this stage started, and waits until it is gone. */
async function end(child, signal = 'SIGTERM') {
  if (child.exitCode !== null || child.signalCode !== null) return;
  child.kill(signal);
  child.kill('SIGCONT');
  await until('a process has ended', () => child.exitCode !== null || child.signalCode !== null);
}

async function startDaemon(folder, machine, programs, name = 'stanok') {
  const socket = join(folder, `${name}.sock`);
  for (const name of ['state', 'log']) mkdirSync(join(folder, name));
  const options = ['--machine', join(root, 'config/machines', machine), '--drives', 'embedded'];
  options.push('--lcm', 'off', '--socket', socket, '--state', join(folder, 'state'));
  options.push('--log', join(folder, 'log'), '--program-root', programs);
  const daemon = spawn(join(bin, 'stanokd'), options, { stdio: ['ignore', 'ignore', 'pipe'] });
  let errors = '';
  daemon.stderr.on('data', (text) => (errors += text));
  const client = await until('the daemon answers', async () => {
    if (daemon.exitCode !== null) throw new Error(`the daemon ended:\n${errors}`);
    return existsSync(socket) && (await openClient(socket).catch(() => null));
  });
  return { daemon, socket, client };
}

const sessionsBeside = (users) => `${users}.sessions`;

async function startServer(socket, users, listen = '127.0.0.1:0', others = []) {
  const options = ['--listen', listen, '--socket', socket, '--page', join(root, 'panel/dist')];
  options.push(...others);
  options.push('--users', users, '--sessions', sessionsBeside(users));
  const server = spawn(join(bin, 'stanok-web'), options, { stdio: ['ignore', 'pipe', 'ignore'] });
  let printed = '';
  server.stdout.on('data', (text) => (printed += text));
  const link = await until('the server of the page answers', () => {
    if (server.exitCode !== null) throw new Error('stanok-web ended');
    return /http:\S+/.exec(printed)?.[0];
  });
  return { server, address: new URL(link).host };
}

/** A second machine beside the first one, and a gateway that keeps the history of both. */
async function startNeighbour(folder, machine, socket) {
  const own = join(folder, 'neighbour');
  mkdirSync(join(own, 'programs'), { recursive: true });
  const other = await startDaemon(own, machine, join(own, 'programs'), 'neighbour');
  const words = ['--daemon', `stanok=${socket}`, '--daemon', `neighbour=${other.socket}`];
  words.push('--broker', 'off', '--state', join(folder, 'gateway'));
  const gateway = spawn(join(bin, 'stanok-gateway'), words, { stdio: 'ignore' });
  const history = join(folder, 'gateway', 'history.sqlite');
  await until('the history is there', () => existsSync(history));
  return { other, gateway, options: ['--socket', other.socket, '--history', history] };
}

/** machine: file in config/machines; programs: files to be copied into the program root; neighbour: machine file of a
    second machine that the same server shows. */
export async function setStage({
  machine = 'e7106mf4.toml',
  programs: sources = [],
  neighbour: second = null,
} = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'panel-'));
  const programs = join(folder, 'programs');
  mkdirSync(programs);
  for (const source of sources) cpSync(source, join(programs, basename(source)));
  const { daemon, socket, client } = await startDaemon(folder, machine, programs);
  const users = join(folder, 'users');
  for (const role of ['observer', 'operator']) {
    const words = ['user', 'add', role, '--role', role, '--users', users];
    execFileSync(join(bin, 'stanok-web'), words, { input: `${password}\n` });
  }
  const neighbour = second === null ? null : await startNeighbour(folder, second, socket);
  const others = neighbour?.options ?? [];
  let { server, address } = await startServer(socket, users, undefined, others);
  const browser = await chromium.launch({
    executablePath: chromiumPath,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader'],
  });
  const faults = [];

  function newLink() {
    const printed = execFileSync(join(bin, 'stanok'), ['--socket', socket, 'panel', '--no-open'], {
      stdio: ['ignore', 'pipe', 'ignore'],
    });
    return /http:\S+/.exec(String(printed))[0];
  }

  /** before(page) may lay hands on its WebSocket. */
  async function openPage({ width = 1280, height = 800, before, link, ...options } = {}) {
    const context = await browser.newContext({ viewport: { width, height }, ...options });
    const page = await context.newPage();
    page.setDefaultTimeout(patience_ms);
    page.on('pageerror', (error) => faults.push(`page: ${error.message}`));
    page.on('console', (message) => {
      const expected = /WebSocket|ERR_|401/.test(message.text());
      if (message.type() === 'error' && !expected) faults.push(`console: ${message.text()}`);
    });
    await before?.(page);
    await page.goto(link ?? newLink());
    return page;
  }

  const stage = {
    client,
    neighbour: neighbour?.other,
    programs,
    browser,
    faults,
    newLink,
    openPage,
    address: () => `http://${address}/`,
    /** The page with the state of all channels in view. */
    async openMachine(options) {
      const page = await openPage(options);
      await page.locator('[data-state]').first().waitFor();
      return page;
    },
    status: (channel = 1) => client.call('channel.status', { channel }),
    /** Switches the machine on, again where a loaded computer starved the simulated drives. */
    async switchOn() {
      await until('the machine is on', async () => {
        for (const channel of [1, 2])
          await client.call('program.reset', { channel }).catch(() => 0);
        await client.call('machine.on').catch(() => 0);
        const drives = await client.call('drive.status');
        const axes = (await stage.status()).axes;
        const states = Object.entries(axes).filter(([, axis]) => axis.takes_part);
        return states.every(([name, axis]) => {
          const drive = drives.axes.find((one) => one.axis === name);
          return axis.enabled && drive.state === 'operation enabled';
        });
      });
    },
    /** The server falls silent, as a network that hangs, or speaks again. */
    silence: (on) => server.kill(on ? 'SIGSTOP' : 'SIGCONT'),
    async restartServer({ forgets = false } = {}) {
      await end(server, 'SIGKILL');
      if (forgets) rmSync(sessionsBeside(users));
      ({ server, address } = await startServer(socket, users, address, others));
    },
    async close() {
      server.kill('SIGCONT');
      await browser.close();
      client.close();
      await end(server);
      if (neighbour !== null) {
        neighbour.other.client.close();
        await end(neighbour.gateway);
        await end(neighbour.other.daemon);
      }
      await end(daemon);
      rmSync(folder, { recursive: true });
    },
  };
  return stage;
}

/** Small programs of the seed's master, made by the project's own generator. */
export function seedPrograms() {
  const folder = mkdtempSync(join(tmpdir(), 'panel-programs-'));
  execFileSync(join(bin, 'generate_programs'), ['--scale', 'small', '--out', folder]);
  const names = ['0003_MB_3D.nc', 'Impeller_surface.nc'];
  return { folder, files: names.map((name) => join(folder, name)) };
}
