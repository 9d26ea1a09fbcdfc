// Server: endpoints, certificates, users and bounds of OPC UA, and the machines behind them.
import { mkdirSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import './web_crypto.js';
import {
  MessageSecurityMode,
  OPCUACertificateManager,
  OPCUAServer,
  RegisterServerMethod,
  SecurityPolicy,
} from 'node-opcua';
import { refuse_methods_of_types } from './alerts.js';
import { Daemon } from './daemon.js';
import { identities_from } from './identification.js';
import { Logins } from './logins.js';
import { Machine, add_axis_type } from './machine.js';
import { namespaces, nodeset_files } from './namespaces.js';
import { is_loopback } from './options.js';
import { users_from } from './users.js';

/**
 * @import { Namespace, RunningServer, ServerOptions, Users } from '../types/view.js'
 * @import { OPCUAServerOptions, UserManagerOptions } from 'node-opcua'
 */

const policies = [
  SecurityPolicy.Basic256Sha256,
  SecurityPolicy.Aes128_Sha256_RsaOaep,
  SecurityPolicy.Aes256_Sha256_RsaPss,
];

// Of every server of this kind (OPC 10000-5, BuildInfo).
const product_uri = 'urn:stanok:opcua';

/**
 * Without security on this computer only; otherwise at least signed, and never without a user.
 * @param {ServerOptions} options
 */
function endpoint_of({ host, port, users }) {
  const is_open = is_loopback(host);
  const modes = [MessageSecurityMode.Sign, MessageSecurityMode.SignAndEncrypt];
  return {
    host,
    hostname: host,
    port,
    allowAnonymous: is_open && !users,
    securityPolicies: is_open ? [SecurityPolicy.None, ...policies] : policies,
    securityModes: is_open ? [MessageSecurityMode.None, ...modes] : modes,
  };
}

/**
 * Far more than a cell needs, far less than what this process could not bear.
 * @param {ServerOptions} options
 */
function capabilities_of({ sessions }) {
  return {
    maxSessions: sessions,
    maxSubscriptions: 5 * sessions,
    maxSubscriptionsPerSession: 10,
    maxMonitoredItems: 5000 * sessions,
    maxMonitoredItemsPerSubscription: 5000,
    maxMonitoredItemsQueueSize: 1000,
    minSupportedSampleRate: 100,
    operationLimits: {
      maxNodesPerRead: 5000,
      maxNodesPerBrowse: 2000,
      maxMonitoredItemsPerCall: 5000,
      maxNodesPerTranslateBrowsePathsToNodeIds: 2000,
    },
  };
}

/**
 * @param {Users | undefined} users
 * @returns {UserManagerOptions}
 */
function user_manager(users) {
  if (!users) return { isValidUser: () => false };
  const logins = new Logins(users);
  return {
    isValidUserAsync(name, password, done) {
      logins.is_admitted(name, password, this.channel?.remoteAddress ?? '').then(
        (is_admitted) => done(null, is_admitted),
        (fault) => done(fault),
      );
    },
  };
}

/** @param {string} folder */
function certificates_in(folder) {
  // A client is let in when its certificate has been moved from rejected/ to trusted/certs.
  return new OPCUACertificateManager({
    rootFolder: folder,
    automaticallyAcceptUnknownCertificate: false,
  });
}

/**
 * @param {ServerOptions} options
 * @param {string} version
 */
async function server_of(options, version) {
  mkdirSync(options.state, { recursive: true, mode: 0o700 });
  const serverCertificateManager = certificates_in(join(options.state, 'pki'));
  const userCertificateManager = certificates_in(join(options.state, 'users'));
  await serverCertificateManager.initialize();
  await userCertificateManager.initialize();
  return new OPCUAServer({
    ...endpoint_of(options),
    serverCertificateManager,
    userCertificateManager,
    nodesets: nodeset_files,
    userManager: user_manager(options.users ? users_from(options.users) : undefined),
    serverCapabilities: capabilities_of(options),
    maxConnectionsPerEndpoint: options.sessions + 5,
    registerServerMethod: RegisterServerMethod.HIDDEN,
    // No other server in the world has it (OPC 10000-4, ApplicationDescription).
    serverInfo: {
      applicationUri: `urn:${hostname()}:stanok:opcua`,
      productUri: product_uri,
      applicationName: { text: 'stanok' },
    },
    buildInfo: {
      productUri: product_uri,
      productName: 'stanok-opcua',
      softwareVersion: version,
      manufacturerName: 'stanok',
    },
  });
}

/**
 * Of a server that listens.
 * @param {ServerOptions} options
 * @param {string} version
 * @returns {Promise<RunningServer>}
 */
export async function start_server(options, version) {
  const identities = identities_from(
    options.identity,
    options.machines.map(({ name }) => name),
  );
  const server = await server_of(options, version);
  await server.initialize();
  const { addressSpace } = server.engine;
  if (!addressSpace) throw new Error('node-opcua did not create an address space');
  const namespace = /** @type {Namespace} */ (addressSpace.registerNamespace(namespaces.stanok));
  const axis_type = add_axis_type(addressSpace, namespace);
  addressSpace.installAlarmsAndConditionsService();
  refuse_methods_of_types(addressSpace);
  const daemons = options.machines.map((address) => {
    const identity = identities[address.name] ?? {};
    const machine = new Machine(addressSpace, namespace, axis_type, address.name, identity);
    return new Daemon(address, options.rate_hz, (view) => machine.show(view));
  });
  await server.start();
  for (const daemon of daemons) daemon.start();
  const { port } = server.endpoints[0];
  const host = options.host.includes(':') ? `[${options.host}]` : options.host;
  return {
    address: `opc.tcp://${host}:${port}`,
    stop: async () => {
      for (const daemon of daemons) daemon.stop();
      await server.shutdown(0);
    },
  };
}
