#include "daemon/desk/as_it_stands.h"

#include "runtime/axis_positions.h"

namespace stanok::daemon {

runtime::SimulationOptions simulation_as_it_stands(RunningMachine& machine) {
  const auto output = machine.newest_output();
  runtime::SimulationOptions options;
  options.file = machine.file();
  options.file.machine.tables = machine.tables();
  const auto places = runtime::positions_of_axes(options.file.machine, output);
  for (std::size_t k = 0; k < places.size(); ++k) options.file.machine.axes[k].start = places[k];
  for (const channels::ChannelOutput& one : output.of_channels()) {
    if (one.scheme != 0) options.schemes.emplace_back(one.id, one.scheme);
  }
  options.program_roots = machine.program_roots();
  return options;
}

}  // namespace stanok::daemon
