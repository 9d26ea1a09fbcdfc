// States: the state machines of one machine, set from views.
import { DataType, NodeId, StatusCodes, promoteToStateMachine } from 'node-opcua';

/**
 * @import { UAStateMachineEx } from 'node-opcua'
 * @import { Node, ReadState, View } from '../types/view.js'
 * @typedef {{ machine: UAStateMachineEx, read: ReadState, state: string | null | undefined }} State
 */

export class States {
  /** @type {State[]} */
  #all = [];

  /**
   * `read(view)` gives the name of a state of the type of `node`.
   * @param {Node} node
   * @param {ReadState} read
   */
  add(node, read) {
    const one = { machine: promoteToStateMachine(node), read, state: undefined };
    this.#all.push(one);
    this.#set(one, null);
  }

  /** @param {(node: Node) => boolean} is_gone */
  forget(is_gone) {
    this.#all = this.#all.filter(({ machine }) => !is_gone(machine));
  }

  /** @param {View | null} view */
  set_all(view) {
    for (const one of this.#all) this.#set(one, view);
  }

  /**
   * @param {State} one
   * @param {View | null} view
   */
  #set(one, view) {
    const state = view && one.read(view);
    if (state === one.state) return;
    one.state = state;
    one.machine.setState(state);
    if (!state) this.#make_bad(one.machine);
  }

  /**
   * setState(null) says that the state machine does not run; it is that nobody knows.
   * @param {Node} machine
   */
  #make_bad({ currentState }) {
    const set = (
      /** @type {Node} */ variable,
      /** @type {DataType} */ dataType,
      /** @type {unknown} */ value,
    ) => variable?.setValueFromSource({ dataType, value }, StatusCodes.BadNoCommunication);
    set(currentState, DataType.LocalizedText, { text: '' });
    set(currentState.id, DataType.NodeId, NodeId.nullNodeId);
    set(currentState.number, DataType.UInt32, 0);
  }
}
