// The signals that the scope can record: by name, with unit and limit, and how a cycle tells each.
//
//   X.position .velocity .acceleration .jerk   setpoints of a machine axis (mm or deg, per s^n)
//   X.actual .error                            what its drive reported, and the lag behind it
//   channel1.speed .feed .override .line       along the path of a channel (mm/min, %)
//   channel1.spindle .force .power             n of the master spindle; force control
//   cycle.time .latency                        of the real-time thread (us)
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "daemon/cycle/real_time_loop.h"

namespace stanok::daemon {

// A cycle as the scope sees it.
struct ScopeCycle {
  const channels::CycleOutput& output;
  CycleTimes times;
};

struct ScopeSignal {
  std::string name;
  std::string unit;
  std::optional<double> limit;  // of its size, as the machine file has it
  // Not a number: the cycle does not tell it.
  std::function<double(const ScopeCycle&)> value;
};

[[nodiscard]] std::vector<ScopeSignal> scope_signals(const channels::MachineConfig& machine);

}  // namespace stanok::daemon
