// Points along a smooth curve as a CAM system sets them: dense where the curve bends, sparse where
// it is straight.
//
// The wanted chord at a place is sqrt(8 e / kappa), kappa = curvature, e = chord error, kept
// between two bounds. A curve is split into a given number of chords by equal parts of the integral
// of 1 / wanted chord, so that the number of blocks is exact and the spacing follows the shape.
#pragma once

#include <functional>
#include <vector>

#include "programs/generators/program_writer.h"

namespace stanok::programs {

struct Spacing {
  double chord_error_mm = 0.002;
  double chord_min_mm = 0.1;
  double chord_max_mm = 0.4;
};

class CurveSplit {
 public:
  using Curve = std::function<Point(double)>;

  // The curve between parameters `from` and `to`, in this direction; its X, Y, Z count.
  CurveSplit(const Curve& curve, double from, double to, const Spacing& spacing);

  // How many chords of the wanted length the curve takes.
  [[nodiscard]] double chords_wanted() const { return cumulative_.back(); }
  // Parameters of the ends of `count` chords, the last is `to`.
  [[nodiscard]] std::vector<double> ends(int count) const;

 private:
  double from_;
  double to_;
  std::vector<double> cumulative_;  // chords wanted up to each sample
};

// Splits `total` over rows in proportion to `weights`, exactly.
[[nodiscard]] std::vector<int> shares(const std::vector<double>& weights, int total);

}  // namespace stanok::programs
