// What the picture of force control shows, gathered from its messages in bounded memory.
#pragma once

#include <filesystem>

#include "recording/format/plot_points.h"
#include "recording/read/log_contents.h"

namespace stanok::recording {

struct ForcePlot {
  PeakSeries force_set;  // N, with its oscillation
  PeakSeries force;      // N, estimated
  PeakSeries power;      // W
  PeakSeries power_idle;
  PeakSeries feed;       // mm/s, asked for
  PeakSeries vibration;  // um

  [[nodiscard]] bool is_empty() const { return force_set.points().empty(); }
};

// Collects force control of one channel; empty where it was never on.
[[nodiscard]] Expected<ForcePlot, LogError> gather_force(const std::filesystem::path& file,
                                                         const LogContents& contents, int channel);

}  // namespace stanok::recording
