// A generated workload: a part program of an exact number of blocks whose feeds give a wanted time.
//
// A workload lays out its rows for a given budget of blocks and a given top feed; everything else
// (how many blocks the rows may take, which feed gives the wanted time) is found here by laying it
// out twice.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "programs/generators/program_writer.h"

namespace stanok::programs {

enum class Scale { full, small };

struct WorkloadOptions {
  Scale scale = Scale::full;
  Point start{};                // where the machine stands before, in the workpiece system
  std::optional<int> decimals;  // of the coordinates; default: of the workload
  // Feeds of the 3-axis raster on steep and on flat parts, mm/min; default: from the wanted time.
  std::optional<double> feed_low;
  std::optional<double> feed_high;
};

struct Workload {
  std::string name;  // file name of the program
  Layout layout;
  ProgramWriter program;
};

// What a layout may use. feed_high belongs to flat parts, feed_low to steep parts, arcs and edges.
struct Budget {
  int row_blocks = 0;  // to be shared among the rows
  double feed_low = 0.0;
  double feed_high = 0.0;
};

using LayOut = std::function<ProgramWriter(const Budget&)>;

// The program with exactly `blocks` blocks and, where no feeds are given, about `time_s` at its
// feeds. feed_low is `feed_ratio` of feed_high unless given.
[[nodiscard]] ProgramWriter fitted(const LayOut& lay_out, int blocks, double time_s,
                                   double feed_ratio, const WorkloadOptions& options);

}  // namespace stanok::programs
