// The Web Crypto API as a global object, where node-opcua looks for it: Node 18 of Debian has it only as a module.
// To be imported before node-opcua.
import { webcrypto } from 'node:crypto';

globalThis.crypto ??= /** @type {Crypto} */ (webcrypto);
