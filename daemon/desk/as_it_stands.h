// The machine as it stands, for what is run ahead of it on a virtual clock: tables, schemes and
// places of axes of now, ideal drives.
#pragma once

#include "daemon/cycle/running_machine.h"
#include "runtime/simulation.h"

namespace stanok::daemon {

// Machine time after which such a run is given up.
inline constexpr double time_ahead_max_s = 48.0 * 3600.0;

[[nodiscard]] runtime::SimulationOptions simulation_as_it_stands(RunningMachine& machine);

}  // namespace stanok::daemon
