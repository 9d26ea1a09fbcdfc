// PathPreview: where a program will lead a tip, in few points that look like all.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/contract/output.h"
#include "recording/format/plot_points.h"

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

// Leaves points out that are less than 0.01 mm away from the line between those that stay.
class ChordFilter {
 public:
  // `point` stays; what was left out before is forgotten.
  void begin(const PlotPoint& point);
  // A point before `point` that has to stay; nothing: all that came lies on the line to it.
  [[nodiscard]] std::optional<PlotPoint> add(const PlotPoint& point);
  // The last point, which stays; nothing: there is none behind the one that stayed last.
  [[nodiscard]] std::optional<PlotPoint> end();

 private:
  [[nodiscard]] bool is_on_chord(const PlotPoint& end) const;

  PlotPoint stays_{};
  std::vector<PlotPoint> left_out_;  // bounded: of a long line every second one is dropped
};

// Gathers the preview of one channel from the outputs of all cycles.
class PreviewWriter {
 public:
  // `words` of the channel's axes, in their order: X, Y and Z make the point.
  explicit PreviewWriter(std::span<const std::string> words);
  void add(const channels::ChannelOutput& output);
  // All of it; nothing is added after it.
  [[nodiscard]] std::vector<PreviewPoint> take();

 private:
  [[nodiscard]] PlotPoint point_of(const channels::ChannelOutput& output) const;
  void end_line();

  std::array<std::optional<std::size_t>, 3> axes_;
  ThinnedPath feed_;
  ThinnedPath rapid_;
  ThinnedPath* line_ = nullptr;  // that the last point was added to; none: the next one begins anew
  ChordFilter filter_;           // before that line
  PlotPoint last_{};
  std::uint32_t run_ = 0;
  std::int32_t scheme_ = 0;
};

}  // namespace stanok::recording
