// Identification: what the daemon knows of itself, and what --identity says of the machine.
import { DataType } from 'node-opcua';
import { readFileSync } from 'node:fs';

/**
 * @import { Identity, Node } from '../types/view.js'
 * @import { Machine } from './machine.js'
 */

const text = DataType.LocalizedText;
// Members of the file by the names of OPC 40001-1.
/** @type {Record<string, DataType>} */
const types = {
  Manufacturer: text,
  ManufacturerUri: DataType.String,
  SerialNumber: DataType.String,
  ProductInstanceUri: DataType.String,
  ProductCode: DataType.String,
  HardwareRevision: DataType.String,
  DeviceClass: DataType.String,
  Location: DataType.String,
  AssetId: DataType.String,
  YearOfConstruction: DataType.UInt16,
  MonthOfConstruction: DataType.Byte,
};
/** @type {Record<string, [number, number]>} */
const ranges = { YearOfConstruction: [1, 65535], MonthOfConstruction: [1, 12] };

/**
 * By the names of machines. Throws Error.
 * @param {string | undefined} file
 * @param {string[]} names
 * @returns {Record<string, Identity>}
 */
export function identities_from(file, names) {
  if (!file) return {};
  const all = json_object(
    read_json(file),
    `${file} must be a JSON object with a member for each machine`,
  );
  for (const [name, members] of Object.entries(all)) {
    if (!names.includes(name)) throw new Error(`${file}: no machine has the name ${name}`);
    const described = json_object(members, `${file}: ${name} must be an object`);
    for (const [member, value] of Object.entries(described)) {
      const wrong = fault_of(member, value);
      if (wrong) throw new Error(`${file}: ${name}.${member} ${wrong}`);
    }
  }
  return /** @type {Record<string, Identity>} */ (all);
}

/** @param {string} file */
function read_json(file) {
  const text = readFileSync(file, 'utf8');
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(`${file}: this is not JSON: ${error instanceof Error ? error.message : error}`);
  }
}

/**
 * @param {unknown} value
 * @param {string} fault
 * @returns {object}
 */
function json_object(value, fault) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) throw new Error(fault);
  return value;
}

/**
 * What is wrong with a member; empty: nothing.
 * @param {string} member
 * @param {unknown} value
 */
function fault_of(member, value) {
  if (!Object.hasOwn(types, member))
    return `is not known; write one of ${Object.keys(types).join(', ')}`;
  const range = ranges[member];
  if (!range) return typeof value === 'string' ? '' : 'must be a string';
  const [smallest, largest] = range;
  const is_good = Number.isInteger(value) && Number(value) >= smallest && Number(value) <= largest;
  return is_good ? '' : `must be a whole number from ${smallest} to ${largest}`;
}

/**
 * @param {Machine} machine
 * @param {Identity} identity
 */
export function publish_identification(machine, identity) {
  const { published } = machine;
  // Mandatory ones: a machine that nobody has described says so by its values.
  /** @type {Identity} */
  const members = {
    Manufacturer: 'unknown',
    SerialNumber: 'unknown',
    ProductInstanceUri: `urn:stanok:machine:${machine.name}`,
    ...identity,
  };
  for (const [name, value] of Object.entries(members)) {
    const type = types[name];
    const content = type === text ? { text: value } : value;
    published.add_constant(machine.child(`Identification.${name}`), type, content);
  }
  const child = (/** @type {string} */ name) => machine.child(`Identification.${name}`);
  published.add_constant(child('ComponentName'), text, { text: machine.name });
  published.add(child('Model'), text, (view) => ({ text: view.machine.name }));
  published.add(child('SoftwareRevision'), DataType.String, (view) => view.info.version);
  add_software(machine, child('SoftwareIdentification'));
}

/**
 * @param {Machine} machine
 * @param {Node} folder
 */
function add_software(machine, folder) {
  const item = machine.make('SoftwareIdentificationType', {
    browseName: machine.name_of('Control'),
    componentOf: folder,
    optionals: [],
  });
  machine.published.add(item.identifier, DataType.String, (view) => view.info.server);
  machine.published.add(item.softwareRevision, DataType.String, (view) => view.info.version);
}
