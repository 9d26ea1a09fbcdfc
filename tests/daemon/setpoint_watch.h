// SetpointWatch: looks at every cycle of a DaemonBench for what no fault may ever bring about.
#pragma once

#include <array>
#include <cmath>

#include "tests/daemon/daemon_bench.h"

namespace stanok::daemon {

// Setpoints are numbers, and within a run no axis goes faster than it may: a step of a cycle is at
// most velocity_max times the cycle.
class SetpointWatch {
 public:
  void look(const channels::CycleOutput& output) {
    const auto& machine = mill_of_the_bench().machine;
    const channels::ChannelOutput& work = output.channels[0];
    for (std::size_t k = 0; k < machine.channels[0].axes.size(); ++k) {
      const double position = work.axes[k].position;
      ASSERT_TRUE(std::isfinite(position) && std::isfinite(work.axes[k].velocity));
      const auto& limits =
          machine.axes[static_cast<std::size_t>(machine.channels[0].axes[k])].limits;
      const double most = limits.velocity_max * machine.cycle_us * 1e-6 * (1.0 + 1e-9) + 1e-9;
      if (ran_ && work.running && work.drives[k].enabled) {
        ASSERT_LE(std::abs(position - before_[k]), most)
            << "axis " << k << " in cycle " << output.cycle;
      }
      before_[k] = position;
    }
    ran_ = work.running;
  }

 private:
  std::array<double, motion::axes_max> before_{};
  bool ran_ = false;
};

}  // namespace stanok::daemon
