// Tools: nodes come and go with the table, and a large table costs no more than it is long.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Tools } from '../source/tools.js';

/** @import { Node, ReadValue, Tool, View } from '../types/view.js' */

function machine_with_tools() {
  /** @type {ReadValue[]} */
  const reads = [];
  /** @type {string[]} */
  const gone = [];
  const variable = () => ({ setValueFromSource() {} });
  /** @type {Node} */
  const machine = {
    published: {
      add: (
        /** @type {Node} */ _node,
        /** @type {number} */ _type,
        /** @type {ReadValue} */ read,
      ) => reads.push(read),
      add_constant() {},
    },
    child: () => ({ nodeVersion: variable() }),
    name_of: (/** @type {string} */ name) => name,
    make: (/** @type {string} */ _type, /** @type {Node} */ { browseName }) => ({
      browseName,
      locked: {},
    }),
    remove: (/** @type {Node} */ node) => gone.push(node.browseName),
  };
  return { reads, gone, tools: new Tools(machine) };
}

/**
 * @param {object[]} tools
 * @returns {View}
 */
const view_of = (tools) => /** @type {Node} */ ({ tools });

test('a tool that leaves the table has no node any more', () => {
  const { reads, gone, tools } = machine_with_tools();
  const table = [
    { number: 4, edge: 1, name: 'cutter' },
    { number: 5, edge: 2, name: 'drill' },
  ];
  tools.follow(view_of(table));
  assert.deepEqual(
    reads.map((read) => read(view_of(table))),
    [4, 1, 'cutter', 5, 2, 'drill'],
  );
  tools.follow(view_of(table.slice(1)));
  assert.deepEqual(gone, ['Tool4Edge1']);
});

test('values of a table are looked up as often as it has rows, not as often as their square', () => {
  let looks = 0;
  const row = (/** @type {number} */ number) => ({
    get number() {
      ++looks;
      return number;
    },
    edge: 1,
    name: '',
  });
  const { reads, tools } = machine_with_tools();
  const count = 1000;
  const view = view_of(Array.from({ length: count }, (_, k) => row(k)));
  tools.follow(view);
  looks = 0;
  tools.follow(view);
  for (const read of reads) read(view);
  assert.equal(reads.length, 3 * count);
  assert.ok(looks <= 4 * count, `${looks} looks at ${count} rows`);
});
