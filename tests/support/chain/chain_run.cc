#include "tests/support/chain/chain_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "base/catalogue.h"
#include "jobs/dry_run/dry_run.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {
namespace {

constexpr const char* name = "chain.nc";
constexpr int cycles_max = 20000000;         // of a program; 5.5 hours of machine time
constexpr double rounding = 1e-6;            // of a limit
constexpr double event_probability = 0.003;  // a cycle

// Codes of faults of our own: no program may raise them.
bool is_own_fault(const std::string& code) {
  return code == "A9001" || code == "A9002" || code == "A2003" ||
         find_in_catalogue(code) == nullptr;
}

std::string beyond(const channels::CycleOutput& output, const channels::MachineConfig& machine) {
  const channels::ChannelOutput& channel = output.channels[0];
  for (std::size_t k = 0; k < machine.axes.size(); ++k) {
    const motion::AxisLimits& limits = machine.axes[k].limits;
    const channels::AxisSetpoint& axis = channel.axes[k];
    if (channel.drives[k].follows_velocity) continue;  // a spindle
    const std::array<std::array<double, 2>, 3> rates{{{axis.velocity, limits.velocity_max},
                                                      {axis.acceleration, limits.acceleration_max},
                                                      {axis.jerk, limits.jerk_max}}};
    for (std::size_t n = 0; n < rates.size(); ++n) {
      const auto& [value, limit] = rates[n];
      if (!(std::abs(value) <= limit * (1.0 + rounding))) {
        return "axis " + machine.axes[k].name + ", derivative " + std::to_string(n + 1) + ": " +
               std::to_string(value) + " of " + std::to_string(limit) + " at line " +
               std::to_string(channel.tag.line);
      }
    }
    if (!(axis.position >= limits.position_min - 1e-9 &&
          axis.position <= limits.position_max + 1e-9))
      return "axis " + machine.axes[k].name + " at " + std::to_string(axis.position);
  }
  return "";
}

// An operator without rest; what is held goes on some time.
void operate(MachineBench& bench, Choices& choices) {
  using Action = channels::OperatorAction;
  if (bench.channel(1).state == channels::ChannelState::held) {
    if (choices.chance(0.02)) bench.ask(Action::program_resume, 1);
    return;
  }
  if (!choices.chance(event_probability)) return;
  if (choices.chance(0.3)) return bench.ask(Action::program_hold, 1);
  bench.ask(choices.chance(0.5) ? Action::override_feed : Action::override_rapid, 1, "",
            choices.between(0.1, 1.0));
}

struct Ending {
  std::string fault;
  std::string code;  // of the alarm; empty: the program came to its end
  std::string text;  // of the alarm
};

// A text that is refused when it is loaded raises no alarm: who asked for the run is told.
Ending refused_load(const MachineBench& bench) {
  for (const channels::OperatorReply& reply : bench.replies()) {
    if (!reply.ok) return {"", "E7005", std::string(reply.text.view())};
  }
  return {};
}

Ending run(MachineKind kind, const std::string& program, Choices& choices) {
  const channels::MachineConfig machine = machine_of(kind);
  MachineBench bench(machine);
  bench.program(name, program);
  bench.run(1, name);
  bench.cycle();
  bool has_begun = false;
  for (int n = 0; n < cycles_max; ++n) {
    has_begun = has_begun || bench.channel(1).running;
    if (has_begun) operate(bench, choices);  // a stop before would undo what was asked for
    bench.cycle();
    if (auto fault = beyond(bench.output(), machine); !fault.empty()) return {fault, "", ""};
    if (bench.machine().waits_for_operator() &&
        bench.channel(1).state != channels::ChannelState::held) {
      const auto alarms = bench.machine().alarms();
      if (alarms.empty() && !has_begun) return refused_load(bench);
      if (alarms.empty()) return {};
      const Diagnostic& last = alarms.back().diagnostic;
      return {"", last.code, last.message};
    }
  }
  return {"does not end; it is at line " + std::to_string(bench.channel(1).tag.line), "", ""};
}

}  // namespace

channels::MachineConfig machine_of(MachineKind kind) {
  const bool is_lathe = kind == MachineKind::lathe;
  channels::MachineConfig machine = is_lathe ? turning_machine() : two_channel_machine();
  machine.entry_limits = random_entries;
  if (is_lathe) return machine;
  machine.channels[0].scheme = kind == MachineKind::five_axes ? 2 : 1;
  return machine;
}

std::string chain_fault(MachineKind machine, const std::string& program, Choices& choices) {
  try {
    MemoryFiles files;
    files.texts[name] = program;
    const auto checked = jobs::check_program(machine_of(machine), 1, -1, name, files);
    std::string refused;
    for (const Diagnostic& d : checked.diagnostics) {
      if (d.severity == Severity::error && refused.empty())
        refused = d.code + " at line " + std::to_string(d.place.line) + ": " + d.message;
    }
    const Ending ending = run(machine, program, choices);
    if (!ending.fault.empty()) return ending.fault;
    if (!ending.code.empty() && is_own_fault(ending.code))
      return "raises " + ending.code + ": " + ending.text;
    if (refused.empty() && !ending.code.empty())
      return "check takes it, the run ends with " + ending.code + ": " + ending.text;
    if (!refused.empty() && ending.code.empty())
      return "check refuses it with " + refused + ", it runs";
    return "";
  } catch (const std::exception& fault) {
    return fault.what();
  }
}

}  // namespace stanok::testing
