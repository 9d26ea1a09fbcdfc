// The file of --identity: what is wrong in it is told with its place, before the server starts.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { identities_from } from '../source/identification.js';

const folder = mkdtempSync(join(tmpdir(), 'stanok-opcua-'));
after(() => rmSync(folder, { recursive: true }));

/** @param {string} text */
function read(text) {
  const file = join(folder, 'identity.json');
  writeFileSync(file, text);
  return identities_from(file, ['mill']);
}

test('members of machines are taken as they are', () => {
  assert.deepEqual(identities_from(undefined, ['mill']), {});
  const members = {
    Manufacturer: 'Example Works',
    YearOfConstruction: 2024,
    MonthOfConstruction: 12,
  };
  assert.deepEqual(read(JSON.stringify({ mill: members })), { mill: members });
});

for (const [text, told] of [
  ['{"mill": ', /identity\.json: this is not JSON/],
  ['null', /identity\.json must be a JSON object/],
  ['[]', /identity\.json must be a JSON object/],
  ['{"mill": null}', /mill must be an object/],
  ['{"mill": ["a"]}', /mill must be an object/],
  ['{"lathe": {}}', /no machine has the name lathe/],
  ['{"mill": {"Colour": "grey"}}', /mill\.Colour is not known; write one of Manufacturer/],
  ['{"mill": {"toString": "grey"}}', /mill\.toString is not known/],
  ['{"mill": {"Manufacturer": 7}}', /mill\.Manufacturer must be a string/],
  [
    '{"mill": {"YearOfConstruction": "2024"}}',
    /YearOfConstruction must be a whole number from 1 to 65535/,
  ],
  [
    '{"mill": {"YearOfConstruction": 70000}}',
    /YearOfConstruction must be a whole number from 1 to 65535/,
  ],
  [
    '{"mill": {"YearOfConstruction": 2024.5}}',
    /YearOfConstruction must be a whole number from 1 to 65535/,
  ],
  [
    '{"mill": {"MonthOfConstruction": 13}}',
    /MonthOfConstruction must be a whole number from 1 to 12/,
  ],
])
  test(`${text} is refused`, () => assert.throws(() => read(String(text)), { message: told }));
