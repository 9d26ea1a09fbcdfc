#include "motion/path/swing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "motion/path/arc_length.h"
#include "motion/path/deviation.h"
#include "motion/path/geometry.h"
#include "motion/path/point_algebra.h"

namespace stanok::motion {
namespace {

constexpr double reach_least = 1e-5;  // mm: below, the stored points no longer resolve the curve

// Two segments that meet in a corner.
struct Corner {
  const Segment& incoming;
  const Segment& outgoing;
  Contact before = contact_at(incoming, incoming.length);
  Contact behind = contact_at(outgoing, 0.0);
};

// Forms laid on the segments at a corner, with position and derivatives by the parameter t, -1 to
// 1. At t = 0, where the segments have a kink and a step of curvature, the curve has the means of
// both.
struct EvenCurve {
  const Corner& corner;
  SwingForm form;
  double reach = 0.0;

  [[nodiscard]] Contact at(double t) const {
    const bool is_before = t < 0.0;
    const Contact leg = is_before ? contact_at(corner.incoming, corner.incoming.length + t * reach)
                                  : contact_at(corner.outgoing, t * reach);
    const double side = is_before ? -1.0 : 1.0;
    const SwingForm::Deviation off = form.at(std::abs(t));
    const SwingForm::Deviation bent = StepForm::at(std::abs(t));
    Contact there;
    for (std::size_t k = 0; k < axes_max; ++k) {
      const double kink = reach * (corner.behind.tangent[k] - corner.before.tangent[k]);
      const double step = reach * reach * (corner.behind.curvature[k] - corner.before.curvature[k]);
      there.position[k] = leg.position[k] + off.value * kink + side * bent.value * step;
      there.tangent[k] = reach * leg.tangent[k] + side * off.first * kink + bent.first * step;
      there.curvature[k] =
          reach * reach * leg.curvature[k] + off.second * kink + side * bent.second * step;
    }
    return there;
  }
};

// The curve from knot to knot; neighbours share their points to the bit.
template <typename Curve>
std::vector<Shape> parts_of(const Curve& curve, const PathMetric& metric,
                            std::span<const double> knots) {
  std::vector<Shape> parts;
  Contact start = curve.at(knots.front());
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Contact end = curve.at(knots[i]);
    const double h = knots[i] - knots[i - 1];
    Geometry geometry;
    geometry.kind = SegmentKind::quintic;
    geometry.metric = metric;
    geometry.start = start.position;
    geometry.end = end.position;
    for (int k = 0; k < metric.axis_count; ++k) {
      geometry.coefficients[k] =
          quintic_between(start.position[k], h * start.tangent[k], h * h * start.curvature[k],
                          end.position[k], h * end.tangent[k], h * h * end.curvature[k]);
    }
    measure(geometry);
    parts.push_back({geometry, arc_length(geometry)});
    start = end;
  }
  return parts;
}

Swing even_swing(const Corner& corner, const SwingForm& form, double reach) {
  const EvenCurve curve{.corner = corner, .form = form, .reach = reach};
  const double turn = form.turn();
  const std::array<double, 5> knots{-1.0, -turn, 0.0, turn, 1.0};
  return {.parts = parts_of(curve, corner.incoming.geometry.metric, knots), .reach = reach};
}

// With arcs the deviation is sampled, and the reach becomes smaller until it is within tolerance.
std::optional<Swing> fit_swing_on_arcs(const Segment& incoming, const Segment& outgoing,
                                       double reach_max, const Tolerance& tolerance,
                                       const MotionConfig& config) {
  const Tolerance used = used_by_curves(tolerance);
  const SwingForm form(SwingForm::turn_min);
  const Growth grown = growth(incoming, outgoing,
                              {.kink = form.at_corner(), .step = StepForm::largest}, used, config);
  const Corner corner{incoming, outgoing};
  double reach = std::min({reach_max, grown.reach(), replaceable(incoming), replaceable(outgoing)});
  constexpr int attempts = 16;
  for (int i = 0; i < attempts && reach >= reach_least; ++i) {
    Swing swing = even_swing(corner, form, reach);
    const double share =
        deviation_share(swing.parts, swing.reach, incoming, outgoing, used, config);
    if (share <= 1.0) return swing;
    reach *= std::clamp(0.98 * std::pow(share, -1.0 / grown.exponent(reach)), 0.1, 0.9);
  }
  return std::nullopt;
}

}  // namespace

bool is_between_lines(const Segment& incoming, const Segment& outgoing) {
  return incoming.geometry.kind == SegmentKind::line && outgoing.geometry.kind == SegmentKind::line;
}

// D''(1) = 0, D'(1) = 0, D(1) = 0 with D'(0) = -1/2, half of the kink.
SwingForm::SwingForm(double turn)
    : turn_(turn),
      slope_(1.0 / (2.0 * turn * turn - 1.0)),
      bend_(slope_ * (2.0 * turn - 1.0)),
      at_corner_(0.5 - slope_ * (turn * turn - turn * turn * turn / 3.0 - 1.0 / 3.0)) {}

SwingForm SwingForm::with_deviation(double deviation) {
  double low = turn_min;
  double high = 1.0;
  constexpr int halvings = 40;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (SwingForm(middle).at_corner() > deviation ? high : low) = middle;
  }
  return SwingForm(low);
}

SwingForm::Deviation SwingForm::at(double t) const {
  if (t <= turn_) {
    return {.value = at_corner_ + t * (-0.5 + t * (0.5 * bend_ - t * slope_ / 6.0)),
            .first = -0.5 + t * (bend_ - 0.5 * t * slope_),
            .second = bend_ - t * slope_};
  }
  const double left = 1.0 - t;
  return {.value = -slope_ * left * left * left / 6.0,
          .first = 0.5 * slope_ * left * left,
          .second = -slope_ * left};
}

SwingForm::Deviation StepForm::at(double t) {
  // D'(1) = 0 gives the derivative at 0.
  constexpr double rest = 1.0 - turn;
  constexpr double at_corner = 0.5 * turn - 0.5 * slope * (turn * turn + rest * rest);
  if (t <= turn) {
    return {.value = t * (at_corner + t * (-0.25 + t * slope / 6.0)),
            .first = at_corner + t * (-0.5 + 0.5 * t * slope),
            .second = -0.5 + t * slope};
  }
  const double left = 1.0 - t;
  return {.value = slope * left * left * left / 6.0,
          .first = -0.5 * slope * left * left,
          .second = slope * left};
}

double full_swing_reach(const Segment& incoming, const Segment& outgoing,
                        const Tolerance& tolerance, const MotionConfig& config) {
  return corner_reach(incoming, outgoing, used_by_curves(tolerance), config) /
         SwingForm(SwingForm::turn_min).at_corner();
}

std::optional<Swing> fit_swing(const Segment& incoming, const Segment& outgoing, double reach_max,
                               const Tolerance& tolerance, const MotionConfig& config) {
  if (!is_between_lines(incoming, outgoing))
    return fit_swing_on_arcs(incoming, outgoing, reach_max, tolerance, config);
  // Deviations of a form are shares of its reach and of the kink, which `allowed` has in it.
  const double allowed = corner_reach(incoming, outgoing, used_by_curves(tolerance), config);
  const double reach = std::min({reach_max, allowed / SwingForm(SwingForm::turn_min).at_corner(),
                                 incoming.length, outgoing.length});
  if (reach < reach_least || allowed >= SwingForm(1.0).at_corner() * reach) return std::nullopt;
  return even_swing({incoming, outgoing}, SwingForm::with_deviation(allowed / reach), reach);
}

}  // namespace stanok::motion
