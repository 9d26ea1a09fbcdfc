// Straightening: one line in place of lines with sharp corners that lie within tolerance of it.
//
// Steps of a few micrometres, as rasters and rounded coordinates make them, would each be a corner
// to stop or to blend at. A corner is left out when the line from the start of the one block to the
// end of the next passes it within the tolerance; all that a line leaves out stays within it as the
// line grows. docs/developer/motion.md#straightening. Owner: PathBuilder.
#pragma once

#include <optional>
#include <vector>

#include "motion/path/path.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

class Straightening {
 public:
  explicit Straightening(const MotionConfig& config) : config_(config) {}

  // `line` goes on to the end of `next`, with its tag, when the corners left out are within
  // `allowed` of it then; returns how far off they are. None: nothing has changed.
  [[nodiscard]] std::optional<Tolerance> extend(Segment& line, const Segment& next,
                                                const Tolerance& allowed);
  // The next block begins a line of its own.
  void begin() { left_out_.clear(); }

 private:
  [[nodiscard]] std::optional<Tolerance> deviation(const PathMetric& metric, const Point& from,
                                                   const Point& to) const;

  MotionConfig config_;
  std::vector<Point> left_out_;
};

}  // namespace stanok::motion
