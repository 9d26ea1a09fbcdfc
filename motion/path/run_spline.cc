#include "motion/path/run_spline.h"

#include "motion/path/point_algebra.h"

namespace stanok::motion {

double RunSpline::greville(std::size_t middle) const {
  return (knots[middle - 1] + knots[middle] + knots[middle + 1]) / 3.0;
}

bool RunSpline::is_straight(std::size_t span) const {
  return greville(span + 3) <= way.leg(way.index_at(greville(span - 2))).t_end;
}

RunSpline::ControlPoints RunSpline::control_points(std::size_t span) const {
  std::array<double, 6> t;
  std::array<Point, 6> point;
  for (std::size_t k = 0; k < t.size(); ++k) {
    t[k] = greville(span - 2 + k);
    point[k] = way.at(t[k]);
  }
  ControlPoints control;
  for (std::size_t k = 0; k < control.size(); ++k) {
    const std::size_t middle = span - 1 + k;
    const double a = width(middle - 1);
    const double b = width(middle);
    // The square of the mean of the three knots less the mean of the products of two of them.
    const double spread = (a * a + b * b + (a + b) * (a + b)) / 18.0;
    control[k] = point[k + 1];
    if (spread == 0.0) continue;  // an end of the spline
    const double before = t[k + 1] - t[k];
    const double after = t[k + 2] - t[k + 1];
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      const double bent = ((point[k + 2][axis] - point[k + 1][axis]) / after -
                           (point[k + 1][axis] - point[k][axis]) / before) /
                          (before + after);
      control[k][axis] -= spread * bent;
    }
  }
  return control;
}

// By the blossom of the span: de Boor's algorithm with three places.
RunSpline::ControlPoints RunSpline::bezier(std::size_t span, const ControlPoints& control, double a,
                                           double b) const {
  const auto blossom = [&](double x, double y, double z) {
    ControlPoints d = control;
    const std::array<double, 3> places{x, y, z};
    for (std::size_t r = 1; r <= 3; ++r) {
      for (std::size_t k = 3; k >= r; --k) {
        const double low = knots[span - 3 + k];
        const double high = knots[span + 1 + k - r];
        d[k] = between(d[k - 1], d[k], (places[r - 1] - low) / (high - low));
      }
    }
    return d[3];
  };
  return {blossom(a, a, a), blossom(a, a, b), blossom(a, b, b), blossom(b, b, b)};
}

}  // namespace stanok::motion
