#include "recording/path_preview.h"

#include <algorithm>

namespace stanok::recording {
namespace {

void append(const ThinnedPath& path, bool rapid, std::vector<PreviewPoint>& points) {
  for (const auto& stretch : path.stretches()) {
    for (std::size_t k = 0; k < stretch.size(); ++k) points.push_back({stretch[k], k == 0, rapid});
  }
}

}  // namespace

PreviewWriter::PreviewWriter(std::span<const std::string> words) {
  constexpr std::array<std::string_view, 3> coordinates{"X", "Y", "Z"};
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const auto word = std::find(words.begin(), words.end(), coordinates[k]);
    if (word != words.end()) axes_[k] = static_cast<std::size_t>(word - words.begin());
  }
}

PlotPoint PreviewWriter::point_of(const channels::ChannelOutput& output) const {
  PlotPoint point{};
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (axes_[k]) point[k] = output.point_W[*axes_[k]].value;
  }
  return point;
}

// Feed and rapid traverse are lines of their own that meet in a point. Another run or scheme has
// another workpiece system.
void PreviewWriter::add(const channels::ChannelOutput& output) {
  const bool is_same = output.run == run_ && output.scheme == scheme_;
  if (!output.running || !is_same) line_ = nullptr;
  run_ = output.run;
  scheme_ = output.scheme;
  if (!output.running) return;
  const PlotPoint point = point_of(output);
  ThinnedPath& line = output.feed_commanded > 0.0 ? feed_ : rapid_;
  if (line_ != &line)
    line.add(line_ == nullptr ? point : last_, ThinnedPath::Joint::begins_stretch);
  line.add(point, ThinnedPath::Joint::continues);
  line_ = &line;
  last_ = point;
}

std::vector<PreviewPoint> PreviewWriter::points() const {
  std::vector<PreviewPoint> points;
  append(feed_, false, points);
  append(rapid_, true, points);
  return points;
}

}  // namespace stanok::recording
