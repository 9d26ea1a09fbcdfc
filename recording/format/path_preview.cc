#include "recording/format/path_preview.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"

namespace stanok::recording {
namespace {

constexpr double tolerance_mm = 0.01;
constexpr std::size_t left_out_max = 64;

// From the chord itself, not from the line that it lies on: a path may turn back.
double distance_from_chord(const PlotPoint& begin, const PlotPoint& end, const PlotPoint& point) {
  double length_squared = 0.0;
  double product = 0.0;
  for (std::size_t k = 0; k < point.size(); ++k) {
    length_squared += (end[k] - begin[k]) * (end[k] - begin[k]);
    product += (point[k] - begin[k]) * (end[k] - begin[k]);
  }
  const double along = length_squared > 0.0 ? std::clamp(product / length_squared, 0.0, 1.0) : 0.0;
  double distance_squared = 0.0;
  for (std::size_t k = 0; k < point.size(); ++k) {
    const double away = point[k] - begin[k] - along * (end[k] - begin[k]);
    distance_squared += away * away;
  }
  return std::sqrt(distance_squared);
}

void append(const ThinnedPath& path, bool rapid, std::vector<PreviewPoint>& points) {
  for (const auto& stretch : path.stretches()) {
    for (std::size_t k = 0; k < stretch.size(); ++k) points.push_back({stretch[k], k == 0, rapid});
  }
}

}  // namespace

void ChordFilter::begin(const PlotPoint& point) {
  stays_ = point;
  left_out_.clear();
}

bool ChordFilter::is_on_chord(const PlotPoint& end) const {
  return std::all_of(left_out_.begin(), left_out_.end(), [&](const PlotPoint& point) {
    return distance_from_chord(stays_, end, point) <= tolerance_mm;
  });
}

std::optional<PlotPoint> ChordFilter::add(const PlotPoint& point) {
  std::optional<PlotPoint> corner;
  if (!is_on_chord(point)) {
    corner = left_out_.back();
    begin(*corner);
  }
  if (left_out_.size() == left_out_max) {
    for (std::size_t k = 0; 2 * k + 1 < left_out_max; ++k) left_out_[k] = left_out_[2 * k + 1];
    left_out_.resize(left_out_max / 2);
  }
  left_out_.push_back(point);
  return corner;
}

std::optional<PlotPoint> ChordFilter::end() {
  if (left_out_.empty() || left_out_.back() == stays_) return std::nullopt;
  return left_out_.back();
}

PreviewWriter::PreviewWriter(std::span<const std::string> words) {
  constexpr std::array<std::string_view, 3> coordinates{"X", "Y", "Z"};
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const auto word = std::find(words.begin(), words.end(), coordinates[k]);
    if (word != words.end()) axes_[k] = checked_size(word - words.begin());
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
  const bool goes_on = output.running && is_same && line_ != nullptr;
  run_ = output.run;
  scheme_ = output.scheme;
  if (!goes_on) end_line();
  if (!output.running) return;
  const PlotPoint point = point_of(output);
  ThinnedPath& line = output.feed_commanded > 0.0 ? feed_ : rapid_;
  if (line_ != &line) {
    end_line();
    const PlotPoint& first = goes_on ? last_ : point;
    line.add(first, ThinnedPath::Joint::begins_stretch);
    filter_.begin(first);
    line_ = &line;
  }
  if (const auto corner = filter_.add(point)) line.add(*corner, ThinnedPath::Joint::continues);
  last_ = point;
}

void PreviewWriter::end_line() {
  if (line_ == nullptr) return;
  if (const auto last = filter_.end()) line_->add(*last, ThinnedPath::Joint::continues);
  line_ = nullptr;
}

std::vector<PreviewPoint> PreviewWriter::take() {
  end_line();
  std::vector<PreviewPoint> points;
  append(feed_, false, points);
  append(rapid_, true, points);
  return points;
}

}  // namespace stanok::recording
