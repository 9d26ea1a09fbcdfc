#!/usr/bin/env node
// stanok-opcua: machines of this computer as a server of OPC UA for Machine Tools (OPC 40501-1).
// Command line and exit codes: 0 ended by a signal, 1 failed, 2 wrong usage.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Usage, options_from, usage } from './source/options.js';
import { user_line } from './source/users.js';

const version = JSON.parse(
  readFileSync(new URL('./package.json', import.meta.url), 'utf8'),
).version;

// The packages of npm are fetched by whoever installs this program, not by its package of Debian.
async function server_module() {
  try {
    return await import('./source/server.js');
  } catch (error) {
    const is_missing =
      error instanceof Error && /Cannot find package 'node-opcua'/.test(error.message);
    if (!is_missing) throw error;
    const folder = fileURLToPath(new URL('.', import.meta.url));
    throw new Error(
      `node-opcua is not installed: cd ${folder} && npm ci --omit=dev --ignore-scripts`,
    );
  }
}

function until_signal() {
  return new Promise((resolve) => {
    for (const signal of ['SIGINT', 'SIGTERM']) process.once(signal, resolve);
  });
}

/** @param {string[]} words */
async function run(words) {
  const wanted = options_from(words);
  if (wanted.kind === 'help') return void process.stdout.write(usage);
  if (wanted.kind === 'version') return void console.log(version);
  if (wanted.kind === 'user')
    return void console.log(user_line(wanted.name, readFileSync(0, 'utf8').split('\n')[0]));
  const ended = until_signal();
  console.log = console.error; // what libraries say belongs to the log
  const { start_server } = await server_module();
  const server = await start_server(wanted.options, version);
  process.stdout.write(`${server.address}\n`);
  await ended;
  await server.stop();
}

run(process.argv.slice(2)).then(
  () => process.exit(0),
  (error) => {
    console.error(`stanok-opcua: ${error.message}`);
    process.exit(error instanceof Usage ? 2 : 1);
  },
);
