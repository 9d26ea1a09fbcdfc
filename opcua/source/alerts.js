// Notification: active alarms as conditions of AlertType.
//
// A condition is a code of a channel: it becomes active with the alarm and inactive with its end.
// Acknowledged is what is acknowledged at the machine; who wants to do so from elsewhere does it by
// the protocol of stanok and its roles, so all methods of a condition are refused here.
import { DataType, NodeId, StatusCodes } from 'node-opcua';

/**
 * @import { MethodFunctor, StatusCode } from 'node-opcua'
 * @import { AddressSpace, Alarm, Node, View } from '../types/view.js'
 * @import { Machine } from './machine.js'
 * @typedef {{ condition: Node, text: string }} Condition
 */

const conditions_max = 500;
const refused_methods = ['acknowledge', 'addComment', 'enable', 'disable', 'confirm'];
const severity = 800; // OPC 10000-5, 6.4.2: 667 to 1000 is high
const severity_warning = 400;
const warning_reaction = 1; // of the catalogue: tells, and stops nothing

/** @type {MethodFunctor} */
const refuse = (_arguments, _context, done) =>
  done(null, { statusCode: StatusCodes.BadUserAccessDenied });

/**
 * Methods may be called by those of the types (OPC 10000-9, 5.5 and 5.7), too.
 * @param {AddressSpace} addressSpace
 */
export function refuse_methods_of_types(addressSpace) {
  /** @type {Node} */
  const conditions = addressSpace.findEventType('ConditionType');
  /** @type {Node} */
  const acknowledgeable = addressSpace.findEventType('AcknowledgeableConditionType');
  for (const type of [conditions, acknowledgeable])
    for (const name of refused_methods) type[name]?.bindMethod(refuse);
}

/** @param {Alarm} alarm */
const key_of = ({ channel, code }) => `Channel${channel}${code}`;

export class Alerts {
  #machine;
  /** @type {Map<string, Condition>} */
  #conditions = new Map();

  /** @param {Machine} machine */
  constructor(machine) {
    this.#machine = machine;
  }

  /**
   * `view` null: nobody knows; the conditions stay and say so by their quality.
   * @param {View | null} view
   */
  follow(view) {
    if (!view) return this.#set_quality(StatusCodes.BadNoCommunication);
    this.#set_quality(StatusCodes.Good);
    const active = new Map(view.alarms.map((alarm) => [key_of(alarm), alarm]));
    for (const [key, known] of this.#conditions)
      if (!active.has(key) && known.condition.activeState.getValue()) this.#end(known);
    for (const [key, alarm] of active) this.#show(key, alarm);
  }

  /** @param {StatusCode} status */
  #set_quality(status) {
    for (const { condition } of this.#conditions.values()) {
      const branch = condition.currentBranch();
      if (branch.getQuality().value !== status.value) branch.setQuality(status);
    }
  }

  /** @param {Condition} known */
  #end(known) {
    const { condition } = known;
    known.text = ''; // the next one may have the same number: a daemon counts from its start
    condition.deactivateAlarm();
    condition.currentBranch().setRetain(false);
    condition.raiseNewCondition({
      severity: 0,
      message: condition.currentBranch().getMessage(),
      retain: false,
    });
  }

  /**
   * @param {string} key
   * @param {Alarm} alarm
   */
  #show(key, alarm) {
    const known = this.#conditions.get(key) ?? this.#add(key, alarm);
    const text = JSON.stringify([alarm.number, alarm.acknowledged ?? false, alarm.text]);
    if (!known || known.text === text) return;
    known.text = text;
    const { condition } = known;
    condition.activateAlarm();
    condition.ackedState.setValue(alarm.acknowledged ?? false);
    condition.raiseNewCondition({
      message: alarm.text,
      severity: alarm.reaction === warning_reaction ? severity_warning : severity,
      quality: StatusCodes.Good,
      retain: true,
    });
  }

  /**
   * @param {string} key
   * @param {Alarm} alarm
   * @returns {Condition | undefined}
   */
  #add(key, { code }) {
    if (this.#conditions.size >= conditions_max) return undefined;
    const machine = this.#machine;
    /** @type {Node} */
    const condition = machine.namespace.instantiateAlarmCondition(machine.type_of('AlertType'), {
      browseName: machine.name_of(key),
      componentOf: machine.child('Notification.Messages'),
      conditionSource: machine.child('Notification'),
      conditionOf: machine.child('Notification'),
      conditionName: key,
      inputNode: NodeId.nullNodeId,
      optionals: [],
    });
    condition.errorCode.setValueFromSource({ dataType: DataType.String, value: code });
    const known = { condition, text: '' };
    this.#conditions.set(key, known);
    for (const name of refused_methods) condition[name]?.bindMethod(refuse);
    return known;
  }
}
