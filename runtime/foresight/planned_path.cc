#include "runtime/foresight/planned_path.h"

#include <algorithm>

#include "base/place.h"

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
  finish_page();
  const std::lock_guard lock(mutex_);
  state_.is_complete = !is_full_;
}

PlannedPathWriter::PlannedPathWriter(std::span<const std::string> words,
                                     std::shared_ptr<PlannedPath> path)
    : path_(std::move(path)) {
  constexpr std::array<std::string_view, 3> coordinates{"X", "Y", "Z"};
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const auto word = std::find(words.begin(), words.end(), coordinates[k]);
    if (word != words.end()) axes_[k] = checked_size(word - words.begin());
  }
}

// A point stays where the line of the program, or between feed and rapid traverse, changes: each
// line of the program that moves has its own. Another run or scheme has another workpiece system.
void PlannedPathWriter::add(const channels::ChannelOutput& output) {
  const bool is_same = output.run == run_ && output.scheme == scheme_;
  run_ = output.run;
  scheme_ = output.scheme;
  if (!output.running || !is_same) end_line();
  if (!output.running || !output.moving) return;
  recording::PlotPoint point{};
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (axes_[k]) point[k] = output.point_W[*axes_[k]].value;
  }
  const std::uint32_t line = output.tag.line;
  const bool rapid = output.feed_commanded <= 0.0;
  const bool turns = is_open_ && (line != line_ || rapid != rapid_);
  if (turns && filter_.end()) put(last_, Joint::continues);
  line_ = line;
  rapid_ = rapid;
  if (!is_open_) put(point, Joint::begins);
  if (!is_open_ || turns) filter_.begin(is_open_ ? last_ : point);
  is_open_ = true;
  if (const auto corner = filter_.add(point)) put(*corner, Joint::continues);
  last_ = point;
}

void PlannedPathWriter::put(const recording::PlotPoint& point, Joint joint) {
  path_->add({.place_mm = {static_cast<float>(point[0]), static_cast<float>(point[1]),
                           static_cast<float>(point[2])},
              .line = line_,
              .begins = joint == Joint::begins,
              .rapid = rapid_});
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
