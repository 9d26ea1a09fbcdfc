// Production: the active program, and for each channel what it makes.
//
// stanok has no list of orders: the job of a channel is its program, as often as it was run since
// the daemon started (program.history).
import { DataType } from 'node-opcua';
import { leading_channel, program_state, runs_completed } from './words.js';

export function publish_active_program(machine) {
  const { published } = machine;
  const program = machine.child('Production.ActiveProgram');
  const state_of_leading = (view) => program_state(view, leading_channel(view));
  published.add(program.name, DataType.String, (view) => leading_channel(view).program ?? '');
  published.add(program.numberInList, DataType.UInt16, (view) =>
    view.channels.indexOf(leading_channel(view)),
  );
  machine.add_state(program.state, state_of_leading);
}

export function add_job(machine, { id }, number) {
  const { published } = machine;
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
