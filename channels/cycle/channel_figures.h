// What a Channel is made of and works with: fixed figures of its axes and spindles, the forms of
// its answers and alarms, and the books into which it writes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "channels/contract/output.h"
#include "channels/cycle/manual_motion.h"
#include "channels/cycle/spindle.h"
#include "channels/messages/item.h"
#include "channels/stores/report_book.h"
#include "motion/automatic_feed.h"
#include "motion/axis_codes.h"
#include "motion/feed_modifier.h"
#include "motion/spindle_observer.h"

namespace stanok::channels {

static_assert(spindles_max == motion::coupled_spindles_max);
inline constexpr std::size_t automatic_feeds_max = 2;  // laws that the cycle forms of a channel

// What is loaded and run: a program, or one line of an operator (MDI).
enum class Job : std::uint8_t { program, line, search };

// How a run of the channel, a load, a switch came out; the coordinator reads and acts.
enum class Outcome : std::uint8_t { pending, succeeded, failed };

// Fixed figures of one axis in the cycle.
struct AxisFigures {
  motion::CodeScale codes;
  double brake_s = 0.0;        // time a brake takes to close or open
  double power_s = 0.0;        // time a drive takes to take over
  bool homed_at_start = true;  // until a drive says otherwise
  FixedText<16> name;
  RegulatorConfig regulator;
  double demand_max = 0.0;  // mm/s or deg/s, of the regulator
  ManualAxis manual{};
};

struct ChannelFigures {
  std::int32_t id = 1;
  int axis_count = 0;
  double cycle_s = 0.001;
  bool stops_go_on = false;  // M0 and M60 continue at once, M99 ends the run (simulate)
  std::array<AxisFigures, motion::axes_max> axes{};
  std::array<int, motion::axes_max> machine_axis{};  // index among all axes of the machine
  std::array<double, motion::axes_max> start{};
  std::array<SpindleConfig, spindles_max> spindles{};
  std::array<int, spindles_max> spindle_axis{-1, -1, -1,
                                             -1};   // that it becomes with M902; -1: none
  std::array<int, spindles_max> machine_spindle{};  // index among all spindles of the machine
  int spindle_count = 0;
  std::array<motion::AutomaticFeedConfig, automatic_feeds_max> automatic_feeds{};
  motion::FeedModifier* feed_modifier = nullptr;  // nullptr: no force control
  int probe_input = -1;  // digital input that is on while the probe touches; -1: no probe
};

// What a request of the program came to: `code` and `text` say why `ok` is false.
struct ChannelAnswer {
  bool ok = true;
  bool raises = false;  // lang::Answer
  double value = 0.0;
  motion::Point probe_M{};  // of a probing move
  bool left_path = false;   // the axes stand elsewhere than at the end of the path
  FixedText<8> code;
  ReasonText text;
};

// A move that ends where the probe changes (G38.2 to G38.5).
struct ProbeWatch {
  bool is_on = false;          // from the move on until its answer
  bool until_contact = false;  // else until it leaves
  bool has_changed = false;
  bool ends_path = false;  // what is left of the move is given up
  motion::Point axes_M{};  // where the axes stood when it changed, mm or deg
};

// The latest alarm of a channel.
struct ChannelAlarm {
  std::uint32_t run = 0;
  std::uint32_t line = 0;
  FixedText<8> code;
  FileName file;
};

// Where events, alarms and run records go; owned by the machine.
struct CycleBooks {
  Ring<Event>* events = nullptr;
  ReportBook* reports = nullptr;
  Signals* outputs = nullptr;
  const Signals* inputs = nullptr;  // of this cycle
};

}  // namespace stanok::channels
