#include "runtime/foresight/planned_path.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"
#include "base/units.h"

namespace stanok::runtime {

PlannedPath::State PlannedPath::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::shared_ptr<const PathPage> PlannedPath::page(std::size_t number) const {
  const std::lock_guard lock(mutex_);
  return number < pages_.size() ? pages_[number] : nullptr;
}

void PlannedPath::add(const PathPage::Point& point) {
  is_full_ = is_full_ || pages_.size() * page_points >= points_max;
  if (is_full_) return;
  growing_.points.push_back(point);
  if (growing_.points.size() == page_points) finish_page();
}

void PlannedPath::finish_page() {
  const std::size_t points = growing_.points.size();
  if (points == 0) return;
  auto page = std::make_shared<const PathPage>(std::move(growing_));
  growing_ = {};
  const std::lock_guard lock(mutex_);
  pages_.push_back(std::move(page));
  state_.pages = pages_.size();
  state_.points += points;
}

void PlannedPath::complete() {
  if (is_full_) return give_up(GivenUp::points);
  finish_page();
  const std::lock_guard lock(mutex_);
  state_.is_complete = true;
}

void PlannedPath::give_up(GivenUp why) {
  finish_page();
  const std::lock_guard lock(mutex_);
  if (!state_.is_complete && state_.given_up == GivenUp::no) state_.given_up = why;
}

PlannedPathWriter::PlannedPathWriter(std::span<const std::string> words, double cycle_s,
                                     std::shared_ptr<PlannedPath> path)
    : cycle_s_(cycle_s), path_(std::move(path)) {
  constexpr std::array<std::string_view, 3> coordinates{"X", "Y", "Z"};
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const auto word = std::find(words.begin(), words.end(), coordinates[k]);
    if (word != words.end()) axes_[k] = checked_size(word - words.begin());
  }
}

// A point stays where the line of the program, or between feed and rapid traverse, line and arc,
// changes: each line of the program that moves has its own. Another run or scheme has another
// workpiece system.
void PlannedPathWriter::add(const channels::ChannelOutput& output) {
  const bool is_same = output.run == run_ && output.scheme == scheme_;
  run_ = output.run;
  scheme_ = output.scheme;
  if (!output.running || !is_same) end_line();
  if (!output.running || !output.moving) return;
  const recording::PlotPoint point = point_of(output);
  if (is_open_ && is_elsewhere(point)) end_line();
  const Way way = way_of(output);
  const bool turns = is_open_ && way != way_;
  if (turns && filter_.end()) put(last_, Joint::continues);
  way_ = way;
  feed_mm_per_min_ = output.feed_commanded * seconds_per_minute;
  if (!is_open_) put(point, Joint::begins);
  if (!is_open_ || turns) filter_.begin(is_open_ ? last_ : point);
  is_open_ = true;
  if (const auto corner = filter_.add(point)) put(*corner, Joint::continues);
  last_ = point;
  last_speed_ = speed_;
}

PlannedPathWriter::Way PlannedPathWriter::way_of(const channels::ChannelOutput& output) {
  return {output.tag.line, output.feed_commanded <= 0.0, output.on_arc, output.tool.number};
}

recording::PlotPoint PlannedPathWriter::point_of(const channels::ChannelOutput& output) {
  recording::PlotPoint point{};
  double speed2 = 0.0;
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (!axes_[k]) continue;
    const auto& coordinate = output.point_W[*axes_[k]];
    point[k] = coordinate.value;
    speed2 += coordinate.first * coordinate.first;
  }
  speed_ = std::sqrt(speed2);
  return point;
}

// The same place has other coordinates where a block chooses another offset, plane or rotation: it
// is further from the last one than the tip moves in a cycle.
bool PlannedPathWriter::is_elsewhere(const recording::PlotPoint& point) const {
  constexpr double unseen_mm = 0.01;
  const double moved = std::hypot(point[0] - last_[0], point[1] - last_[1], point[2] - last_[2]);
  return moved > 2.0 * std::max(speed_, last_speed_) * cycle_s_ + unseen_mm;
}

void PlannedPathWriter::put(const recording::PlotPoint& point, Joint joint) {
  path_->add({.place_mm = {static_cast<float>(point[0]), static_cast<float>(point[1]),
                           static_cast<float>(point[2])},
              .line = way_.line,
              .begins = joint == Joint::begins,
              .rapid = way_.rapid,
              .arc = way_.arc,
              .feed_mm_per_min = static_cast<float>(feed_mm_per_min_),
              .tool = way_.tool});
}

void PlannedPathWriter::end_line() {
  if (is_open_ && filter_.end()) put(last_, Joint::continues);
  is_open_ = false;
}

void PlannedPathWriter::complete() {
  end_line();
  path_->complete();
}

}  // namespace stanok::runtime
