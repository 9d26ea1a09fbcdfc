// Types for the check of the sources (tsc); nothing of this is there when the program runs.
//
// What daemons answer comes from the same list of methods from which the client of the page is made:
// a member that the protocol does not have is found before anything runs.
import type { IAddressSpace, INamespace } from 'node-opcua';
import type { Methods } from '../../panel/src/generated/client.js';

export type Method = keyof Methods;
export type Result<Name extends Method> = Methods[Name]['result'];
export type Parameters<Name extends Method> = Methods[Name]['params'];

export type MachineStatus = Result<'machine.status'>;
export type Channel = Result<'channel.status'>;
export type Axis = Channel['axes'][string];
export type Spindle = Channel['spindles'][number];
export type Alarm = Result<'alarm.list'>['alarms'][number];
export type Run = Result<'program.history'>['runs'][number];
export type Tool = Result<'tool.list'>['tools'][number];

/** What is read now and then, beside the states that the daemon tells. */
export interface Lists {
  tools: Tool[];
  alarms: Alarm[];
  runs: Run[];
}

/** All that is known of a machine at a time. */
export interface View extends Lists {
  info: Result<'system.info'>;
  machine: MachineStatus;
  channels: Channel[];
}

/** What a machine is made of. */
export interface Parts {
  channels: Pick<Channel, 'id' | 'name' | 'words'>[];
  axes: string[];
  spindles: number[];
}

/**
 * A node of the address space. Its children are members that its companion specification names, and
 * node-opcua has types for none of these.
 */
export type Node = any;

/** A value of a node: what a Variant of its data type takes; null: there is none. */
export type Value = unknown;
export type ReadValue = (view: View) => Value;
export type ReadState = (view: View) => string | null;

export interface Address {
  name: string;
  socket: string;
}

/** Members of Identification by their names. */
export type Identity = Record<string, string | number>;

export interface User {
  salt: Buffer;
  hash: Buffer;
}
export type Users = Map<string, User>;

export interface ServerOptions {
  machines: Address[];
  host: string;
  port: number;
  users?: string;
  identity?: string;
  rate_hz: number;
  sessions: number;
  state: string;
}

/** What the command line asks for: to print something, or to serve. */
export type Wanted =
  | { kind: 'help' }
  | { kind: 'version' }
  | { kind: 'user'; name: string }
  | { kind: 'server'; options: ServerOptions };

export interface RunningServer {
  address: string;
  stop(): Promise<void>;
}

/** As it is when the service of alarms and conditions is installed, of which the declarations do not tell. */
export interface Namespace extends INamespace {
  instantiateAlarmCondition(type: Node, options: object): Node;
}
export type AddressSpace = IAddressSpace;
