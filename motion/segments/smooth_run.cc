// Where knots stand, and segments of the spline (motion/segments/smooth_run.h).
#include "motion/segments/smooth_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/bounds/segment_bounds.h"
#include "motion/path/arc_length.h"
#include "motion/path/point_algebra.h"
#include "motion/path/shape.h"

namespace stanok::motion {
namespace {

constexpr double length_min = 1e-4;            // mm of a block, and of its part before the spline
constexpr double tolerance_min = 2e-4;         // mm: below, corners are left to blends
constexpr double rate_step_max = 1000.0;       // tolerances of another axis per mm, at a corner
constexpr double chord_part_max = 0.25;        // of the tolerance
constexpr double run_tolerance_used = 0.99;    // the rest is for rounding of every kind
constexpr double width_max = 2.0;              // mm between two knots
constexpr std::size_t legs_per_span_max = 32;  // and so many blocks
constexpr double width_min = 1e-5;             // mm
constexpr double width_growth = 2.0;           // of the distance from knot to knot
constexpr double ratio_max = 2.5;              // of neighbouring distances, once settled
constexpr double snap = 0.3;  // part of the distance by which a knot goes to a corner
constexpr std::size_t spans_behind_corner = 5;  // on a long block, before one long span
constexpr std::size_t lag = 24;                 // spans that may still change
constexpr std::size_t graded = 40;              // spans around new knots that are looked at
constexpr double forward_min = 0.5;             // of the spline along its block, per t

// How far the chord between two setpoints lies off a curve at most, (v T)^2 / 8R: the axes hold
// v^2 / R within their accelerations, whatever the feed and its override.
Tolerance chord_margin(const MotionConfig& config) {
  Point acceleration{};
  double rotary = 0.0;
  for (int k = 0; k < config.axis_count; ++k) {
    acceleration[k] = config.axes[k].acceleration_max;
    if (!config.axes[k].linear) rotary = std::max(rotary, acceleration[k]);
  }
  const double part = config.cycle_s * config.cycle_s / 8.0;
  return {part * geometry_norm(config, acceleration), part * rotary};
}

bool is_run_block(const Segment& segment) {
  return segment.geometry.kind == SegmentKind::line && !segment.rapid &&
         segment.length >= length_min;
}

}  // namespace

SmoothRun::SmoothRun(const MotionConfig& config)
    : config_(config),
      chord_margin_(chord_margin(config)),
      turn_cosine_min_(std::cos(config.run_turn_max_deg * std::numbers::pi / 180.0)) {}

bool SmoothRun::may_join(const Segment& incoming, const Segment& outgoing,
                         const Tolerance& tolerance) const {
  if (config_.run_turn_max_deg <= 0.0) return false;
  if (!is_run_block(incoming) || !is_run_block(outgoing)) return false;
  if (!(tolerance.mm >= tolerance_min && tolerance.deg > 0.0)) return false;
  const PathMetric& metric = incoming.geometry.metric;
  if (metric != outgoing.geometry.metric || incoming.transform != outgoing.transform) return false;
  double cosine = 0.0;
  for (int k = 0; k < metric.axis_count; ++k) {
    const double before = (incoming.geometry.end[k] - incoming.geometry.start[k]) / incoming.length;
    const double after = (outgoing.geometry.end[k] - outgoing.geometry.start[k]) / outgoing.length;
    if (metric.counts(k)) {
      cosine += before * after;
    } else if (std::abs(after - before) > rate_step_max * std::min(tolerance.mm, tolerance.deg)) {
      return false;
    }
  }
  return cosine >= turn_cosine_min_;
}

void SmoothRun::clear() {
  spline_.way.clear();
  spline_.knots.clear();
  straight_ = {};
  settled_ = 0;
  emitted_ = 0;
  frozen_ = 0;
}

// What chords may take of a tolerance: as much as they ever need, but not most of it.
Tolerance SmoothRun::chord_share(const Tolerance& tolerance) const {
  return lower_of(chord_margin_, {chord_part_max * tolerance.mm, chord_part_max * tolerance.deg});
}

// Bounds of a segment, and a speed at which its chords keep their share: v^2 * curvature is the
// part of the accelerations that is used across the path, and the chords use as large a part of
// chord_margin_.
SegmentBounds SmoothRun::bounds_of(const Segment& segment, const Tolerance& tolerance) const {
  SegmentBounds bounds = segment_bounds(segment, config_);
  const Tolerance share = chord_share(tolerance);
  const double part = std::max(chord_margin_.mm / share.mm, chord_margin_.deg / share.deg);
  if (part > 1.0) bounds.chords = std::sqrt(bounds.curvature * part);
  return bounds;
}

SmoothRun::Place SmoothRun::begin(const Segment& first, const Tolerance& tolerance, End end,
                                  const Place& taken) {
  clear();
  spline_.way.add(first, tolerance);
  Place place = taken;
  if (end == End::at_rest) {
    spline_.knots.assign(RunSpline::order, place.s);
  } else {
    const double straight_to = std::max(0.5 * first.length, first.length - 3.0 * width_max);
    if (straight_to - taken.s >= length_min) {
      place = {straight_to, point_of(spline_.way.last(), straight_to)};
    }
    const double step = (first.length - place.s) / 3.0;
    for (int k = -3; k < 3; ++k) spline_.knots.push_back(place.s + k * step);
    spline_.knots.push_back(first.length);
  }
  frozen_ = spline_.knots.size();
  settled_ = emitted_ = RunSpline::order - 1;
  emitted_to_ = place.point;
  return place;
}

void SmoothRun::add(const Segment& next, const Tolerance& tolerance, std::vector<Segment>& out) {
  spline_.way.add(next, tolerance);
  place_knots();
  settle();
  if (settled_ > emitted_ + lag) emit(settled_ - lag, out);
}

SmoothRun::Place SmoothRun::end(End end, std::vector<Segment>& out) {
  const double to = end == End::at_rest ? place_last_knots() : place_knots_before_straight();
  settle();
  std::size_t until = emitted_;
  while (spline_.knots[until] < to) ++until;
  emit(until, out);
  emit_line(out);
  const Leg& last = spline_.way.last();
  if (to == last.t_end) emitted_to_ = out.back().geometry.end = last.line.geometry.end;
  const Place place{to - last.t_start, emitted_to_};
  clear();
  return place;
}

// The spline goes on to the end of the way.
double SmoothRun::place_last_knots() {
  const double to = spline_.way.end();
  make_room_before(to);
  const std::size_t corner = spline_.knots.size();
  spline_.knots.insert(spline_.knots.end(), RunSpline::order, to);
  take_back(corner);
  return to;
}

// The spline is straight from the place returned on.
double SmoothRun::place_knots_before_straight() {
  const Leg& last = spline_.way.last();
  while (spline_.knots.back() > last.t_start && spline_.knots.size() > frozen_)
    spline_.knots.pop_back();
  make_room_before(last.t_start);
  if (spline_.knots.back() < last.t_start) spline_.knots.push_back(last.t_start);
  const double base = spline_.knots.back();
  const double step = std::min((last.t_end - base) / 6.0, width_max);
  const std::size_t corner = spline_.knots.size() - 1;
  for (int k = 1; k <= 6; ++k) spline_.knots.push_back(base + k * step);
  take_back(corner);
  grade(corner);
  return base + 3 * step;
}

// Takes the last knot away when it would stand close to one at t.
void SmoothRun::make_room_before(double t) {
  if (spline_.knots.size() <= frozen_) return;
  if (t - spline_.knots.back() < 0.5 * spline_.width(spline_.knots.size() - 2))
    spline_.knots.pop_back();
}

// Knots as far apart as may be, up to the end of the path known.
void SmoothRun::place_knots() {
  for (;;) {
    const double next = next_knot();
    if (next > spline_.way.end()) return;
    spline_.knots.push_back(next);
  }
}

// The next knot, or a place behind the end of the path known while that is too short to tell.
double SmoothRun::next_knot() const {
  const double last = spline_.knots.back();
  const std::size_t index = spline_.way.index_at(last);
  const Leg& leg = spline_.way.leg(index);
  constexpr double settling = static_cast<double>(spans_behind_corner) * width_max;
  if (last - leg.t_start >= settling && leg.t_end - settling > last + width_max)
    return leg.t_end - settling;
  const double before = last - spline_.knots[spline_.knots.size() - 2];
  double step = before > 0.0 ? std::min(width_growth * before, width_max) : width_max;
  if (index + legs_per_span_max < spline_.way.size())
    step = std::min(step, spline_.way.leg(index + legs_per_span_max).t_end - last);
  const double behind = last + (1.0 + snap) * step;
  if (behind > spline_.way.end()) return behind;
  const double corner = spline_.way.nearest_corner(last + step);
  return std::abs(corner - last - step) <= snap * step ? corner : last + step;
}

// Puts in knots until all spans whose knots are known are within tolerance.
void SmoothRun::settle() {
  while (settled_ + RunSpline::support < spline_.knots.size()) {
    if (fits(settled_)) {
      ++settled_;
      continue;
    }
    split_around(settled_);
  }
}

// A span that deviates too far, and those beside it that are not narrower.
void SmoothRun::split_around(std::size_t span) {
  const double narrow = 0.75 * spline_.width(span);
  const std::size_t first = span > emitted_ && spline_.width(span - 1) > narrow ? span - 1 : span;
  const std::size_t last =
      span + 2 < spline_.knots.size() && spline_.width(span + 1) > narrow ? span + 1 : span;
  bool has_split = false;
  for (std::size_t k = last + 1; k-- > first;) has_split = split(k) || has_split;
  if (!has_split) {
    ++settled_;  // as narrow as spans get: 1e-5 mm, far below any tolerance of a run
    return;
  }
  grade(first);
  grade(std::min(last + 2, spline_.knots.size() - 2));
}

// Puts a knot into the middle of a span, or at the corner next to it.
bool SmoothRun::split(std::size_t span) {
  if (span + 1 < frozen_ || spline_.width(span) < 2.0 * width_min) return false;
  const double middle = 0.5 * (spline_.knots[span] + spline_.knots[span + 1]);
  const double corner = spline_.way.nearest_corner(middle);
  const bool goes_to_corner = std::abs(corner - middle) <= 0.5 * snap * spline_.width(span);
  spline_.knots.insert(spline_.knots.begin() + static_cast<std::ptrdiff_t>(span) + 1,
                       goes_to_corner ? corner : middle);
  take_back(span);
  return true;
}

// Spans that depend on knots behind this one are to be looked at again.
void SmoothRun::take_back(std::size_t knot) {
  settled_ = std::max(
      emitted_, std::min(settled_, knot > RunSpline::support ? knot - RunSpline::support : 0));
}

// Splits spans beside a much narrower one, outwards from `span`.
void SmoothRun::grade(std::size_t span) {
  const auto is_wide_beside = [this](std::size_t wide, std::size_t narrow) {
    return spline_.width(narrow) > 0.0 && spline_.width(wide) > ratio_max * spline_.width(narrow);
  };
  std::size_t at = span;
  for (std::size_t n = 0; n < graded && at > frozen_; ++n) {
    if (is_wide_beside(at - 1, at) && split(at - 1)) {
      ++at;
    } else {
      --at;
    }
  }
  at = span;
  for (std::size_t n = 0; n < graded && at + 2 < spline_.knots.size(); ++n) {
    if (is_wide_beside(at + 1, at) && !is_long_straight(at + 1) && split(at + 1)) continue;
    ++at;
  }
}

// The one long span of a long block.
bool SmoothRun::is_long_straight(std::size_t span) const {
  return spline_.width(span) > 1.5 * width_max;
}

bool SmoothRun::fits(std::size_t span) const {
  if (spline_.is_straight(span)) return true;
  const RunSpline::ControlPoints control = spline_.control_points(span);
  bool good = true;
  spline_.for_each_stretch(span, [&](const Leg& leg, double a, double b) {
    good = good && fits_leg(leg, a, b, spline_.bezier(span, control, a, b));
  });
  return good;
}

// The deviation stays within the hull of the Bezier points of the difference, and the direction
// within that of their steps.
bool SmoothRun::fits_leg(const Leg& leg, double a, double b,
                         const RunSpline::ControlPoints& points) const {
  const Tolerance chords = chord_share(leg.tolerance);
  const Tolerance allowed{run_tolerance_used * (leg.tolerance.mm - chords.mm),
                          run_tolerance_used * (leg.tolerance.deg - chords.deg)};
  const Point from = point_of(leg, a);
  const Point to = point_of(leg, b);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point deviation = difference(points[k], between(from, to, static_cast<double>(k) / 3.0));
    if (geometry_norm(config_, deviation) > allowed.mm) return false;
    for (int axis = 0; axis < config_.axis_count; ++axis) {
      if (std::abs(deviation[axis]) > axis_tolerance(config_, axis, allowed)) return false;
    }
  }
  const Point along = difference(to, from);
  const PathMetric& metric = leg.line.geometry.metric;
  const double forward = forward_min * metric_product(metric, along, along) / 3.0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (metric_product(metric, difference(points[k + 1], points[k]), along) < forward) return false;
  }
  return true;
}

void SmoothRun::emit(std::size_t until, std::vector<Segment>& out) {
  for (; emitted_ < until; ++emitted_) emit_span(emitted_, out);
  frozen_ = emitted_ + RunSpline::support;
  forget_emitted();
}

void SmoothRun::emit_span(std::size_t span, std::vector<Segment>& out) {
  const bool straight = spline_.is_straight(span);
  const RunSpline::ControlPoints control = spline_.control_points(span);
  spline_.for_each_stretch(span, [&](const Leg& leg, double a, double b) {
    if (!straight || a == leg.t_start) emit_line(out);
    if (straight) {
      if (!straight_.is_open) straight_ = {true, a, b};
      straight_.to = b;
    } else {
      emit_curve(leg, spline_.bezier(span, control, a, b), out);
    }
  });
}

void SmoothRun::emit_line(std::vector<Segment>& out) {
  if (!straight_.is_open) return;
  straight_.is_open = false;
  const Leg& leg = spline_.way.leg(spline_.way.index_at(0.5 * (straight_.from + straight_.to)));
  Segment segment = leg.line;
  const Point end = point_of(leg, straight_.to);
  const Shape shape = line(segment.geometry.metric, emitted_to_, end);
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  segment.bounds = bounds_of(segment, leg.tolerance);
  out.push_back(segment);
  emitted_to_ = end;
}

void SmoothRun::emit_curve(const Leg& leg, const RunSpline::ControlPoints& points,
                           std::vector<Segment>& out) {
  Segment segment = leg.line;
  segment.geometry.kind = SegmentKind::quintic;
  segment.geometry.start = emitted_to_;
  segment.geometry.end = points[3];
  for (std::size_t k = 0; k < axes_max; ++k) {
    const double p0 = points[0][k];
    const double p1 = points[1][k];
    const double p2 = points[2][k];
    const double p3 = points[3][k];
    segment.geometry.coefficients[k] = {
        p0, 3.0 * (p1 - p0), 3.0 * (p2 - 2.0 * p1 + p0), p3 - p0 - 3.0 * (p2 - p1), 0.0, 0.0};
  }
  measure(segment.geometry);
  segment.length = arc_length(segment.geometry);
  segment.bounds = bounds_of(segment, leg.tolerance);
  out.push_back(segment);
  emitted_to_ = points[3];
}

// What no span to come depends on.
void SmoothRun::forget_emitted() {
  constexpr std::size_t kept = 4;
  constexpr std::size_t batch = 32;
  if (emitted_ < kept + batch) return;
  const std::size_t count = emitted_ - kept;
  const double t = spline_.knots[count];
  spline_.knots.erase(spline_.knots.begin(),
                      spline_.knots.begin() + static_cast<std::ptrdiff_t>(count));
  emitted_ -= count;
  settled_ -= count;
  frozen_ -= count;
  if (!straight_.is_open) spline_.way.forget_before(t);
}

}  // namespace stanok::motion
