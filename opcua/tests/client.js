// A client of OPC UA for the tests: reads commands as lines of JSON, prints an answer to each.
//
// usage: client.js ADDRESS PKI_FOLDER MODE [USER PASSWORD]      MODE: None, Sign or SignAndEncrypt
// commands: {"tree": NODE} {"write": NODE} {"call": [OBJECT, METHOD, TYPE]} {"listen": NODE} {"events": 0}
// {"refresh": 0} {"endpoints": 0}. The first line printed is {"ok": true} or {"error": TEXT}.
import { createInterface } from 'node:readline';
import '../source/web_crypto.js';
import {
  AttributeIds,
  DataType,
  MessageSecurityMode,
  NodeClass,
  OPCUACertificateManager,
  OPCUAClient,
  SecurityPolicy,
  TimestampsToReturn,
  UserTokenType,
  constructEventFilter,
} from 'node-opcua';

/**
 * @import {
 *   ClientSession,
 *   ClientSubscription,
 *   NodeId,
 *   ReferenceDescription,
 *   UserIdentityInfo,
 *   Variant,
 * } from 'node-opcua'
 */

const [address, pki, mode, user, password] = process.argv.slice(2);
const event_fields = ['EventType', 'SourceName', 'Message', 'Severity', 'ConditionName', 'Retain'];
const state_fields = ['ActiveState.Id', 'AckedState.Id', 'Quality'];

/** @param {Variant} variant */
function plain(variant) {
  const { value } = variant;
  if (value === null || value === undefined) return value ?? null;
  if (variant.dataType === DataType.LocalizedText) return value.text ?? '';
  if (variant.dataType === DataType.NodeId || variant.dataType === DataType.QualifiedName)
    return value.toString();
  if (variant.dataType === DataType.StatusCode) return value.name;
  return value;
}

/**
 * @param {ClientSession} session
 * @param {ReferenceDescription} reference
 * @param {string[]} namespaces
 */
async function described(session, reference, namespaces) {
  const { nodeId, nodeClass, browseName, typeDefinition } = reference;
  const named = (/** @type {NodeId} */ id) => ({
    uri: namespaces[id.namespace],
    id: id.toString().replace(/^ns=\d+;/, ''),
  });
  const node = {
    node: nodeId.toString(),
    class: NodeClass[nodeClass],
    uri: namespaces[browseName.namespaceIndex],
    type: named(typeDefinition),
  };
  if (nodeClass !== NodeClass.Variable) return node;
  const attributes = [AttributeIds.Value, AttributeIds.DataType, AttributeIds.AccessLevel];
  const [value, data_type, access] = await session.read(
    attributes.map((attributeId) => ({ nodeId, attributeId })),
  );
  return {
    ...node,
    value: plain(value.value),
    status: value.statusCode.name,
    data_type: named(data_type.value.value),
    access: access.value.value,
  };
}

/**
 * @param {ClientSession} session
 * @param {string} root
 */
async function tree(session, root) {
  const namespaces = await session.readNamespaceArray();
  /** @type {Record<string, unknown>} */
  const found = {};
  /** @type {(nodeId: string | NodeId, path: string) => Promise<void>} */
  const walk = async (nodeId, path) => {
    const { references } = await session.browse({
      nodeId,
      referenceTypeId: 'Aggregates',
      includeSubtypes: true,
      browseDirection: 0,
      resultMask: 63,
    });
    for (const reference of references ?? []) {
      const name = reference.browseName.name ?? '';
      const here = path ? `${path}/${name}` : name;
      found[here] = await described(session, reference, namespaces);
      if (reference.nodeClass !== NodeClass.Method) await walk(reference.nodeId, here);
    }
  };
  await walk(root, '');
  return found;
}

/** @type {unknown[]} */
const events = [];
/** @type {ClientSubscription | undefined} */
let subscription;

/**
 * @param {ClientSession} session
 * @param {string} nodeId
 */
async function listen(session, nodeId) {
  subscription = await session.createSubscription2({
    requestedPublishingInterval: 100,
    requestedLifetimeCount: 600,
    requestedMaxKeepAliveCount: 10,
    publishingEnabled: true,
  });
  const fields = [...event_fields, ...state_fields, 'ErrorCode'];
  const filter = constructEventFilter(
    fields.map((name) => (name === 'ErrorCode' ? '7:ErrorCode' : name)),
  );
  const item = await subscription.monitor(
    { nodeId, attributeId: AttributeIds.EventNotifier },
    { samplingInterval: 0, filter, queueSize: 1000, discardOldest: true },
    TimestampsToReturn.Both,
  );
  item.on('changed', (/** @type {any} */ values) => {
    events.push(Object.fromEntries(fields.map((name, k) => [name, plain(values[k])])));
  });
  return item.statusCode.name;
}

/** @type {Record<string, (session: ClientSession, parameter: any) => Promise<unknown>>} */
const actions = {
  tree,
  listen,
  events: async () => events.splice(0),
  write: async (session, nodeId) => {
    const value = { value: { dataType: DataType.Double, value: 1 } };
    return (await session.write({ nodeId, attributeId: AttributeIds.Value, value })).name;
  },
  call: async (session, [objectId, methodId, inputArguments]) =>
    (await session.call({ objectId, methodId, inputArguments })).statusCode.name,
  refresh: async (session) => {
    const call = {
      objectId: 'i=2782',
      methodId: 'i=3875',
      inputArguments: [{ dataType: DataType.UInt32, value: subscription?.subscriptionId }],
    };
    return (await session.call(call)).statusCode.name;
  },
};

async function main() {
  const clientCertificateManager = new OPCUACertificateManager({
    rootFolder: pki,
    automaticallyAcceptUnknownCertificate: true,
  });
  await clientCertificateManager.initialize();
  const client = OPCUAClient.create({
    clientCertificateManager,
    endpointMustExist: false,
    securityMode: MessageSecurityMode[/** @type {keyof typeof MessageSecurityMode} */ (mode)],
    securityPolicy: mode === 'None' ? SecurityPolicy.None : SecurityPolicy.Basic256Sha256,
    connectionStrategy: { maxRetry: 0 },
  });
  const answer = (/** @type {unknown} */ value) =>
    process.stdout.write(JSON.stringify(value) + '\n');
  await client.connect(address);
  const endpoints = (await client.getEndpoints()).map((one) => ({
    mode: MessageSecurityMode[one.securityMode],
    tokens: (one.userIdentityTokens ?? []).map((token) => UserTokenType[token.tokenType]),
  }));
  /** @type {UserIdentityInfo} */
  const identity = user
    ? { type: UserTokenType.UserName, userName: user, password }
    : { type: UserTokenType.Anonymous };
  const session = await client.createSession(identity);
  answer({ ok: true });
  for await (const line of createInterface({ input: process.stdin })) {
    const [[name, parameter]] = Object.entries(JSON.parse(line));
    if (name === 'endpoints') answer(endpoints);
    else answer(await actions[name](session, parameter));
  }
  await session.close();
  await client.disconnect();
}

main().then(
  () => process.exit(0),
  (error) => {
    process.stdout.write(JSON.stringify({ error: error.message }) + '\n');
    process.exit(1);
  },
);
