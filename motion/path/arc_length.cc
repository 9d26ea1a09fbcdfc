// Gauss-Legendre integration of the parametric speed and its inversion (motion/path/arc_length.h).
// Nodes and weights: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, table 25.4.
#include "motion/path/arc_length.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stanok::motion {
namespace {

constexpr int knot_count = 9;
constexpr double knot_spacing = 1.0 / (knot_count - 1);
constexpr int iterations_max = 8;

struct Node {
  double place;  // in [0, 1], mirrored at 0
  double weight;
};
constexpr std::array<Node, 4> nodes{{{0.183434642495649804939, 0.362683783378361982965},
                                     {0.525532409916328985818, 0.313706645877887287338},
                                     {0.796666477413626739592, 0.222381034453374470544},
                                     {0.960289856497536231684, 0.101228536290376259153}}};

// The speed and its derivative by u.
struct Speed {
  double value;
  double slope;
};

double quintic_speed(const Geometry& g, double u) RT_SAFE {
  double squared = 0.0;
  for (int k = 0; k < g.metric.axis_count; ++k) {
    if (!g.metric.counts(k)) continue;
    const auto& c = g.coefficients[k];
    const double first =
        (((5.0 * c[5] * u + 4.0 * c[4]) * u + 3.0 * c[3]) * u + 2.0 * c[2]) * u + c[1];
    squared += first * first;
  }
  return std::sqrt(squared);
}

Speed quintic_speed_and_slope(const Geometry& g, double u) RT_SAFE {
  double squared = 0.0;
  double product = 0.0;
  for (int k = 0; k < g.metric.axis_count; ++k) {
    if (!g.metric.counts(k)) continue;
    const auto& c = g.coefficients[k];
    const double first =
        (((5.0 * c[5] * u + 4.0 * c[4]) * u + 3.0 * c[3]) * u + 2.0 * c[2]) * u + c[1];
    const double second = ((20.0 * c[5] * u + 12.0 * c[4]) * u + 6.0 * c[3]) * u + 2.0 * c[2];
    squared += first * first;
    product += first * second;
  }
  const double value = std::sqrt(squared);
  return {value, product / value};
}

// Squared length of the arc's linear part, per u.
double straight_squared(const Geometry& g) RT_SAFE {
  double squared = 0.0;
  for (int k = 0; k < g.metric.axis_count; ++k) {
    const bool in_plane = k == g.plane[0] || k == g.plane[1];
    if (in_plane || !g.metric.counts(k)) continue;
    squared += (g.end[k] - g.start[k]) * (g.end[k] - g.start[k]);
  }
  return squared;
}

// ds/du of an arc: sqrt((sweep r)^2 + r'^2 + straight^2), r linear in u.
double arc_speed(const Geometry& g, double constant_squared, double u) RT_SAFE {
  const double around = g.sweep * (g.radius + g.radius_change * u);
  return std::sqrt(around * around + constant_squared);
}

template <class Integrand>
double integral(double from, double to, Integrand integrand) RT_SAFE {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0.0;
  for (const Node& node : nodes) {
    const double offset = half * node.place;
    sum += node.weight * (integrand(middle - offset) + integrand(middle + offset));
  }
  return half * sum;
}

double quintic_length(const Geometry& g, double from, double to) RT_SAFE {
  return integral(from, to, [&g](double u) RT_SAFE { return quintic_speed(g, u); });
}

double arc_length_to(const Geometry& g, double constant_squared, double u) RT_SAFE {
  return integral(0.0, u, [&g, constant_squared](double at) RT_SAFE {
    return arc_speed(g, constant_squared, at);
  });
}

// Cubic Hermite interpolation of u(s) between the knots k and k + 1.
double first_guess(const Geometry& g, std::size_t k, double s) RT_SAFE {
  const double u0 = static_cast<double>(k) * knot_spacing;
  const double ds = g.knots[k + 1] - g.knots[k];
  const double x = (s - g.knots[k]) / ds;
  const double slope0 = ds / quintic_speed(g, u0);
  const double slope1 = ds / quintic_speed(g, u0 + knot_spacing);
  const double y = 1.0 - x;
  return u0 + x * x * (3.0 - 2.0 * x) * knot_spacing + x * y * (y * slope0 - x * slope1);
}

double quintic_parameter(const Geometry& g, double s) RT_SAFE {
  std::size_t k = 0;
  while (k + 2 < knot_count && s >= g.knots[k + 1]) ++k;
  const double lower = static_cast<double>(k) * knot_spacing;
  const double upper = lower + knot_spacing;
  double u = std::clamp(first_guess(g, k, s), lower, upper);
  for (int i = 0; i < iterations_max; ++i) {
    const std::size_t nearest = u - lower < 0.5 * knot_spacing ? k : k + 1;
    const double knot = static_cast<double>(nearest) * knot_spacing;
    const double excess = g.knots[nearest] + quintic_length(g, knot, u) - s;
    const Speed speed = quintic_speed_and_slope(g, u);
    const double newton = excess / speed.value;
    const double step = newton * (1.0 + 0.5 * newton * speed.slope / speed.value);
    u = std::clamp(u - step, lower, upper);
    // The step leaves an error of the order of its cube.
    if (std::abs(step) < 2e-6) break;
  }
  return u;
}

double arc_parameter(const Geometry& g, double s, double length) RT_SAFE {
  double u = s / length;
  if (g.radius_change == 0.0) return u;
  const double constant_squared = straight_squared(g) + g.radius_change * g.radius_change;
  for (int i = 0; i < iterations_max; ++i) {
    const double excess = arc_length_to(g, constant_squared, u) - s;
    const double step = excess / arc_speed(g, constant_squared, u);
    u = std::clamp(u - step, 0.0, 1.0);
    if (std::abs(step) < 1e-9) break;  // Newton: the error left is of the order of its square
  }
  return u;
}

}  // namespace

double arc_length(const Geometry& geometry) RT_SAFE {
  if (geometry.kind == SegmentKind::quintic) return geometry.knots.back();
  if (geometry.kind == SegmentKind::arc) {
    const double change = geometry.radius_change;
    const double straight = straight_squared(geometry);
    if (change == 0.0) return std::hypot(geometry.radius * geometry.sweep, std::sqrt(straight));
    return arc_length_to(geometry, straight + change * change, 1.0);
  }
  double squared = 0.0;
  for (int k = 0; k < geometry.metric.axis_count; ++k) {
    const double way = geometry.end[k] - geometry.start[k];
    if (geometry.metric.counts(k)) squared += way * way;
  }
  return std::sqrt(squared);
}

void measure(Geometry& quintic) RT_SAFE {
  quintic.knots[0] = 0.0;
  for (std::size_t k = 1; k < knot_count; ++k) {
    const double to = static_cast<double>(k) * knot_spacing;
    const double middle = to - 0.5 * knot_spacing;
    quintic.knots[k] = quintic.knots[k - 1] + quintic_length(quintic, to - knot_spacing, middle) +
                       quintic_length(quintic, middle, to);
  }
}

double parameter_at(const Geometry& geometry, double s, double length) RT_SAFE {
  if (s <= 0.0) return 0.0;
  if (s >= length) return 1.0;
  switch (geometry.kind) {
    case SegmentKind::quintic:
      return quintic_parameter(geometry, s);
    case SegmentKind::arc:
      return arc_parameter(geometry, s, length);
    case SegmentKind::line:
    case SegmentKind::even:
      break;
  }
  return s / length;
}

}  // namespace stanok::motion
