// Knot spans to Bezier form by blossoming, rational derivatives, Hermite stretches
// (motion/path/nurbs.h).
#include "motion/path/nurbs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/place.h"
#include "motion/path/shape.h"

namespace stanok::motion {
namespace {

constexpr int halvings_max = 12;          // for the deviation
constexpr int halvings_at_cusp_max = 40;  // until next to nothing is left
// What has no direction, or turns it sharply, within this way is passed on its chord: the path has
// a corner there. Blocks as short as that do not move (a `standstill`, motion/path/block_metric.h).
constexpr double unseen_way = 1e-9;  // mm
constexpr int speed_samples = 8;
// The most by which the speed by the parameter may change within a stretch: where it grows out of
// next to nothing the curve is bent sharply, and what limits the path there must not hold for all
// of it.
constexpr double speed_ratio_max = 16.0;

using Homogeneous = std::array<double, 3>;  // w x, w y, w

Homogeneous part_way(const Homogeneous& a, const Homogeneous& b, double part) {
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
        d[k] = part_way(d[k - 1], d[k], (place - low) / (high - low));
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
    for (std::size_t k = 0; k + 1 < left; ++k) points[k] = part_way(points[k], points[k + 1], x);
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

// Makes the stretches of a curve, span by span.
class Stretcher {
 public:
  explicit Stretcher(double deviation) : deviation_(deviation) {}

  // Appends those between x0 and x1 of a span, which the parameter of the curve passes as
  // `number` + x.
  void stretch(const Span& span, double number, double x0, double x1, int halvings) {
    const CurvePoint from = span.at(x0);
    const CurvePoint to = span.at(x1);
    const bool has_cusp = changes_speed(span, x0, x1);
    if (has_cusp && (halvings >= halvings_at_cusp_max || way(span, x0, x1) < unseen_way))
      return add(chord(from, to), number + x1);
    const CurveStretch made = between_states(from, to, x1 - x0);
    if (has_cusp || (halvings < halvings_max && deviates(span, made, x0, x1))) {
      const double middle = 0.5 * (x0 + x1);
      stretch(span, number, x0, middle, halvings + 1);
      return stretch(span, number, middle, x1, halvings + 1);
    }
    add(made, number + x1);
  }

  // All of them, their ends as shares of a curve of so many spans.
  std::vector<CurveStretch> finish(double spans) {
    for (CurveStretch& made : made_) made.end /= spans;
    return std::move(made_);
  }

 private:
  // What has no length at all is passed with the stretch before it.
  void add(const CurveStretch& made, double end) {
    const bool moves = std::ranges::any_of(made.coefficients, [](const auto& of_axis) {
      return std::any_of(of_axis.begin() + 1, of_axis.end(), [](double c) { return c != 0.0; });
    });
    if (moves) made_.push_back(made);
    if (!made_.empty()) made_.back().end = end;
  }

  static CurveStretch chord(const CurvePoint& from, const CurvePoint& to) {
    CurveStretch made;
    for (std::size_t c = 0; c < 2; ++c)
      made.coefficients[c] = {from.position[c], to.position[c] - from.position[c]};
    return made;
  }

  static CurveStretch between_states(const CurvePoint& from, const CurvePoint& to, double h) {
    CurveStretch made;
    for (std::size_t c = 0; c < 2; ++c) {
      made.coefficients[c] =
          quintic_between(from.position[c], h * from.first[c], h * h * from.second[c],
                          to.position[c], h * to.first[c], h * h * to.second[c]);
    }
    return made;
  }

  // Between two samples the speed may be lower than at both, by what the second derivative allows.
  [[nodiscard]] static bool changes_speed(const Span& span, double x0, double x1) {
    const double step = (x1 - x0) / speed_samples;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    CurvePoint before = span.at(x0);
    for (int k = 1; k <= speed_samples; ++k) {
      const CurvePoint here = span.at(x0 + step * k);
      const double change = std::max(size(before.second), size(here.second));
      least = std::min(least, 0.5 * (size(before.first) + size(here.first) - step * change));
      most = std::max(most, size(here.first));
      before = here;
    }
    return !(least > 0.0 && most <= speed_ratio_max * least);
  }

  [[nodiscard]] static double way(const Span& span, double x0, double x1) {
    const double step = (x1 - x0) / speed_samples;
    double length = 0.0;
    std::array<double, 2> before = span.at(x0).position;
    for (int k = 1; k <= speed_samples; ++k) {
      const std::array<double, 2> here = span.at(x0 + step * k).position;
      length += std::hypot(here[0] - before[0], here[1] - before[1]);
      before = here;
    }
    return length;
  }

  [[nodiscard]] bool deviates(const Span& span, const CurveStretch& made, double x0,
                              double x1) const {
    for (int k = 1; k < speed_samples; ++k) {
      const double u = static_cast<double>(k) / speed_samples;
      const CurvePoint point = span.at(x0 + (x1 - x0) * u);
      if (std::hypot(value_of(made.coefficients[0], u) - point.position[0],
                     value_of(made.coefficients[1], u) - point.position[1]) > deviation_)
        return true;
    }
    return false;
  }

  double deviation_;
  std::vector<CurveStretch> made_;
};

}  // namespace

std::vector<CurveStretch> stretches_of(const PlanarNurbs& curve, double deviation) {
  std::vector<Homogeneous> control;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const double w = curve.weights.empty() ? 1.0 : curve.weights[k];
    control.push_back({w * curve.points[k][0], w * curve.points[k][1], w});
  }
  const std::size_t degree = checked_size(curve.degree);
  const std::size_t spans = control.size() - degree;
  Stretcher stretcher(deviation);
  for (std::size_t s = 0; s < spans; ++s)
    stretcher.stretch(Span(bezier_of(control, degree, s)), static_cast<double>(s), 0.0, 1.0, 0);
  return stretcher.finish(static_cast<double>(spans));
}

}  // namespace stanok::motion
