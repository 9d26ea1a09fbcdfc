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

// By trapezoids from corner to corner, exact; relative to the point at t, so that it is that point
// where the path is straight, but for rounding.
Point Polyline::mean_around(double t, double half) const {
  const Point middle = at(t);
  if (half <= 0.0) return middle;
  Point sum{};
  double from = t - half;
  Point before = at(from);
  for (std::size_t index = index_at(from); from < t + half; ++index) {
    const bool is_last = index + 1 >= legs_.size();
    const double to = is_last ? t + half : std::min(legs_[index].t_end, t + half);
    const Point point = point_of(legs_[std::min(index, legs_.size() - 1)], to);
    for (std::size_t k = 0; k < axes_max; ++k)
      sum[k] += 0.5 * (to - from) * ((before[k] - middle[k]) + (point[k] - middle[k]));
    from = to;
    before = point;
  }
  Point mean = middle;
  for (std::size_t k = 0; k < axes_max; ++k) mean[k] += sum[k] / (2.0 * half);
  return mean;
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
