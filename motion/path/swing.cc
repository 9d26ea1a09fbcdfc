#include "motion/path/swing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "motion/path/arc_length.h"
#include "motion/path/deviation.h"
#include "motion/path/geometry.h"
#include "motion/path/point_algebra.h"

namespace stanok::motion {
namespace {

constexpr double reach_least = 1e-5;  // mm: below, the stored points no longer resolve the curve

bool is_between_lines(const Segment& incoming, const Segment& outgoing) {
  return incoming.geometry.kind == SegmentKind::line && outgoing.geometry.kind == SegmentKind::line;
}

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
    const Contact leg = is_before
                            ? contact_at(corner.incoming, corner.incoming.length + t * reach)
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

// Two legs from rest, of which the incoming one goes backwards; `overlap` is the parameter at which
// each is as far from the corner as the other, t = 0 of the curve.
struct CurveFromRest {
  const Corner& corner;
  double overlap = 0.0;
  double scale = 0.0;  // mm, how far each leg goes back

  [[nodiscard]] Contact at(double t) const {
    const SwingForm::Deviation before = LegFromRest::at(overlap - t);
    const SwingForm::Deviation behind = LegFromRest::at(overlap + t);
    Contact there;
    for (std::size_t k = 0; k < axes_max; ++k) {
      const double in = corner.before.tangent[k];
      const double out = corner.behind.tangent[k];
      there.position[k] = corner.before.position[k] + scale * (out * behind.value - in * before.value);
      there.tangent[k] = scale * (out * behind.first + in * before.first);
      there.curvature[k] = scale * (out * behind.second - in * before.second);
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

// How far a leg may go back: its point is then beside the other leg, or, where the path turns by
// more than a right angle, nearest to the corner.
double way_back(const Corner& corner, const PathMetric& metric, const Tolerance& tolerance,
                const MotionConfig& config) {
  const double cosine =
      std::max(metric_product(metric, corner.before.tangent, corner.behind.tangent), 0.0);
  const auto beside = [cosine](const Point& leg, const Point& other) {
    Point off;
    for (std::size_t k = 0; k < axes_max; ++k) off[k] = leg[k] - cosine * other[k];
    return off;
  };
  double way = unlimited;
  const Point& in = corner.before.tangent;
  const Point& out = corner.behind.tangent;
  for (const Point& off : {beside(in, out), beside(out, in)}) {
    way = std::min(way, tolerance.mm / geometry_norm(config, off));
    for (int k = 0; k < config.axis_count; ++k) {
      if (is_geometry_axis(config, k)) continue;
      way = std::min(way, axis_tolerance(config, k, tolerance) / std::abs(off[k]));
    }
  }
  return way;
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
    const Swing swing = even_swing(corner, form, reach);
    const double share =
        deviation_share(swing.parts, swing.reach, incoming, outgoing, used, config);
    if (share <= 1.0) return swing;
    reach *= std::clamp(0.98 * std::pow(share, -1.0 / grown.exponent(reach)), 0.1, 0.9);
  }
  return std::nullopt;
}

}  // namespace

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

// Back: the third derivative is -1 up to `change`, 1 up to the turning point and beyond. In the
// last part of the way back, read backwards from rest, a velocity B^2 / 2 is taken away by two
// changes of C = B / sqrt(2) each: B^3 (1/3 + 1/(2 sqrt(2))) = 1.
double LegFromRest::change() {
  static const double at_turn = std::cbrt(1.0 / (1.0 / 3.0 + 0.5 * std::numbers::sqrt2 / 2.0));
  return at_turn / std::numbers::sqrt2;
}

SwingForm::Deviation LegFromRest::at(double t) {
  const double c = change();
  if (t <= c) return {.value = -t * t * t / 6.0, .first = -0.5 * t * t, .second = -t};
  const double r = t - c;
  return {.value = -c * c * c / 6.0 - r * (0.5 * c * c + r * (0.5 * c - r / 6.0)),
          .first = -0.5 * c * c - r * (c - 0.5 * r),
          .second = r - c};
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

double LegFromRest::time_of(double value) {
  double low = change() * (2.0 + std::numbers::sqrt2);  // the turning point
  double high = 2.0 * low + std::cbrt(6.0 * std::max(value, 0.0));
  constexpr int halvings = 60;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (at(middle).value > value ? high : low) = middle;
  }
  return high;
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
  const double reach =
      std::min({reach_max, allowed / SwingForm(SwingForm::turn_min).at_corner(), incoming.length,
                outgoing.length});
  if (reach < reach_least || allowed >= SwingForm(1.0).at_corner() * reach) return std::nullopt;
  return even_swing({incoming, outgoing}, SwingForm::with_deviation(allowed / reach), reach);
}

std::optional<SwingFromRest> swing_from_rest(const Segment& incoming, const Segment& outgoing,
                                             double reach_max, const Tolerance& tolerance,
                                             const MotionConfig& config) {
  if (!is_between_lines(incoming, outgoing)) return std::nullopt;
  const Tolerance used = used_by_curves(tolerance);
  const double at_corner = corner_reach(incoming, outgoing, used, config);
  const double way = way_back({incoming, outgoing}, incoming.geometry.metric, used, config);
  SwingFromRest swing{.overlap = LegFromRest::time_of(at_corner / way)};
  const double farthest = LegFromRest::at(2.0 * swing.overlap).value;
  const double room = std::min({reach_max, incoming.length, outgoing.length});
  swing.scale = std::min(way, room / farthest);
  swing.reach = farthest * swing.scale;
  if (swing.scale < reach_least) return std::nullopt;
  return swing;
}

Swing SwingFromRest::between(const Segment& incoming, const Segment& outgoing) const {
  const Corner corner{incoming, outgoing};
  const CurveFromRest curve{.corner = corner, .overlap = overlap, .scale = scale};
  const double inner = overlap - LegFromRest::change();
  const std::array<double, 7> knots{-overlap, -inner, -0.5 * inner, 0.0, 0.5 * inner,
                                    inner,    overlap};
  return {.parts = parts_of(curve, incoming.geometry.metric, knots), .reach = reach};
}

SwingFromRest::End SwingFromRest::end_with_jerk(double jerk) const {
  const double unit = std::cbrt(scale / jerk);
  const SwingForm::Deviation end = LegFromRest::at(2.0 * overlap);
  return {.duration = 2.0 * overlap * unit,
          .v = scale / unit * end.first,
          .a = scale / (unit * unit) * end.second};
}

}  // namespace stanok::motion
