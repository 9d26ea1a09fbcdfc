// Published: the variables of one machine and where each value comes from.
//
// With every view each value is computed anew; what changed is set. While the daemon is away, all of
// them are Bad (BadNoCommunication): nobody takes an old position for a new one. A value that the
// machine does not have (null) is BadNoData.
import { DataType, StatusCodes, VariantArrayType } from 'node-opcua';

/**
 * @import { DateTime, StatusCode } from 'node-opcua'
 * @import { Node, ReadValue, Value, View } from '../types/view.js'
 * @typedef {{
 *   variable: Node,
 *   data_type: DataType,
 *   read: ReadValue,
 *   is_array: boolean,
 *   text?: string,
 * }} PublishedValue
 */

/** @type {Partial<Record<DataType, unknown>>} */
const empty = {
  [DataType.Boolean]: false,
  [DataType.String]: '',
  [DataType.LocalizedText]: { text: '' },
  [DataType.DateTime]: new Date(0),
};

export class Published {
  /** @type {PublishedValue[]} */
  #all = [];
  /** @type {View | null} */
  #view = null;
  #has_been_met = false;

  /**
   * `read(view)` gives the value, null where there is none.
   * @param {Node} variable
   * @param {DataType} data_type
   * @param {ReadValue} read
   */
  add(variable, data_type, read) {
    const published = { variable, data_type, read, is_array: variable.valueRank === 1 };
    variable.accessLevel = variable.userAccessLevel = 1; // CurrentRead
    this.#all.push(published);
    this.#set(published, new Date());
  }

  /**
   * A value that stays as it is while the machine is what it is.
   * @param {Node} variable
   * @param {DataType} data_type
   * @param {Value} value
   */
  add_constant(variable, data_type, value) {
    this.add(variable, data_type, () => value);
  }

  /**
   * What has been published of nodes that go is not set any more.
   * @param {(node: Node) => boolean} is_gone
   */
  forget(is_gone) {
    this.#all = this.#all.filter(({ variable }) => !is_gone(variable));
  }

  /** @param {View | null} view */
  set_all(view) {
    this.#view = view;
    this.#has_been_met ||= view !== null;
    const now = new Date();
    for (const published of this.#all) this.#set(published, now);
  }

  /**
   * @param {PublishedValue} published
   * @param {Date} now
   */
  #set(published, now) {
    const value = this.#view && (published.read(this.#view) ?? null);
    const status = this.#status(value);
    const text = `${status.value} ${JSON.stringify(value)}`;
    if (text === published.text) return;
    published.text = text;
    const { data_type, is_array } = published;
    const nothing = is_array ? [] : (empty[data_type] ?? 0);
    const arrayType = is_array ? VariantArrayType.Array : VariantArrayType.Scalar;
    const content = { dataType: data_type, arrayType, value: value ?? nothing };
    published.variable.setValueFromSource(content, status, now);
  }

  /**
   * @param {Value} value
   * @returns {StatusCode}
   */
  #status(value) {
    if (value !== null) return StatusCodes.Good;
    if (this.#view) return StatusCodes.BadNoData;
    return this.#has_been_met
      ? StatusCodes.BadNoCommunication
      : StatusCodes.BadWaitingForInitialData;
  }
}
