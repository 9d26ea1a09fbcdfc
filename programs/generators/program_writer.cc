#include "programs/generators/program_writer.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/place.h"
#include "base/units.h"

namespace stanok::programs {
namespace {

constexpr std::array<char, coordinate_count> addresses{'X', 'Y', 'Z', 'B', 'C'};
constexpr double rapid_mm_per_s =
    1000.0;                          // above what any axis reaches: rapids are not limited by it
constexpr int quarter_chords = 128;  // r (1 - cos(pi/512)) < 0.1 um up to r = 5 mm

double length_of(const Point& from, const PathStep& step) {
  const double dx = step.end[0] - from[0];
  const double dy = step.end[1] - from[1];
  const double dz = step.end[2] - from[2];
  if (step.shape == 1) return std::hypot(dx, dy, dz);
  const double start_angle = std::atan2(-step.centre[1], -step.centre[0]);
  const double end_angle = std::atan2(dy - step.centre[1], dx - step.centre[0]);
  double sweep = step.shape == 3 ? end_angle - start_angle : start_angle - end_angle;
  if (sweep <= 0.0) sweep += 2.0 * std::numbers::pi;
  return std::hypot(std::hypot(step.centre[0], step.centre[1]) * sweep, dz);
}

// G2 or G3, which is the shape of the step too.
int code_of(Turn turn) {
  return turn == Turn::clockwise ? 2 : 3;
}

}  // namespace

std::string decimal_text(std::int64_t units, int decimals) {
  std::string digits = std::to_string(std::llabs(units));
  const std::size_t places = checked_size(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return units < 0 ? "-" + digits : digits;
}

ProgramWriter::ProgramWriter(const Layout& layout, const Point& start) : layout_(layout) {
  for (int i = 0; i < layout.decimals; ++i) scale_ *= 10;
  for (int i = 0; i < layout.feed_decimals; ++i) feed_scale_ *= 10;
  position_ = rounded(start);
  path_.push_back({.block = 0, .end = value(position_), .feed_mm_per_s = rapid_mm_per_s});
}

void ProgramWriter::comment(std::string_view line) {
  text_.append(line).push_back('\n');
}

void ProgramWriter::block(std::string_view words) {
  begin_block();
  line_.append(" ").append(words);
  end_block();
}

void ProgramWriter::rapid(const Point& end, std::string_view prefix) {
  if (prefix.empty() && is_at(end)) return;
  begin_block();
  plane(17);
  motion_code(0);
  if (!prefix.empty()) line_.append(" ").append(prefix);
  axis_words(end);
  move(end, {.feed_mm_per_s = rapid_mm_per_s});
  end_block();
}

void ProgramWriter::line(const Point& end, double feed_mm_per_min) {
  begin_block();
  plane(17);
  motion_code(1);
  axis_words(end);
  feed_word(feed_mm_per_min);
  move(end, {.feed_mm_per_s = feed_mm_per_s()});
  end_block();
}

void ProgramWriter::arc_xy(const Point& end, std::array<double, 2> centre_xy, Turn turn,
                           double feed_mm_per_min) {
  const Units centre = rounded({centre_xy[0], centre_xy[1]});
  begin_block();
  plane(17);
  motion_code(code_of(turn));
  axis_words(end);
  line_.append(word('I', centre[0])).append(word('J', centre[1]));
  feed_word(feed_mm_per_min);
  move(end, {.feed_mm_per_s = feed_mm_per_s(),
             .shape = code_of(turn),
             .centre = {value(centre)[0], value(centre)[1]}});
  end_block();
}

void ProgramWriter::quarter_zx(const Point& end, std::array<double, 2> centre_zx, Turn turn,
                               double feed_mm_per_min) {
  const Units centre = rounded({centre_zx[1], 0.0, centre_zx[0]});
  begin_block();
  plane(18);
  motion_code(code_of(turn));
  axis_words(end);
  line_.append(word('I', centre[0])).append(word('K', centre[2]));
  feed_word(feed_mm_per_min);

  const Point start = path_.back().end;
  const Point target = value(rounded(end));
  const Point offset = value(centre);
  const double radius = std::hypot(offset[0], offset[2]);
  const double start_angle = std::atan2(-offset[0], -offset[2]);  // from +Z towards +X
  const double sweep = (turn == Turn::clockwise ? -0.5 : 0.5) * std::numbers::pi;
  for (int i = 1; i <= quarter_chords; ++i) {
    const double angle = start_angle + sweep * i / quarter_chords;
    Point point = target;
    if (i < quarter_chords) {
      point[0] = start[0] + offset[0] + radius * std::sin(angle);
      point[2] = start[2] + offset[2] + radius * std::cos(angle);
    }
    PathStep chord{.block = blocks_, .end = point, .feed_mm_per_s = feed_mm_per_s()};
    feed_time_s_ += length_of(path_.back().end, chord) / chord.feed_mm_per_s;
    path_.push_back(chord);
  }
  position_ = rounded(end);
  end_block();
}

ProgramWriter::Units ProgramWriter::rounded(const Point& point) const {
  Units units{};
  for (std::size_t k = 0; k < units.size(); ++k) {
    units[k] =
        std::isnan(point[k]) ? position_[k] : std::llround(point[k] * static_cast<double>(scale_));
  }
  return units;
}

Point ProgramWriter::value(const Units& units) const {
  Point point{};
  for (std::size_t k = 0; k < point.size(); ++k) {
    point[k] = static_cast<double>(units[k]) / static_cast<double>(scale_);
  }
  return point;
}

std::string ProgramWriter::word(char address, std::int64_t units) const {
  return std::string(" ") + address + decimal_text(units, layout_.decimals);
}

void ProgramWriter::begin_block() {
  ++blocks_;
  line_ = "N" + std::to_string(blocks_ * layout_.number_step);
}

void ProgramWriter::end_block() {
  text_.append(line_).push_back('\n');
}

void ProgramWriter::plane(int code) {
  if (plane_ == code) return;
  plane_ = code;
  line_.append(" G").append(std::to_string(code));
}

void ProgramWriter::motion_code(int code) {
  if (motion_ == code && !layout_.every_motion_code) return;
  motion_ = code;
  line_.append(" G").append(std::to_string(code));
}

void ProgramWriter::feed_word(double feed_mm_per_min) {
  const std::int64_t feed = std::llround(feed_mm_per_min * static_cast<double>(feed_scale_));
  if (feed == feed_ && !layout_.every_word) return;
  feed_ = feed;
  line_.append(" F").append(decimal_text(feed, layout_.feed_decimals));
}

double ProgramWriter::feed_mm_per_s() const {
  return static_cast<double>(feed_) / static_cast<double>(feed_scale_) / seconds_per_minute;
}

bool ProgramWriter::is_at(const Point& end) const {
  const Units target = rounded(end);
  for (std::size_t k = 0; k < layout_.axis_count; ++k) {
    if (!std::isnan(end[k]) && (!programmed_[k] || target[k] != position_[k])) return false;
  }
  return true;
}

void ProgramWriter::axis_words(const Point& end) {
  const Units target = rounded(end);
  for (std::size_t k = 0; k < layout_.axis_count; ++k) {
    if (std::isnan(end[k])) continue;
    if (programmed_[k] && position_[k] == target[k] && !layout_.every_word) continue;
    line_.append(word(addresses[k], target[k]));
    programmed_[k] = true;
  }
}

void ProgramWriter::move(const Point& end, PathStep step) {
  position_ = rounded(end);
  step.block = blocks_;
  step.end = value(position_);
  if (step.feed_mm_per_s < rapid_mm_per_s) {
    feed_time_s_ += length_of(path_.back().end, step) / step.feed_mm_per_s;
  }
  path_.push_back(step);
}

}  // namespace stanok::programs
