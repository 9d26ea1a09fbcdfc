// Alerts: which conditions are active after what daemons tell, on nodes that only keep what is set.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { StatusCodes } from 'node-opcua';
import { Alerts } from '../source/alerts.js';

/** @import { Alarm, Node, View } from '../types/view.js' */

/** A condition of which is kept whether it is active, and what was raised. */
class Condition {
  is_active = false;
  quality = StatusCodes.Good;
  /** @type {{ message: string, retain: boolean }[]} */
  raised = [];
  errorCode = { setValueFromSource() {} };
  ackedState = { setValue() {} };
  activeState = { getValue: () => this.is_active };

  activateAlarm() {
    this.is_active = true;
  }
  deactivateAlarm() {
    this.is_active = false;
  }
  currentBranch() {
    return {
      getQuality: () => this.quality,
      setQuality: (/** @type {typeof this.quality} */ quality) => (this.quality = quality),
      setRetain() {},
      getMessage: () => '',
    };
  }
  /** @param {{ message: string, retain: boolean }} event */
  raiseNewCondition(event) {
    this.raised.push(event);
  }
}

function machine_with_alerts() {
  /** @type {Condition[]} */
  const conditions = [];
  /** @type {Node} */
  const machine = {
    namespace: {
      instantiateAlarmCondition: () => conditions[conditions.push(new Condition()) - 1],
    },
    type_of: () => null,
    name_of: () => null,
    child: () => null,
  };
  return { conditions, alerts: new Alerts(machine) };
}

/** @type {Alarm} */
const alarm = {
  channel: 1,
  number: 1,
  cycle: 100,
  at: null,
  code: 'E6010',
  text: 'X at its limit',
  file: null,
  line: null,
  column: null,
  reaction: 3,
  remedy: null,
};

/**
 * @param {Alarm[]} alarms
 * @returns {View}
 */
const view_of = (alarms) => /** @type {Node} */ ({ alarms });

test('an alarm is active from its begin to its end', () => {
  const { conditions, alerts } = machine_with_alerts();
  alerts.follow(view_of([alarm]));
  alerts.follow(view_of([alarm]));
  assert.deepEqual(
    conditions.map(({ is_active, raised }) => [is_active, raised.length]),
    [[true, 1]],
  );
  alerts.follow(view_of([]));
  assert.equal(conditions[0].is_active, false);
  assert.equal(conditions[0].raised.at(-1)?.retain, false);
});

test('a daemon that was started anew counts its alarms anew: the same one is active again', () => {
  const { conditions, alerts } = machine_with_alerts();
  alerts.follow(view_of([alarm]));
  alerts.follow(null);
  alerts.follow(view_of([]));
  alerts.follow(view_of([alarm]));
  assert.equal(conditions[0].is_active, true);
  assert.equal(conditions[0].raised.at(-1)?.retain, true);
});

test('what is acknowledged or told otherwise is raised again', () => {
  const { conditions, alerts } = machine_with_alerts();
  alerts.follow(view_of([alarm]));
  alerts.follow(view_of([{ ...alarm, acknowledged: true }]));
  alerts.follow(view_of([{ ...alarm, acknowledged: true, text: 'X beyond its limit' }]));
  assert.equal(conditions.length, 1);
  assert.equal(conditions[0].raised.length, 3);
});

test('while the daemon is away nobody knows', () => {
  const { conditions, alerts } = machine_with_alerts();
  alerts.follow(view_of([alarm]));
  alerts.follow(null);
  assert.equal(conditions[0].quality, StatusCodes.BadNoCommunication);
  assert.equal(conditions[0].is_active, true);
});
