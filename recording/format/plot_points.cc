#include "recording/format/plot_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stanok::recording {
namespace {

constexpr double coordinate_max = 1e7;  // mm; no machine has longer travel

bool is_coordinate(double value) {
  return std::abs(value) <= coordinate_max;
}

}  // namespace

void PeakSeries::add(double time, double value) {
  if (!std::isfinite(time) || !std::isfinite(value)) return;
  const TimePoint point{time, value};
  const Bin single{point, point, point, point};
  if (!bins_.empty() && values_in_last_bin_ < values_per_bin_) {
    merge(single, bins_.back());
    ++values_in_last_bin_;
    return;
  }
  if (bins_.size() == bins_max) {
    for (std::size_t k = 0; k < bins_max / 2; ++k) {
      bins_[k] = bins_[2 * k];
      merge(bins_[2 * k + 1], bins_[k]);
    }
    bins_.resize(bins_max / 2);
    values_per_bin_ *= 2;
  }
  bins_.push_back(single);
  values_in_last_bin_ = 1;
}

void PeakSeries::merge(const Bin& later, Bin& bin) {
  if (later.smallest.value < bin.smallest.value) bin.smallest = later.smallest;
  if (later.largest.value > bin.largest.value) bin.largest = later.largest;
  bin.last = later.last;
}

std::vector<TimePoint> PeakSeries::points() const {
  std::vector<TimePoint> points;
  for (const Bin& bin : bins_) {
    const bool falls = bin.largest.time < bin.smallest.time;
    for (const TimePoint& point : {bin.first, falls ? bin.largest : bin.smallest,
                                   falls ? bin.smallest : bin.largest, bin.last}) {
      if (points.empty() || points.back().time < point.time) points.push_back(point);
    }
  }
  return points;
}

void ThinnedPath::add(const PlotPoint& point, Joint joint) {
  if (!std::all_of(point.begin(), point.end(), is_coordinate)) return;
  if (kept_.size() >= points_max) thin();
  if (joint == Joint::begins_stretch || kept_.empty()) {
    kept_.push_back({point, Joint::begins_stretch});
    last_is_provisional_ = false;
    return;
  }
  if (last_is_provisional_) kept_.pop_back();
  last_is_provisional_ = is_near(point, kept_.back().point);
  kept_.push_back({point, Joint::continues});
}

bool ThinnedPath::is_near(const PlotPoint& a, const PlotPoint& b) const {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < distance_;
}

void ThinnedPath::thin() {
  while (kept_.size() > points_max / 2) {
    distance_ *= 2.0;
    Joint joint = Joint::begins_stretch;
    for (const Kept& candidate : std::exchange(kept_, {})) {
      if (candidate.joint == Joint::begins_stretch) joint = Joint::begins_stretch;
      if (!kept_.empty() && is_near(candidate.point, kept_.back().point)) continue;
      kept_.push_back({candidate.point, joint});
      joint = Joint::continues;
    }
  }
  last_is_provisional_ = false;
}

std::vector<std::vector<PlotPoint>> ThinnedPath::stretches() const {
  std::vector<std::vector<PlotPoint>> stretches;
  for (const Kept& kept : kept_) {
    if (kept.joint == Joint::begins_stretch) stretches.emplace_back();
    stretches.back().push_back(kept.point);
  }
  return stretches;
}

}  // namespace stanok::recording
