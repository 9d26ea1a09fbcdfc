// Constants of a channel in the cycle: of its axes, its spindles and its process.
#pragma once

#include <array>
#include <cstdint>

#include "base/axis_index.h"
#include "base/numbered.h"
#include "channels/axes/manual_motion.h"
#include "channels/axes/spindle.h"
#include "channels/contract/output.h"
#include "motion/interpolation/automatic_feed.h"
#include "motion/path/axis_codes.h"
#include "motion/segments/feed_modifier.h"
#include "motion/threads/spindle_observer.h"

namespace stanok::channels {

static_assert(spindles_max == motion::coupled_spindles_max);
inline constexpr std::size_t automatic_feeds_max = 2;  // laws that the cycle forms of a channel

// Constants of one axis in the cycle.
struct AxisConstants {
  motion::CodeScale codes;
  double brake_s = 0.0;        // time a brake takes to close or open
  double power_s = 0.0;        // time a drive takes to take over
  bool homed_at_start = true;  // until a drive says otherwise
  FixedText<16> name;
  ControllerConfig controller;
  double demand_max = 0.0;  // mm/s or deg/s, of the controller
  ManualAxis manual{};
};

struct ChannelConstants {
  std::int32_t id = 1;
  int axis_count = 0;
  double cycle_s = 0.001;
  std::int64_t stop_cycles_max = 0;  // behind which power is removed from axes that still move
  std::size_t retrace_bytes = 0;     // for the path that lies behind
  int probe_input = -1;              // on while the probe touches; -1: there is none
  bool first_run = false;            // the first part of each program is one (set_first_part)
  bool stops_go_on = false;          // M0 and M60 continue at once, M99 ends the run (simulate)
  AxisArray<AxisConstants> axes{};
  AxisArray<int> machine_axis{};  // index among all axes of the machine
  AxisArray<double> start{};
  NumberedArray<SpindleConfig, spindles_max> spindles{};
  // The axis that a spindle becomes with M902; -1: none.
  NumberedArray<int, spindles_max> spindle_axis{-1, -1, -1, -1};
  NumberedArray<int, spindles_max> machine_spindle{};  // index among all spindles of the machine
  int spindle_count = 0;
  std::array<motion::AutomaticFeedConfig, automatic_feeds_max> automatic_feeds{};
  motion::FeedModifier* feed_modifier = nullptr;  // nullptr: no force control
};

}  // namespace stanok::channels
