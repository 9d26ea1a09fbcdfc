// Identification: what the daemon knows of itself, and what --identity says of the machine.
import { DataType } from 'node-opcua';
import { readFileSync } from 'node:fs';

const text = DataType.LocalizedText;
// Members of the file by the names of OPC 40001-1.
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
const numbers = [DataType.UInt16, DataType.Byte];

/** {machine: {member: value}}. Throws Error. */
export function identities_from(file, names) {
  if (!file) return {};
  const all = JSON.parse(readFileSync(file, 'utf8'));
  for (const [name, members] of Object.entries(all)) {
    if (!names.includes(name)) throw new Error(`${file}: no machine is called ${name}`);
    for (const [member, value] of Object.entries(members)) {
      const type = types[member];
      if (type === undefined)
        throw new Error(
          `${file}: ${name}.${member} is not known; ${Object.keys(types).join(', ')} are`,
        );
      const wanted = numbers.includes(type) ? 'number' : 'string';
      if (typeof value !== wanted)
        throw new Error(`${file}: ${name}.${member} must be a ${wanted}`);
    }
  }
  return all;
}

export function publish_identification(machine, identity) {
  const { published } = machine;
  // Mandatory ones: a machine that nobody has described says so by its values.
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
  const child = (name) => machine.child(`Identification.${name}`);
  published.add_constant(child('ComponentName'), text, { text: machine.name });
  published.add(child('Model'), text, (view) => ({ text: view.machine.name }));
  published.add(child('SoftwareRevision'), DataType.String, (view) => view.info.version);
  add_software(machine, child('SoftwareIdentification'));
}

function add_software(machine, folder) {
  const item = machine.make('SoftwareIdentificationType', {
    browseName: machine.name_of('Control'),
    componentOf: folder,
    optionals: [],
  });
  machine.published.add(item.identifier, DataType.String, (view) => view.info.server);
  machine.published.add(item.softwareRevision, DataType.String, (view) => view.info.version);
}
