// Logins: who guesses waits, and nobody else; each failure is told.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { Logins, network_of } from '../source/logins.js';
import { user_line, users_from } from '../source/users.js';

const password = 'a long password';

function logins() {
  const folder = mkdtempSync(join(tmpdir(), 'logins-'));
  writeFileSync(join(folder, 'users'), `${user_line('anna', password)}\n`);
  const users = users_from(join(folder, 'users'));
  rmSync(folder, { recursive: true });
  /** @type {{ now_ms: number; waits: number[]; told: string[] }} */
  const seen = { now_ms: 0, waits: [], told: [] };
  const surroundings = {
    now: () => seen.now_ms,
    wait: async (/** @type {number} */ ms) => void seen.waits.push(ms),
    log: (/** @type {string} */ text) => void seen.told.push(text),
  };
  return { seen, logins: new Logins(users, surroundings) };
}

test('each failure of a name from an address waits longer, and is told', async () => {
  const { seen, logins: desk } = logins();
  for (let k = 0; k < 7; ++k) {
    assert.equal(await desk.is_admitted('anna', 'wrong', '192.0.2.1'), false);
    seen.now_ms += 16_000;
  }
  assert.deepEqual(seen.waits, [500, 1000, 2000, 4000, 8000, 16000, 16000]);
  assert.deepEqual(new Set(seen.told), new Set(['a login as anna from 192.0.2.1 failed']));
  assert.equal(await desk.is_admitted('anna', password, '192.0.2.1'), true);
  await desk.is_admitted('anna', 'wrong', '192.0.2.1');
  assert.equal(seen.waits.at(-1), 500);
});

test('the next try before its time is refused, and other names and addresses are not', async () => {
  const { seen, logins: desk } = logins();
  await desk.is_admitted('anna', 'wrong', '192.0.2.1');
  await desk.is_admitted('root', 'wrong', '192.0.2.2');
  assert.equal(await desk.is_admitted('anna', password, '192.0.2.1'), false);
  assert.equal(await desk.is_admitted('anna', password, '192.0.2.2'), true);
  seen.now_ms += 500;
  assert.equal(await desk.is_admitted('anna', password, '192.0.2.1'), true);
});

test('what is no name stands in no log', async () => {
  const { seen, logins: desk } = logins();
  await desk.is_admitted('\u001b[2Janna\nfine', 'wrong', '192.0.2.1');
  assert.deepEqual(seen.told, ['a login as ? from 192.0.2.1 failed']);
});

test('an address of IPv6 counts with its network', () => {
  for (const [address, network] of [
    ['192.0.2.1', '192.0.2.1'],
    ['::ffff:192.0.2.1', '192.0.2.1'],
    ['::1', '0:0:0:0::'],
    ['2001:db8:1:2:3:4:5:6', '2001:db8:1:2::'],
    ['2001:db8::5', '2001:db8:0:0::'],
    ['fe80::1%eth0', 'fe80:0:0:0::'],
  ])
    assert.equal(network_of(address), network);
});
