// Writes src/generated/client.ts from openrpc.json: a type of each method's parameters and result, and
// the role that each method wants. A member that the daemon renames is a compile error of the page.
//
// openrpc.json is written by a test of the project: see tests/protocol/contract/discovery_test.cc.
import { readFileSync } from 'node:fs';
import { write } from './written.mjs';

const folder = new URL('..', import.meta.url);
const methods = JSON.parse(readFileSync(new URL('openrpc.json', folder), 'utf8')).methods;

const key = (name) => (/^[A-Za-z_]\w*$/.test(name) ? name : JSON.stringify(name));

function members(schema, indent) {
  const inner = `${indent}  `;
  const required = new Set(schema.required ?? []);
  const lines = Object.entries(schema.properties).map(
    ([name, member]) =>
      `${inner}${key(name)}${required.has(name) ? '' : '?'}: ${type(member, inner)};`,
  );
  return lines.length === 0 ? 'Record<string, never>' : `{\n${lines.join('\n')}\n${indent}}`;
}

function type(schema, indent = '') {
  if (schema.anyOf) return schema.anyOf.map((one) => type(one, indent)).join(' | ');
  if (schema.oneOf) return schema.oneOf.map((one) => type(one, indent)).join(' | ');
  if (schema.enum) return schema.enum.map((value) => JSON.stringify(value)).join(' | ');
  switch (schema.type) {
    case 'integer':
    case 'number':
      return 'number';
    case 'string':
      return 'string';
    case 'boolean':
      return 'boolean';
    case 'null':
      return 'null';
    case 'array': {
      const item = schema.items ? type(schema.items, indent) : 'unknown';
      return item.includes('|') ? `(${item})[]` : `${item}[]`;
    }
    case 'object':
      if (schema.properties) return members(schema, indent);
      if (schema.additionalProperties)
        return `Record<string, ${type(schema.additionalProperties, indent)}>`;
      return 'Record<string, unknown>';
    default:
      return 'unknown';
  }
}

function parameters(method) {
  const schema = { properties: {}, required: [] };
  for (const one of method.params) {
    schema.properties[one.name] = one.schema;
    if (one.required) schema.required.push(one.name);
  }
  return members(schema, '    ');
}

const roles = methods.map((method) => `  ${key(method.name)}: '${method['x-role']}',`);
const aged = methods.filter((method) => method.params.some((one) => one.name === 'seen_cycle'));
const stops = methods.filter((method) => method['x-effect'] === 'stops');
const list = (some) => some.map((method) => `  '${method.name}',`).join('\n');
const types = methods.map(
  (method) =>
    `  /** ${method.summary.replaceAll('*/', '')} */\n  ${key(method.name)}: {\n    params: ${parameters(method)};\n` +
    `    result: ${type(method.result.schema, '    ')};\n  };`,
);

write(
  new URL('src/generated/client.ts', folder),
  `// Made from openrpc.json by tools/client.mjs: do not change it by hand.

export interface Methods {
${types.join('\n')}
}

export type MethodName = keyof Methods;

/** The role that each method wants. */
export const method_roles: Record<MethodName, string> = {
${roles.join('\n')}
};

/** What begins motion, and says what was seen when it was asked for. */
export const aged_methods: readonly string[] = [
${list(aged)}
];

/** What only ever brings motion to rest. */
export const stop_methods: readonly string[] = [
${list(stops)}
];
`,
);
