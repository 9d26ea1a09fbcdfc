// What the pictures of one channel show, gathered from its setpoints in bounded memory.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "recording/format/plot_points.h"
#include "recording/plot/force_plot.h"
#include "recording/read/log_contents.h"

namespace stanok::recording {

// A program run, or the part of it in one kinematic scheme.
struct RunPlot {
  int run = 0;
  int scheme = 0;
  ThinnedPath path;  // programmed point at feed, workpiece system: X, Y, Z
  PeakSeries speed;  // mm/s
};

struct AxisPlot {
  AxisDescription axis;
  PeakSeries velocity;  // machine axis, mm or deg; 1/s, 1/s^2, 1/s^3
  PeakSeries acceleration;
  PeakSeries jerk;
};

struct ChannelPlot {
  int channel = 0;
  std::string machine;
  double time_begin = 0.0;  // s since the begin of the log
  double time_end = 0.0;
  std::vector<RunPlot> runs;  // in order of time; runs_max at most, the last holds the rest
  ThinnedPath rapid;          // programmed point in rapid traverse, all runs
  PeakSeries feed;            // mm/s, as commanded before override
  ForcePlot force;            // of force control
  std::vector<AxisPlot> axes;
  std::array<std::optional<std::size_t>, 3> point_axes;  // channel axis of X, Y, Z
};

inline constexpr std::size_t plot_runs_max = 24;

[[nodiscard]] Expected<ChannelPlot, LogError> gather_plot(const std::filesystem::path& file,
                                                          const LogContents& contents, int channel);

}  // namespace stanok::recording
