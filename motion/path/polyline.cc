#include "motion/path/polyline.h"

#include <algorithm>

#include "base/place.h"

namespace stanok::motion {

void Polyline::add(const Segment& line, const Tolerance& tolerance) {
  const double t_start = legs_.empty() ? 0.0 : legs_.back().t_end;
  legs_.push_back({line, tolerance, t_start, t_start + line.length});
}

void Polyline::forget_before(double t) {
  while (legs_.size() > 1 && legs_.front().t_end <= t) legs_.pop_front();
}

std::size_t Polyline::index_at(double t) const {
  const auto behind =
      std::upper_bound(legs_.begin(), legs_.end(), t,
                       [](double place, const Leg& leg) { return place < leg.t_end; });
  return behind == legs_.end() ? legs_.size() - 1 : checked_size(behind - legs_.begin());
}

double Polyline::nearest_corner(double t) const {
  const Leg& around = leg(index_at(t));
  return t - around.t_start < around.t_end - t ? around.t_start : around.t_end;
}

Point Polyline::at(double t) const {
  return point_of(leg(index_at(t)), t);
}

Point point_of(const Leg& leg, double t) {
  const Geometry& line = leg.line.geometry;
  if (t == leg.t_start) return line.start;
  if (t == leg.t_end) return line.end;
  const double u = (t - leg.t_start) / leg.line.length;
  Point point = line.start;
  for (int k = 0; k < line.metric.axis_count; ++k) {
    point[k] += (line.end[k] - line.start[k]) * u;
  }
  return point;
}

}  // namespace stanok::motion
