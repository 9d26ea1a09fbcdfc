#!/usr/bin/env node
// stanok-opcua: machines of this computer as a server of OPC UA for Machine Tools (OPC 40501-1).
// Command line and exit codes: 0 ended by a signal, 1 failed, 2 wrong usage.
import { readFileSync } from 'node:fs';
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
    if (error.code !== 'ERR_MODULE_NOT_FOUND' || !/node-opcua/.test(error.message)) throw error;
    const folder = new URL('.', import.meta.url).pathname;
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

async function run(words) {
  const options = options_from(words);
  if (options.help) return void process.stdout.write(usage);
  if (options.version) return void console.log(version);
  if (options.add_user !== undefined)
    return void console.log(user_line(options.add_user, readFileSync(0, 'utf8').split('\n')[0]));
  const ended = until_signal();
  console.log = console.error; // what libraries say belongs to the log
  const { start_server } = await server_module();
  const server = await start_server(options, version);
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
