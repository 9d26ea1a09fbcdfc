// Production: the active program, and for each channel what it makes.
//
// stanok has no list of orders: the job of a channel is its program, as often as it was run since
// the daemon started (program.history).
import { DataType } from 'node-opcua';
import { leading_channel, program_state, runs_completed } from './words.js';

/**
 * @import { Channel, View } from '../types/view.js'
 * @import { Machine } from './machine.js'
 */

/** @param {Machine} machine */
export function publish_active_program(machine) {
  const { published } = machine;
  const program = machine.child('Production.ActiveProgram');
  /**
   * @template Value
   * @param {(view: View, channel: Channel) => Value} read
   * @returns {(view: View) => Value | null}
   */
  const of_leading = (read) => (view) => {
    const channel = leading_channel(view);
    return channel ? read(view, channel) : null;
  };
  published.add(
    program.name,
    DataType.String,
    of_leading((_, one) => one.program ?? ''),
  );
  published.add(
    program.numberInList,
    DataType.UInt16,
    of_leading((view, one) => view.channels.indexOf(one)),
  );
  machine.add_state(program.state, of_leading(program_state));
}

/**
 * @param {Machine} machine
 * @param {Pick<Channel, 'id'>} channel
 * @param {number} number
 */
export function add_job(machine, { id }, number) {
  const { published } = machine;
  /**
   * @template Value
   * @param {(view: View, channel: Channel) => Value} read
   * @returns {(view: View) => Value | null}
   */
  const of_channel = (read) => (view) => {
    const channel = view.channels.find((one) => one.id === id);
    return channel ? read(view, channel) : null;
  };
  const job = machine.make('ProductionJobType', {
    browseName: machine.name_of(`Channel${id}`),
    componentOf: machine.child('Production.ProductionPlan'),
    optionals: [],
  });
  machine.added.push(job);
  published.add_constant(job.numberInList, DataType.UInt16, number);
  published.add(
    job.identifier,
    DataType.String,
    of_channel((_, one) => `${id}: ${one.program ?? ''}`),
  );
  published.add(job.runsCompleted, DataType.UInt32, of_channel(runs_completed));
  published.add_constant(job.runsPlanned, DataType.UInt32, 0);
  published.add_constant(job.runsPlanned.isValid, DataType.Boolean, false);
  machine.add_state(job.state, of_channel(program_state));
  const program = machine.make('ProductionProgramType', {
    browseName: machine.name_of('Program1'),
    componentOf: job.productionPrograms,
    optionals: ['State'],
  });
  published.add(
    program.name,
    DataType.String,
    of_channel((_, one) => one.program ?? ''),
  );
  published.add_constant(program.numberInList, DataType.UInt16, 0);
  machine.add_state(program.state, of_channel(program_state));
}
