#include "jobs/foresight/planned_path.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"
#include "base/units.h"

namespace stanok::jobs {

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

void PlannedPath::lie_on(const PartSystem& part) {
  const std::lock_guard lock(mutex_);
  state_.part = part;
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

PlannedPathWriter::PlannedPathWriter(const channels::MachineConfig& machine,
                                     const channels::ChannelConfig& channel,
                                     const std::optional<PartSystem>& part,
                                     std::shared_ptr<PlannedPath> path)
    : cycle_s_(machine.cycle_us * 1e-6),
      part_place_(machine, channel),
      part_(part),
      path_(std::move(path)) {
  if (part_) path_->lie_on(*part_);
  constexpr std::array<std::string_view, 3> coordinates{"X", "Y", "Z"};
  const auto& words = channel.words;
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
  const Place place = place_of(output);
  const Way way = way_of(output);
  if (is_open_ && (is_elsewhere(place.in_W) || way.tool != way_.tool)) end_line();
  const bool turns = is_open_ && way != way_;
  if (turns && ends_behind_a_point()) put(last_, Joint::continues);
  way_ = way;
  feed_mm_per_min_ = output.feed_commanded * seconds_per_minute;
  if (!is_open_) put(place, Joint::begins);
  if (!is_open_ || turns) begin_chord(is_open_ ? last_ : place);
  is_open_ = true;
  continue_to(place);
  last_ = place;
  last_speed_ = speed_;
}

void PlannedPathWriter::begin_chord(const Place& place) {
  in_W_.begin(place.in_W);
  on_part_.begin(place.on_part);
}

// Each filter says when the place before has to stay: it stays in both systems then.
void PlannedPathWriter::continue_to(const Place& place) {
  const bool stays_in_W = in_W_.add(place.in_W).has_value();
  const bool stays_on_part = on_part_.add(place.on_part).has_value();
  if (!stays_in_W && !stays_on_part) return;
  put(last_, Joint::continues);
  const auto restart = [](recording::ChordFilter& filter, const recording::PlotPoint& from,
                          const recording::PlotPoint& to) {
    filter.begin(from);
    static_cast<void>(filter.add(to));
  };
  if (!stays_in_W) restart(in_W_, last_.in_W, place.in_W);
  if (!stays_on_part) restart(on_part_, last_.on_part, place.on_part);
}

bool PlannedPathWriter::ends_behind_a_point() {
  const bool in_W = in_W_.end().has_value();
  return on_part_.end().has_value() || in_W;
}

PlannedPathWriter::Way PlannedPathWriter::way_of(const channels::ChannelOutput& output) {
  return {output.tag.line, output.feed_commanded <= 0.0, output.on_arc, output.tool.number};
}

PlannedPathWriter::Place PlannedPathWriter::place_of(const channels::ChannelOutput& output) {
  Place place;
  double speed2 = 0.0;
  for (std::size_t k = 0; k < place.in_W.size(); ++k) {
    if (!axes_[k]) continue;
    const auto& coordinate = output.point_W[*axes_[k]];
    place.in_W[k] = coordinate.value;
    speed2 += coordinate.first * coordinate.first;
  }
  speed_ = std::sqrt(speed2);
  place.on_part = on_part(output, place.in_W);
  return place;
}

// Before a scheme is active there is no part that could be somewhere else.
recording::PlotPoint PlannedPathWriter::on_part(const channels::ChannelOutput& output,
                                                const recording::PlotPoint& in_W) const {
  const auto tool = part_ ? part_place_.tool_in(*part_, output) : std::nullopt;
  if (!tool) return in_W;
  return {tool->tip.x(), tool->tip.y(), tool->tip.z()};
}

// The same place has other coordinates where a block chooses another offset, plane or rotation: it
// is further from the last one than the tip moves in a cycle.
bool PlannedPathWriter::is_elsewhere(const recording::PlotPoint& point) const {
  constexpr double unseen_mm = 0.01;
  const recording::PlotPoint& last = last_.in_W;
  const double moved = std::hypot(point[0] - last[0], point[1] - last[1], point[2] - last[2]);
  return moved > 2.0 * std::max(speed_, last_speed_) * cycle_s_ + unseen_mm;
}

void PlannedPathWriter::put(const Place& place, Joint joint) {
  const auto floats = [](const recording::PlotPoint& point) {
    return std::array{static_cast<float>(point[0]), static_cast<float>(point[1]),
                      static_cast<float>(point[2])};
  };
  path_->add({.place_mm = floats(place.in_W),
              .on_part_mm = floats(place.on_part),
              .line = way_.line,
              .begins = joint == Joint::begins,
              .rapid = way_.rapid,
              .arc = way_.arc,
              .feed_mm_per_min = static_cast<float>(feed_mm_per_min_),
              .tool = way_.tool});
}

void PlannedPathWriter::end_line() {
  if (is_open_ && ends_behind_a_point()) put(last_, Joint::continues);
  is_open_ = false;
}

void PlannedPathWriter::complete() {
  end_line();
  path_->complete();
}

}  // namespace stanok::jobs
