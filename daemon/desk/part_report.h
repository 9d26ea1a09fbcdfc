// The virtual workpiece as a program leaves it.
#pragma once

#include "daemon/desk/background_work.h"
#include "runtime/simulation.h"

namespace stanok::daemon {

// Runs the program of `options` on a virtual clock; answers with a picture (program.picture).
[[nodiscard]] BackgroundWork::Work part_after(runtime::SimulationOptions options);

}  // namespace stanok::daemon
