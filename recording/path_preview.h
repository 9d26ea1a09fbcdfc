// PathPreview: where a program will lead a tip, in few points that look like all.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/output.h"
#include "recording/plot_points.h"

namespace stanok::recording {

struct PreviewPoint {
  PlotPoint point{};    // X, Y, Z in W, mm
  bool begins = false;  // no line leads to it
  bool rapid = false;
};

struct PathPreview {
  int channel = 0;
  std::string program;
  std::vector<PreviewPoint> points;  // at most 2 x ThinnedPath::points_max: at feed, then in rapid
};

// Gathers the preview of one channel from the outputs of all cycles.
class PreviewWriter {
 public:
  // `words` of the channel's axes, in their order: X, Y and Z make the point.
  explicit PreviewWriter(std::span<const std::string> words);
  void add(const channels::ChannelOutput& output);
  [[nodiscard]] std::vector<PreviewPoint> points() const;

 private:
  [[nodiscard]] PlotPoint point_of(const channels::ChannelOutput& output) const;

  std::array<std::optional<std::size_t>, 3> axes_;
  ThinnedPath feed_;
  ThinnedPath rapid_;
  ThinnedPath* line_ = nullptr;  // that the last point was added to; none: the next one begins anew
  PlotPoint last_{};
  std::uint32_t run_ = 0;
  std::int32_t scheme_ = 0;
};

}  // namespace stanok::recording
