#include "channels/preparation/feed_limit.h"

#include <array>
#include <cstdio>
#include <string>

#include "base/axis_index.h"
#include "motion/bounds/segment_bounds.h"
#include "motion/path/shape.h"

namespace stanok::channels {
namespace {

constexpr double s_per_min = 60.0;
constexpr double rounding = 1e-9;  // relative

// The speeds of the axes use more than all of their limits at the feed of the segment.
bool is_above_limit(const motion::Segment& segment) {
  return !segment.rapid && segment.feed_per_s * segment.bounds.velocity > 1.0 + rounding;
}

// Along s there are mm, or deg where rotary axes alone move.
const char* unit_of_feed(const motion::Segment& segment, const motion::MotionConfig& motion) {
  for (const AxisIndex axis : motion.geometry) {
    if (axis.exists() && segment.geometry.metric.counts(axis.place())) return "mm/min";
  }
  return "deg/min";
}

std::string text(const char* format, double feed, const char* unit, double limit) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, feed, unit, limit);
  return text.data();
}

}  // namespace

std::optional<Diagnostic> feed_above_limit(const motion::Segment& segment,
                                           const motion::MotionConfig& motion) {
  if (!is_above_limit(segment)) return std::nullopt;
  Diagnostic warning;
  warning.severity = Severity::warning;
  warning.code = "W810";
  warning.message = text("the feed of %.6g %s is above %.6g, the limit of the axes",
                         s_per_min * segment.feed_per_s, unit_of_feed(segment, motion),
                         s_per_min / segment.bounds.velocity);
  warning.help = {"no action is needed; further blocks like this are not reported"};
  return warning;
}

std::optional<Diagnostic> tap_refusal(const motion::PathBlock& line, const motion::Point& start,
                                      const std::array<int, 3>& geometry,
                                      const motion::MotionConfig& motion) {
  motion::MotionConfig here = motion;
  here.geometry = geometry;
  motion::PathMetric metric{motion.axis_count, 0};
  for (const int axis : geometry) {
    if (axis >= 0) metric.axes |= 1U << static_cast<unsigned>(axis);
  }
  const motion::Shape shape = motion::line(metric, start, line.end);
  if (shape.length <= 0.0) return std::nullopt;
  motion::Segment segment;
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  segment.feed_per_s = line.feed_per_s;
  segment.transform = line.transform;
  segment.bounds = motion::segment_bounds(segment, here);
  if (!is_above_limit(segment)) return std::nullopt;
  Diagnostic refusal;
  refusal.code = "E5302";
  refusal.message =
      text("the tap would need %.6g %s, but the limit of the axes is %.6g",
           s_per_min * segment.feed_per_s, "mm/min", s_per_min / segment.bounds.velocity);
  refusal.help = {"reduce the spindle speed, or cut a smaller lead"};
  return refusal;
}

}  // namespace stanok::channels
