// Polyline: the programmed path of a run of straight blocks, as points over its own length t.
//
// t counts in mm from the start of the first block ever added. Before the first and behind the last
// leg the path goes on straight, so that a spline may have its knots there.
#pragma once

#include <cstddef>
#include <deque>

#include "motion/path/path.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// One block of the run.
struct Leg {
  Segment line;
  Tolerance tolerance;
  double t_start = 0.0;
  double t_end = 0.0;
};

class Polyline {
 public:
  void clear() { legs_.clear(); }
  void add(const Segment& line, const Tolerance& tolerance);
  // Forgets legs that end at or before t; the last one stays.
  void forget_before(double t);

  [[nodiscard]] bool is_empty() const { return legs_.empty(); }
  [[nodiscard]] const Leg& last() const { return legs_.back(); }
  [[nodiscard]] double end() const { return legs_.back().t_end; }

  // The leg that contains t, by index from the oldest one kept; a place between two legs belongs to
  // the second.
  [[nodiscard]] std::size_t index_at(double t) const;
  [[nodiscard]] const Leg& leg(std::size_t index) const { return legs_[index]; }
  [[nodiscard]] std::size_t size() const { return legs_.size(); }
  // The end of a leg that lies nearest to t.
  [[nodiscard]] double nearest_corner(double t) const;

  [[nodiscard]] Point at(double t) const;
  // The mean of the points between t - half and t + half.
  [[nodiscard]] Point mean_around(double t, double half) const;

 private:
  std::deque<Leg> legs_;
};

// The point of a leg, or of its straight continuation, at t; its ends to the bit.
[[nodiscard]] Point point_of(const Leg& leg, double t);

}  // namespace stanok::motion
