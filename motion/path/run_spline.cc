#include "motion/path/run_spline.h"

#include "motion/path/point_algebra.h"

namespace stanok::motion {
namespace {

// Of the distance to the next knot. So much that what rounded coordinates add is averaged over the
// blocks of half a span; corners are still followed closely.
constexpr double window_part = 0.5;

}  // namespace

double RunSpline::greville(std::size_t middle) const {
  return (knots[middle - 1] + knots[middle] + knots[middle + 1]) / 3.0;
}

double RunSpline::half_window(std::size_t middle) const {
  const double t = greville(middle);
  return window_part * std::min(t - knots[middle - 1], knots[middle + 1] - t);
}

bool RunSpline::is_straight(std::size_t span) const {
  const double from = greville(span - 2) - half_window(span - 2);
  const double to = greville(span + 3) + half_window(span + 3);
  return to <= way.leg(way.index_at(from)).t_end;
}

RunSpline::ControlPoints RunSpline::control_points(std::size_t span) const {
  std::array<double, 6> t;
  std::array<double, 6> h2;  // squares of half the windows
  std::array<Point, 6> point;
  for (std::size_t k = 0; k < t.size(); ++k) {
    t[k] = greville(span - 2 + k);
    const double half = half_window(span - 2 + k);
    h2[k] = half * half;
    point[k] = way.mean_around(t[k], half);
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
    // Of a quadratic the mean lies off by h^2 / 6 of its second derivative, and second differences
    // of means tell as much more as these grow.
    const double growth =
        ((h2[k + 2] - h2[k + 1]) / after - (h2[k + 1] - h2[k]) / before) / (before + after);
    const double taken = (spread + h2[k + 1] / 3.0) / (1.0 + growth / 3.0);
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      const double bent = ((point[k + 2][axis] - point[k + 1][axis]) / after -
                           (point[k + 1][axis] - point[k][axis]) / before) /
                          (before + after);
      control[k][axis] -= taken * bent;
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
