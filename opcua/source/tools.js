// Equipment/Tools: one ToolType for each edge of the table of tools.
import { DataType } from 'node-opcua';

// OPC 40501-1, ToolManagement and ToolLocked.
const number_based = 0;
const capability_unavailable = 0;
const tools_max = 2000;

/**
 * @import { Node, Tool, View } from '../types/view.js'
 * @import { Machine } from './machine.js'
 */

/** @param {Pick<Tool, 'number' | 'edge'>} tool */
const key_of = ({ number, edge }) => `Tool${number}Edge${edge}`;

/** Tools of a machine that come and go with its table. */
export class Tools {
  #machine;
  /** @type {Map<string, Node>} */
  #nodes = new Map();
  /** @type {Map<string, Tool>} rows of the table by the names of their nodes */
  #rows = new Map();
  #version = 0;

  /** @param {Machine} machine */
  constructor(machine) {
    this.#machine = machine;
    this.list = machine.child('Equipment.Tools');
    this.#set_version();
  }

  /** @param {View} view */
  follow(view) {
    this.#rows = new Map(view.tools.slice(0, tools_max).map((tool) => [key_of(tool), tool]));
    const gone = [...this.#nodes.keys()].filter((key) => !this.#rows.has(key));
    const come = [...this.#rows].filter(([key]) => !this.#nodes.has(key));
    if (gone.length === 0 && come.length === 0) return;
    for (const key of gone) this.#remove(key);
    for (const [key, tool] of come) this.#nodes.set(key, this.#add(key, tool));
    this.#set_version();
  }

  #set_version() {
    this.list.nodeVersion.setValueFromSource({
      dataType: DataType.String,
      value: String(++this.#version),
    });
  }

  /** @param {string} key */
  #remove(key) {
    this.#machine.remove(this.#nodes.get(key));
    this.#nodes.delete(key);
  }

  /**
   * @param {string} key
   * @param {Tool} tool
   */
  #add(key, { number, edge }) {
    const machine = this.#machine;
    const node = machine.make('ToolType', {
      browseName: machine.name_of(key),
      componentOf: this.list,
      optionals: ['ControlIdentifier2', 'Name', 'Identifier'],
    });
    const row = () => this.#rows.get(key);
    const { published } = machine;
    published.add(node.controlIdentifier1, DataType.UInt32, () => row()?.number);
    published.add(node.controlIdentifier2, DataType.UInt32, () => row()?.edge);
    published.add_constant(node.controlIdentifierInterpretation, DataType.Int32, number_based);
    published.add_constant(node.identifier, DataType.String, `${number}.${edge}`);
    published.add(node.name, DataType.String, () => row()?.name);
    // The table has no locks: every tool of it may be used.
    published.add_constant(node.locked, DataType.Boolean, false);
    const reason = node.locked.reasonForLocking;
    published.add_constant(reason, DataType.Int32, capability_unavailable);
    return node;
  }
}
