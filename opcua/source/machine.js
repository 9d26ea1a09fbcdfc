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

/** Axes: OPC 40501-1 has channels and working units, but no position; ours is a working unit with one. */
export function add_axis_type(addressSpace, namespace) {
  const base = addressSpace.findObjectType(
    'WorkingUnitMonitoringType',
    addressSpace.getNamespaceIndex(namespaces.machine_tool),
  );
  return namespace.addObjectType({ browseName: 'AxisMonitoringType', subtypeOf: base });
}

// The states of a machine have two parents in the specification, on purpose: no warning of it.
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

  constructor(addressSpace, namespace, axis_type, name, identity) {
    Object.assign(this, { addressSpace, namespace, axis_type, name });
    this.published = new Published();
    this.added = [];
    const machines = addressSpace.rootFolder.objects.getFolderElementByName('Machines');
    const described = Object.keys(identity).map((key) => `Identification.${key}`);
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
    const { server } = this.addressSpace.rootFolder.objects;
    for (const node of [this.node, notification])
      node.setEventNotifier(EventNotifierFlags.SubscribeToEvents);
    server.addReference({ referenceType: 'HasNotifier', nodeId: this.node.nodeId });
    this.node.addReference({ referenceType: 'HasEventSource', nodeId: notification.nodeId });
  }

  show(view) {
    if (view) {
      this.#follow_parts(parts_of(view));
      this.tools.follow(view);
    }
    this.published.set_all(view);
    this.#states.set_all(view);
    this.alerts.follow(view);
  }

  type_of(name) {
    const index = this.addressSpace.getNamespaceIndex(namespaces.machine_tool);
    return this.addressSpace.findObjectType(name, index);
  }

  /** An object of a type of OPC 40501-1 by its name, or of another one, in the namespace of stanok. */
  make(type, options) {
    const object_type = typeof type === 'string' ? this.type_of(type) : type;
    return object_type.instantiate({ ...options, namespace: this.namespace });
  }

  name_of(name) {
    return { name, namespaceIndex: this.namespace.index };
  }

  /** The node at the end of a way of names, of whatever namespace. */
  child(path) {
    return path.split('.').reduce((node, name) => {
      const next = node
        .findReferencesExAsObject('Aggregates')
        .find((one) => one.browseName.name === name);
      if (!next) throw new Error(`${this.name}: no node ${name} of ${path}`);
      return next;
    }, this.node);
  }

  add_state(node, read) {
    this.#states.add(node, read);
  }

  add_element(type, name, optionals = []) {
    const node = this.make(type, {
      browseName: this.name_of(name),
      componentOf: this.child('Monitoring'),
      optionals,
    });
    this.added.push(node);
    return node;
  }

  remove(node) {
    const way = `${node.nodeId.value}-`;
    const is_gone = (one) => String(one.nodeId.value).startsWith(way) || one === node;
    this.published.forget(is_gone);
    this.#states.forget(is_gone);
    this.namespace.deleteNode(node);
  }

  #set_plan_version() {
    const value = String(++this.#version);
    const version = this.child('Production.ProductionPlan').nodeVersion;
    version.setValueFromSource({ dataType: DataType.String, value });
  }

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
