// Knot spans to Bezier form by blossoming, rational derivatives, Hermite stretches
// (motion/nurbs.h).
#include "motion/nurbs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/shape.h"

namespace stanok::motion {
namespace {

constexpr int halvings_max = 12;
constexpr int speed_samples = 8;
// Speed by the parameter, as a share of the control polygon's length, below which a curve is taken
// to stand still.
constexpr double parameter_speed_min = 1e-6;
// The most by which this speed may change within a stretch: where it grows out of next to nothing
// the curve is bent sharply, and what limits the path there must not hold for all of it.
constexpr double speed_ratio_max = 16.0;

using Homogeneous = std::array<double, 3>;  // w x, w y, w

Homogeneous between(const Homogeneous& a, const Homogeneous& b, double part) {
  Homogeneous h;
  for (std::size_t k = 0; k < h.size(); ++k) h[k] = a[k] + (b[k] - a[k]) * part;
  return h;
}

// Uniform clamped knot `index` of a curve with `spans` spans.
double knot(std::size_t index, std::size_t degree, std::size_t spans) {
  if (index <= degree) return 0.0;
  return static_cast<double>(std::min(index - degree, spans));
}

// Bezier points of knot span `span`, by the blossom of de Boor's algorithm.
std::vector<Homogeneous> bezier_of(const std::vector<Homogeneous>& control, std::size_t degree,
                                   std::size_t span) {
  const std::size_t spans = control.size() - degree;
  std::vector<Homogeneous> bezier;
  bezier.reserve(degree + 1);
  for (std::size_t i = 0; i <= degree; ++i) {
    std::vector<Homogeneous> d(control.begin() + static_cast<std::ptrdiff_t>(span),
                               control.begin() + static_cast<std::ptrdiff_t>(span + degree + 1));
    for (std::size_t r = 1; r <= degree; ++r) {
      const double place = static_cast<double>(r <= i ? span + 1 : span);
      for (std::size_t k = degree; k >= r; --k) {
        const double low = knot(span + k, degree, spans);
        const double high = knot(span + k + degree + 1 - r, degree, spans);
        d[k] = between(d[k - 1], d[k], (place - low) / (high - low));
      }
    }
    bezier.push_back(d[degree]);
  }
  return bezier;
}

// Position and derivatives by the parameter.
struct CurvePoint {
  std::array<double, 2> position{};
  std::array<double, 2> first{};
  std::array<double, 2> second{};
};

double size(const std::array<double, 2>& vector) {
  return std::hypot(vector[0], vector[1]);
}

Homogeneous casteljau(std::vector<Homogeneous> points, double x) {
  for (std::size_t left = points.size(); left > 1; --left) {
    for (std::size_t k = 0; k + 1 < left; ++k) points[k] = between(points[k], points[k + 1], x);
  }
  return points.empty() ? Homogeneous{} : points[0];
}

std::vector<Homogeneous> differences(const std::vector<Homogeneous>& points) {
  std::vector<Homogeneous> steps;
  const auto degree = static_cast<double>(points.size()) - 1.0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    Homogeneous step;
    for (std::size_t c = 0; c < 3; ++c) step[c] = degree * (points[k + 1][c] - points[k][c]);
    steps.push_back(step);
  }
  return steps;
}

// One knot span with its hodographs.
class Span {
 public:
  explicit Span(std::vector<Homogeneous> bezier)
      : points_(std::move(bezier)), first_(differences(points_)), second_(differences(first_)) {}

  [[nodiscard]] CurvePoint at(double x) const {
    const Homogeneous n = casteljau(points_, x);
    const Homogeneous n1 = casteljau(first_, x);
    const Homogeneous n2 = casteljau(second_, x);
    CurvePoint point;
    for (std::size_t c = 0; c < 2; ++c) {
      point.position[c] = n[c] / n[2];
      point.first[c] = (n1[c] - n1[2] * point.position[c]) / n[2];
      point.second[c] = (n2[c] - 2.0 * n1[2] * point.first[c] - n2[2] * point.position[c]) / n[2];
    }
    return point;
  }

 private:
  std::vector<Homogeneous> points_;
  std::vector<Homogeneous> first_;
  std::vector<Homogeneous> second_;
};

double value_of(const std::array<double, 6>& c, double u) {
  return ((((c[5] * u + c[4]) * u + c[3]) * u + c[2]) * u + c[1]) * u + c[0];
}

// Appends the stretches of a span between x0 and x1; false when the curve stands still there.
class Stretcher {
 public:
  Stretcher(const Span& span, double deviation, double speed_least)
      : span_(span), deviation_(deviation), speed_least_(speed_least) {}

  bool stretch(double x0, double x1, int halvings, std::vector<CurveStretch>& out) const {
    const CurvePoint from = span_.at(x0);
    const CurvePoint to = span_.at(x1);
    if (size(from.first) < speed_least_ || size(to.first) < speed_least_) return false;
    const double h = x1 - x0;
    CurveStretch made;
    made.end = x1;
    for (std::size_t c = 0; c < 2; ++c) {
      made.coefficients[c] =
          quintic_between(from.position[c], h * from.first[c], h * h * from.second[c],
                          to.position[c], h * to.first[c], h * h * to.second[c]);
    }
    if (halvings < halvings_max && (deviates(made, x0, x1) || changes_speed(x0, x1))) {
      const double middle = 0.5 * (x0 + x1);
      return stretch(x0, middle, halvings + 1, out) && stretch(middle, x1, halvings + 1, out);
    }
    out.push_back(made);
    return true;
  }

 private:
  // Between two samples the speed may be lower than at both, by what the second derivative allows.
  [[nodiscard]] bool changes_speed(double x0, double x1) const {
    const double step = (x1 - x0) / speed_samples;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    CurvePoint before = span_.at(x0);
    for (int k = 1; k <= speed_samples; ++k) {
      const CurvePoint here = span_.at(x0 + step * k);
      const double change = std::max(size(before.second), size(here.second));
      least = std::min(least, 0.5 * (size(before.first) + size(here.first) - step * change));
      most = std::max(most, size(here.first));
      before = here;
    }
    return most > speed_ratio_max * least;
  }

  [[nodiscard]] bool deviates(const CurveStretch& made, double x0, double x1) const {
    for (int k = 1; k < speed_samples; ++k) {
      const double u = static_cast<double>(k) / speed_samples;
      const CurvePoint point = span_.at(x0 + (x1 - x0) * u);
      if (std::hypot(value_of(made.coefficients[0], u) - point.position[0],
                     value_of(made.coefficients[1], u) - point.position[1]) > deviation_)
        return true;
    }
    return false;
  }

  const Span& span_;
  double deviation_;
  double speed_least_;
};

double polygon_length(const std::vector<std::array<double, 2>>& points) {
  double length = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    length += std::hypot(points[k][0] - points[k - 1][0], points[k][1] - points[k - 1][1]);
  }
  return length;
}

}  // namespace

std::vector<CurveStretch> stretches_of(const PlanarNurbs& curve, double deviation) {
  std::vector<Homogeneous> control;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const double w = curve.weights.empty() ? 1.0 : curve.weights[k];
    control.push_back({w * curve.points[k][0], w * curve.points[k][1], w});
  }
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t spans = control.size() - degree;
  const double speed_least =
      parameter_speed_min * polygon_length(curve.points) / static_cast<double>(spans);
  std::vector<CurveStretch> stretches;
  for (std::size_t s = 0; s < spans; ++s) {
    const Span span(bezier_of(control, degree, s));
    const std::size_t first = stretches.size();
    if (!Stretcher(span, deviation, speed_least).stretch(0.0, 1.0, 0, stretches)) return {};
    for (std::size_t k = first; k < stretches.size(); ++k) {
      stretches[k].end = (static_cast<double>(s) + stretches[k].end) / static_cast<double>(spans);
    }
  }
  return stretches;
}

}  // namespace stanok::motion
