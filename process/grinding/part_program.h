// The part program of a plunge cycle: one straight infeed whose feed is switched at the X of the
// table.
//
// The program's X is the X of the control file: G52 puts its zero to the radius of the finished
// part, so that a block reads as a row of the table, `G1 X0.2602 F2.4`. Blocks of one straight line
// join without a stop; a fall of the feed ends at its place and a rise begins there
// (docs/developer/motion.md).
#pragma once

#include <string>

#include "process/grinding/control_file.h"

namespace stanok::process {

struct ProgramOptions {
  std::string title{};  // a comment; other than ASCII letters become blanks
  std::string infeed_word = "X";
  int part_spindle = 1;   // number of the channel's part spindle
  int wheel_spindle = 0;  // of the wheel's; 0: the program does not speak of it
  double wheel_speed_rpm = 0.0;
  double gap_mm = 0.05;     // above the allowance: the first feed begins there
  double retract_mm = 5.0;  // above the finished radius, after the cycle
  double spark_out_s = 0.0;
  // Active control: the last feed goes on until the gauge of the channel (its probe input) finds
  // the size, at most this far below the last X; 0: the table ends it.
  double gauge_margin_mm = 0.0;
};

[[nodiscard]] std::string part_program(const GrindingProcess& process, const InfeedLaw& law,
                                       const ProgramOptions& options);

// A stretch of the law at one feed.
struct FeedBlock {
  double end_mm = 0.0;
  double feed_mm_per_s = 0.0;
};

// The law as constant feeds: an interval along which the feed changes becomes several, each with
// its least feed and none more than 2 % below the feed it stands for.
[[nodiscard]] std::vector<FeedBlock> feed_blocks(const InfeedLaw& law);

}  // namespace stanok::process
