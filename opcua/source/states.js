// States: the state machines of one machine, set from views.
import { DataType, NodeId, StatusCodes, promoteToStateMachine } from 'node-opcua';

export class States {
  #all = [];

  /** `read(view)` gives the name of a state of the type of `node`. */
  add(node, read) {
    const one = { machine: promoteToStateMachine(node), read, state: undefined };
    this.#all.push(one);
    this.#set(one, null);
  }

  forget(is_gone) {
    this.#all = this.#all.filter(({ machine }) => !is_gone(machine));
  }

  set_all(view) {
    for (const one of this.#all) this.#set(one, view);
  }

  #set(one, view) {
    const state = view && one.read(view);
    if (state === one.state) return;
    one.state = state;
    one.machine.setState(state);
    if (!state) this.#make_bad(one.machine);
  }

  // setState(null) says that the state machine does not run; it is that nobody knows.
  #make_bad({ currentState }) {
    const set = (variable, dataType, value) =>
      variable?.setValueFromSource({ dataType, value }, StatusCodes.BadNoCommunication);
    set(currentState, DataType.LocalizedText, { text: '' });
    set(currentState.id, DataType.NodeId, NodeId.nullNodeId);
    set(currentState.number, DataType.UInt32, 0);
  }
}
