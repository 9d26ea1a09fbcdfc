// Machine: one daemon as a MachineTool of the address space (OPC 40501-1).
//
// The nodes that every machine has are there from the beginning, Bad until the daemon has been
// reached; channels, axes and spindles come with it, and anew when it has others. NodeIds are strings
// made of the names on the way to a node: they are the same after each start.
import { DataType, EventNotifierFlags, LogLevel, setLogLevel } from 'node-opcua';
import { Alerts } from './alerts.js';
import { publish_identification } from './identification.js';
import { add_axis, add_channel, add_spindle, publish_machine_monitoring } from './monitoring.js';
import { namespaces } from './namespaces.js';
import { add_job, publish_active_program } from './production.js';
import { Published } from './published.js';
import { States } from './states.js';
import { Tools } from './tools.js';
import { item_state, machinery_mode, parts_of } from './words.js';

/**
 * @import { InstantiateObjectOptions, UAObjectType } from 'node-opcua'
 * @import { AddressSpace, Identity, Namespace, Node, Parts, ReadState, View } from '../types/view.js'
 */

const optional_nodes = [
  'Identification.ComponentName',
  'Identification.Model',
  'Identification.SoftwareRevision',
  'Identification.SoftwareIdentification',
  'MachineryBuildingBlocks',
  'MachineryBuildingBlocks.MachineryItemState',
  'MachineryBuildingBlocks.MachineryOperationMode',
  'Equipment.Tools',
  'Equipment.Tools.NodeVersion',
  'Notification.Messages',
  'Production.ProductionPlan',
  'Production.ProductionPlan.NodeVersion',
];

/**
 * Axes: OPC 40501-1 has channels and working units, but no position; ours is a working unit with one.
 * @param {AddressSpace} addressSpace
 * @param {Namespace} namespace
 * @returns {UAObjectType}
 */
export function add_axis_type(addressSpace, namespace) {
  return namespace.addObjectType({
    browseName: 'AxisMonitoringType',
    subtypeOf: type_of_machine_tool(addressSpace, 'WorkingUnitMonitoringType'),
  });
}

/**
 * @param {AddressSpace} addressSpace
 * @param {string} name
 */
function type_of_machine_tool(addressSpace, name) {
  const type = addressSpace.findObjectType(
    name,
    addressSpace.getNamespaceIndex(namespaces.machine_tool),
  );
  if (!type) throw new Error(`OPC 40501-1 has no type ${name}`);
  return type;
}

/**
 * @param {AddressSpace} addressSpace
 * @returns {Node}
 */
function root_of(addressSpace) {
  return addressSpace.rootFolder;
}

/**
 * The states of a machine have two parents in the specification, on purpose: no warning of it.
 * @template Made
 * @param {() => Made} make
 * @returns {Made}
 */
function quietly(make) {
  setLogLevel(LogLevel.Error);
  try {
    return make();
  } finally {
    setLogLevel(LogLevel.Warning);
  }
}

export class Machine {
  #states = new States();
  #parts = '';
  #version = 0;

  /**
   * @param {AddressSpace} addressSpace
   * @param {Namespace} namespace
   * @param {UAObjectType} axis_type
   * @param {string} name
   * @param {Identity} identity
   */
  constructor(addressSpace, namespace, axis_type, name, identity) {
    this.addressSpace = addressSpace;
    this.namespace = namespace;
    this.axis_type = axis_type;
    this.name = name;
    this.published = new Published();
    /** @type {Node[]} */
    this.added = [];
    const machines = root_of(addressSpace).objects.getFolderElementByName('Machines');
    const described = Object.keys(identity).map((key) => `Identification.${key}`);
    /** @type {Node} */
    this.node = quietly(() =>
      this.make('MachineToolType', {
        browseName: this.name_of(name),
        nodeId: `s=${name}`,
        organizedBy: machines,
        optionals: [...optional_nodes, ...described],
      }),
    );
    publish_identification(this, identity);
    const blocks = 'MachineryBuildingBlocks';
    this.add_state(this.child(`${blocks}.MachineryItemState`), item_state);
    this.add_state(this.child(`${blocks}.MachineryOperationMode`), machinery_mode);
    publish_machine_monitoring(this);
    publish_active_program(this);
    this.#set_plan_version();
    this.#notify();
    this.tools = new Tools(this);
    this.alerts = new Alerts(this);
  }

  // Alarms of a machine are events of its Notification, of the machine and of the server.
  #notify() {
    const notification = this.child('Notification');
    const { server } = root_of(this.addressSpace).objects;
    for (const node of [this.node, notification])
      node.setEventNotifier(EventNotifierFlags.SubscribeToEvents);
    server.addReference({ referenceType: 'HasNotifier', nodeId: this.node.nodeId });
    this.node.addReference({ referenceType: 'HasEventSource', nodeId: notification.nodeId });
  }

  /** @param {View | null} view */
  show(view) {
    if (view) {
      this.#follow_parts(parts_of(view));
      this.tools.follow(view);
    }
    this.published.set_all(view);
    this.#states.set_all(view);
    this.alerts.follow(view);
  }

  /** @param {string} name */
  type_of(name) {
    return type_of_machine_tool(this.addressSpace, name);
  }

  /** @param {string} name */
  type_of_variable(name) {
    const type = this.addressSpace.findVariableType(name);
    if (!type) throw new Error(`no type of variables has the name ${name}`);
    return type;
  }

  /**
   * An object of a type of OPC 40501-1 by its name, or of another one, in the namespace of stanok.
   * @param {string | UAObjectType} type
   * @param {Omit<InstantiateObjectOptions, 'namespace'>} options
   * @returns {Node}
   */
  make(type, options) {
    const object_type = typeof type === 'string' ? this.type_of(type) : type;
    return object_type.instantiate({ ...options, namespace: this.namespace });
  }

  /** @param {string} name */
  name_of(name) {
    return { name, namespaceIndex: this.namespace.index };
  }

  /**
   * The node at the end of a way of names, of whatever namespace.
   * @param {string} path
   * @returns {Node}
   */
  child(path) {
    return path.split('.').reduce((node, name) => {
      const next = node
        .findReferencesExAsObject('Aggregates')
        .find((/** @type {Node} */ one) => one.browseName.name === name);
      if (!next) throw new Error(`${this.name}: no node ${name} of ${path}`);
      return next;
    }, this.node);
  }

  /**
   * @param {Node} node
   * @param {ReadState} read
   */
  add_state(node, read) {
    this.#states.add(node, read);
  }

  /**
   * @param {string | UAObjectType} type
   * @param {string} name
   * @param {string[]} optionals
   */
  add_element(type, name, optionals = []) {
    const node = this.make(type, {
      browseName: this.name_of(name),
      componentOf: this.child('Monitoring'),
      optionals,
    });
    this.added.push(node);
    return node;
  }

  /** @param {Node} node */
  remove(node) {
    const way = `${node.nodeId.value}-`;
    const is_gone = (/** @type {Node} */ one) =>
      String(one.nodeId.value).startsWith(way) || one === node;
    this.published.forget(is_gone);
    this.#states.forget(is_gone);
    this.namespace.deleteNode(node);
  }

  #set_plan_version() {
    const value = String(++this.#version);
    const version = this.child('Production.ProductionPlan').nodeVersion;
    version.setValueFromSource({ dataType: DataType.String, value });
  }

  /** @param {Parts} parts */
  #follow_parts(parts) {
    const text = JSON.stringify(parts);
    if (text === this.#parts) return;
    this.#parts = text;
    for (const node of this.added.splice(0)) this.remove(node);
    for (const channel of parts.channels) add_channel(this, channel);
    for (const name of parts.axes) add_axis(this, name);
    for (const id of parts.spindles) add_spindle(this, id);
    parts.channels.forEach((channel, number) => add_job(this, channel, number));
    this.#set_plan_version();
  }
}
