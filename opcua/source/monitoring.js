// Monitoring: the machine tool as a whole, its channels, axes and spindles.
import { DataType, Range, standardUnits } from 'node-opcua';
import {
  ChannelState,
  axis_in,
  channel_mode,
  is_rotating,
  operation_mode,
  spindle_in,
} from './words.js';

/**
 * @import { EUInformation, UAVariable } from 'node-opcua'
 * @import { Axis, Channel, Node, Parts, ReadValue, Spindle, Value } from '../types/view.js'
 * @import { Machine } from './machine.js'
 */

// Ranges of override.feed, override.rapid and override.spindle.
const feed_range = { low: 0, high: 200 };
const rapid_range = { low: 0, high: 100 };
const spindle_range = { low: 50, high: 150 };

/**
 * @param {Machine} machine
 * @param {Node} variable
 * @param {{ low: number, high: number }} range
 * @param {ReadValue} read
 */
function add_percent(machine, variable, range, read) {
  add_units(machine, variable, standardUnits.percent);
  const property = variable.getPropertyByName('EURange');
  machine.published.add_constant(property, DataType.ExtensionObject, new Range(range));
  machine.published.add(variable, DataType.Double, read);
}

/**
 * @param {Machine} machine
 * @param {Node} variable
 * @param {EUInformation} units
 */
function add_units(machine, variable, units) {
  const property = variable.getPropertyByName('EngineeringUnits');
  machine.published.add_constant(property, DataType.ExtensionObject, units);
}

/**
 * @param {Machine} machine
 * @param {Node} parent
 * @param {string} name
 * @param {EUInformation} units
 * @param {ReadValue} read
 */
function add_quantity(machine, parent, name, units, read) {
  const variable = machine.type_of_variable('AnalogUnitType').instantiate({
    browseName: machine.name_of(name),
    componentOf: parent,
    dataType: DataType.Double,
    namespace: machine.namespace,
  });
  add_units(machine, variable, units);
  machine.published.add(variable, DataType.Double, read);
}

/**
 * @param {Machine} machine
 * @param {Node} parent
 * @param {string} name
 * @param {ReadValue} read
 */
function add_flag(machine, parent, name, read) {
  const options = { browseName: name, componentOf: parent, dataType: DataType.Boolean };
  machine.published.add(machine.namespace.addVariable(options), DataType.Boolean, read);
}

/** @param {Machine} machine */
export function publish_machine_monitoring(machine) {
  const node = machine.child('Monitoring.MachineTool.OperationMode');
  machine.published.add(node, DataType.Int32, operation_mode);
}

/** Of an axis by its name or word, as the protocol tells none: those of rotation are A, B and C (DIN 66217). */
const units_of = (/** @type {string} */ word) =>
  /^[ABC]/.test(word) ? standardUnits.degree : standardUnits.millimetre;

/**
 * Position and way to go by the words of programs, and what gives them their meaning: OPC 40501-1 has
 * none of it.
 * @param {Machine} machine
 * @param {Node} node
 * @param {string[]} words
 * @param {(read: (channel: Channel) => Value) => ReadValue} of_channel
 */
function add_situation(machine, node, words, of_channel) {
  const { namespace, published } = machine;
  for (const word of words) {
    const units = units_of(word);
    const position = of_channel((one) => one.position[word]);
    add_quantity(machine, node, `Position${word}`, units, position);
    add_quantity(
      machine,
      node,
      `ToGo${word}`,
      units,
      of_channel((one) => one.to_go?.[word]),
    );
  }
  /** @type {[string, DataType, (channel: Channel) => Value][]} */
  const values = [
    ['Situation', DataType.UInt32, (one) => one.situation],
    ['Units', DataType.String, (one) => one.units],
    ['File', DataType.String, (one) => one.file],
    ['Line', DataType.UInt32, (one) => one.line],
    ['WorkOffset', DataType.String, (one) => one.work_offset],
    ['Tool', DataType.Int32, (one) => one.tool.number],
    ['ToolEdge', DataType.Int32, (one) => one.tool.edge],
  ];
  for (const [name, dataType, read] of values) {
    const options = { browseName: name, componentOf: node, dataType };
    published.add(namespace.addVariable(options), dataType, of_channel(read));
  }
  /** @type {[string, (channel: Channel) => string[]][]} */
  const lists = [
    ['Diameters', (one) => one.diameter],
    ['ActiveCodes', (one) => [...one.g_codes, ...one.m_codes]],
    ['Coolant', (one) => one.coolant],
  ];
  for (const [name, read] of lists) {
    const options = {
      browseName: name,
      componentOf: node,
      dataType: DataType.String,
      valueRank: 1,
    };
    published.add(namespace.addVariable(options), DataType.String, of_channel(read));
  }
}

/**
 * @param {Machine} machine
 * @param {Parts['channels'][number]} channel
 */
export function add_channel(machine, { id, name, words }) {
  const { published } = machine;
  /** @type {(read: (channel: Channel) => Value) => ReadValue} */
  const of_channel = (read) => (view) => {
    const channel = view.channels.find((one) => one.id === id);
    return channel ? read(channel) : null;
  };
  const node = machine.add_element('ChannelMonitoringType', `Channel${id}`, [
    'RapidOverride',
    'ChannelModifiers',
    'ChannelModifiers.BlockSkip',
  ]);
  published.add_constant(node.name, DataType.String, name || `Channel ${id}`);
  published.add(
    node.channelState,
    DataType.Int32,
    of_channel((one) => ChannelState[one.state]),
  );
  published.add(node.channelMode, DataType.Int32, of_channel(channel_mode));
  add_percent(
    machine,
    node.feedOverride,
    feed_range,
    of_channel((one) => one.override.feed),
  );
  add_percent(
    machine,
    node.rapidOverride,
    rapid_range,
    of_channel((one) => one.override.rapid),
  );
  const modifiers = node.channelModifiers;
  // stanok has no dry run on the machine: a program is simulated before it.
  published.add_constant(modifiers.dryRun, DataType.Boolean, false);
  /** @type {[Node, (channel: Channel) => boolean][]} */
  const flags = [
    [modifiers.optionalStop, (one) => one.optional_stop],
    [modifiers.singleStep, (one) => one.single_block],
    [modifiers.blockSkip, (one) => one.block_skip.length > 0],
  ];
  for (const [flag, read] of flags) published.add(flag, DataType.Boolean, of_channel(read));
  add_situation(machine, node, words, of_channel);
}

/**
 * @param {Machine} machine
 * @param {string} name
 */
export function add_axis(machine, name) {
  /** @type {(read: (axis: Axis) => Value) => ReadValue} */
  const of_axis = (read) => (view) => {
    const axis = axis_in(view, name);
    return axis && read(axis);
  };
  const node = machine.add_element(machine.axis_type, `Axis${name}`);
  machine.published.add_constant(node.name, DataType.String, name);
  const units = units_of(name);
  add_quantity(
    machine,
    node,
    'Position',
    units,
    of_axis((axis) => axis.position),
  );
  add_flag(
    machine,
    node,
    'IsEnabled',
    of_axis((axis) => axis.enabled),
  );
  add_flag(
    machine,
    node,
    'IsReferenced',
    of_axis((axis) => axis.verified),
  );
}

/**
 * @param {Machine} machine
 * @param {number} id
 */
export function add_spindle(machine, id) {
  /** @type {(read: (spindle: Spindle) => Value) => ReadValue} */
  const of_spindle = (read) => (view) => {
    const spindle = spindle_in(view, id);
    return spindle && read(spindle);
  };
  const node = machine.add_element('SpindleMonitoringType', `Spindle${id}`, ['Override']);
  machine.published.add_constant(node.name, DataType.String, `S${id}`);
  machine.published.add(node.isRotating, DataType.Boolean, of_spindle(is_rotating));
  add_percent(machine, node.override, spindle_range, (view) => {
    const channel = view.channels.find((one) => one.spindles.some((other) => other.id === id));
    return channel?.override.spindle;
  });
  const units = standardUnits.revolutions_per_minute;
  add_quantity(
    machine,
    node,
    'Speed',
    units,
    of_spindle((one) => one.actual_rev_min),
  );
  add_quantity(
    machine,
    node,
    'CommandedSpeed',
    units,
    of_spindle((one) => one.commanded_rev_min),
  );
}
