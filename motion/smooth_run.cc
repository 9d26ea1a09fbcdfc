// Knots, control points and pieces of the spline (motion/smooth_run.h).
//
// Span i lies between the knots i and i + 1. Control point j belongs to the knots j + 1 to j + 3,
// whose mean is its Greville abscissa; its correction needs the neighbours j - 1 and j + 1. So span
// i depends on the knots i - 3 to i + 4.
#include "motion/smooth_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/arc_length.h"
#include "motion/shape.h"

namespace stanok::motion {
namespace {

constexpr double length_min = 1e-4;            // mm of a block
constexpr double tolerance_min = 5e-4;         // mm: below, corners are left to blends
constexpr double rate_step_max = 1000.0;       // tolerances of another axis per mm, at a corner
constexpr double tolerance_used = 0.97;        // the rest covers the chord between two setpoints
constexpr double width_max = 2.0;              // mm between two knots
constexpr std::size_t legs_per_span_max = 32;  // and so many blocks
constexpr double width_min = 1e-5;             // mm
constexpr double growth = 2.0;                 // of the distance from knot to knot
constexpr double ratio_max = 2.5;              // of neighbouring distances, once settled
constexpr double snap = 0.3;  // part of the distance by which a knot goes to a corner
constexpr std::size_t spans_behind_corner = 5;  // on a long block, before one long span
constexpr std::size_t lag = 24;                 // spans that may still change
constexpr std::size_t support = 4;              // a span depends on so many knots behind it
constexpr std::size_t graded = 40;              // spans around new knots that are looked at
constexpr std::size_t order = 4;                // of the spline
constexpr double forward_min = 0.5;             // of the spline along its block, per t

double geometry_norm(const MotionConfig& config, const Point& v) {
  double squared = 0.0;
  for (const int axis : config.geometry) {
    if (axis < 0) continue;
    squared += v[static_cast<std::size_t>(axis)] * v[static_cast<std::size_t>(axis)];
  }
  return std::sqrt(squared);
}

Point between(const Point& a, const Point& b, double part) {
  Point point;
  for (std::size_t k = 0; k < axes_max; ++k) point[k] = a[k] + (b[k] - a[k]) * part;
  return point;
}

double axis_tolerance(const MotionConfig& config, std::size_t axis, const Tolerance& tolerance) {
  return config.axes[axis].linear ? tolerance.mm : tolerance.deg;
}

Point difference(const Point& a, const Point& b) {
  Point d;
  for (std::size_t k = 0; k < axes_max; ++k) d[k] = a[k] - b[k];
  return d;
}

double product(const PathMetric& metric, const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(metric.axis_count); ++k) {
    if (metric.counts(k)) sum += a[k] * b[k];
  }
  return sum;
}

bool is_run_block(const Piece& piece) {
  return piece.geometry.kind == PieceKind::line && !piece.rapid && piece.length >= length_min;
}

}  // namespace

SmoothRun::SmoothRun(const MotionConfig& config)
    : config_(config),
      turn_cosine_min_(std::cos(config.run_turn_max_deg * std::numbers::pi / 180.0)) {}

bool SmoothRun::may_join(const Piece& incoming, const Piece& outgoing,
                         const Tolerance& tolerance) const {
  if (config_.run_turn_max_deg <= 0.0) return false;
  if (!is_run_block(incoming) || !is_run_block(outgoing)) return false;
  if (!(tolerance.mm >= tolerance_min) || !(tolerance.deg > 0.0)) return false;
  const PathMetric& metric = incoming.geometry.metric;
  if (metric != outgoing.geometry.metric || incoming.transform != outgoing.transform) return false;
  double cosine = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(metric.axis_count); ++k) {
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
  way_.clear();
  knots_.clear();
  straight_ = {};
  settled_ = 0;
  emitted_ = 0;
  frozen_ = 0;
}

SmoothRun::Place SmoothRun::begin(const Piece& first, const Tolerance& tolerance, End end) {
  clear();
  way_.add(first, tolerance);
  if (end == End::at_rest) {
    knots_.assign(order, 0.0);
  } else {
    const double step = std::min(first.length / 6.0, width_max);
    const double from = first.length - 3.0 * step;
    for (int k = -3; k < 3; ++k) knots_.push_back(from + k * step);
    knots_.push_back(first.length);
  }
  frozen_ = knots_.size();
  settled_ = emitted_ = order - 1;
  emitted_to_ = point_of(way_.last(), knots_[emitted_]);
  return {knots_[emitted_], emitted_to_};
}

void SmoothRun::add(const Piece& next, const Tolerance& tolerance, std::vector<Piece>& out) {
  way_.add(next, tolerance);
  place_knots();
  settle();
  if (settled_ > emitted_ + lag) emit(settled_ - lag, out);
}

SmoothRun::Place SmoothRun::end(End end, std::vector<Piece>& out) {
  const double to = end == End::at_rest ? place_last_knots() : place_knots_before_straight();
  settle();
  std::size_t until = emitted_;
  while (knots_[until] < to) ++until;
  emit(until, out);
  emit_line(out);
  const Leg& last = way_.last();
  if (to == last.t_end) emitted_to_ = out.back().geometry.end = last.line.geometry.end;
  const Place place{to - last.t_start, emitted_to_};
  clear();
  return place;
}

// The spline goes on to the end of the way.
double SmoothRun::place_last_knots() {
  const double to = way_.end();
  make_room_before(to);
  const std::size_t corner = knots_.size();
  knots_.insert(knots_.end(), order, to);
  take_back(corner);
  return to;
}

// The spline is straight from the place returned on.
double SmoothRun::place_knots_before_straight() {
  const Leg& last = way_.last();
  while (knots_.back() > last.t_start && knots_.size() > frozen_) knots_.pop_back();
  make_room_before(last.t_start);
  if (knots_.back() < last.t_start) knots_.push_back(last.t_start);
  const double base = knots_.back();
  const double step = std::min((last.t_end - base) / 6.0, width_max);
  const std::size_t corner = knots_.size() - 1;
  for (int k = 1; k <= 6; ++k) knots_.push_back(base + k * step);
  take_back(corner);
  grade(corner);
  return base + 3 * step;
}

// Takes the last knot away when it would stand close to one at t.
void SmoothRun::make_room_before(double t) {
  if (knots_.size() <= frozen_) return;
  if (t - knots_.back() < 0.5 * width(knots_.size() - 2)) knots_.pop_back();
}

// Knots as far apart as may be, up to the end of the way known.
void SmoothRun::place_knots() {
  for (;;) {
    const double next = next_knot();
    if (next > way_.end()) return;
    knots_.push_back(next);
  }
}

// The next knot, or a place behind the end of the way known while that is too short to tell.
double SmoothRun::next_knot() const {
  const double last = knots_.back();
  const std::size_t index = way_.index_at(last);
  const Leg& leg = way_.leg(index);
  constexpr double settling = static_cast<double>(spans_behind_corner) * width_max;
  if (last - leg.t_start >= settling && leg.t_end - settling > last + width_max)
    return leg.t_end - settling;
  const double before = last - knots_[knots_.size() - 2];
  double step = before > 0.0 ? std::min(growth * before, width_max) : width_max;
  if (index + legs_per_span_max < way_.size())
    step = std::min(step, way_.leg(index + legs_per_span_max).t_end - last);
  const double behind = last + (1.0 + snap) * step;
  if (behind > way_.end()) return behind;
  const double corner = way_.nearest_corner(last + step);
  return std::abs(corner - last - step) <= snap * step ? corner : last + step;
}

// Puts in knots until all spans whose knots are known are within tolerance.
void SmoothRun::settle() {
  while (settled_ + support < knots_.size()) {
    if (fits(settled_)) {
      ++settled_;
      continue;
    }
    split_around(settled_);
  }
}

// A span that deviates too far, and those beside it that are not narrower.
void SmoothRun::split_around(std::size_t span) {
  const double narrow = 0.75 * width(span);
  const std::size_t first = span > emitted_ && width(span - 1) > narrow ? span - 1 : span;
  const std::size_t last = span + 2 < knots_.size() && width(span + 1) > narrow ? span + 1 : span;
  bool has_split = false;
  for (std::size_t k = last + 1; k-- > first;) has_split = split(k) || has_split;
  if (!has_split) {
    ++settled_;  // as narrow as spans get
    return;
  }
  grade(first);
  grade(std::min(last + 2, knots_.size() - 2));
}

// Puts a knot into the middle of a span, or at the corner next to it.
bool SmoothRun::split(std::size_t span) {
  if (span + 1 < frozen_ || width(span) < 2.0 * width_min) return false;
  const double middle = 0.5 * (knots_[span] + knots_[span + 1]);
  const double corner = way_.nearest_corner(middle);
  const bool goes_to_corner = std::abs(corner - middle) <= 0.5 * snap * width(span);
  knots_.insert(knots_.begin() + static_cast<std::ptrdiff_t>(span) + 1,
                goes_to_corner ? corner : middle);
  take_back(span);
  return true;
}

// Spans that depend on knots behind this one are to be looked at again.
void SmoothRun::take_back(std::size_t knot) {
  settled_ = std::max(emitted_, std::min(settled_, knot > support ? knot - support : 0));
}

// Splits spans beside a much narrower one, outwards from `span`.
void SmoothRun::grade(std::size_t span) {
  const auto is_wide_beside = [this](std::size_t wide, std::size_t narrow) {
    return width(narrow) > 0.0 && width(wide) > ratio_max * width(narrow);
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
  for (std::size_t n = 0; n < graded && at + 2 < knots_.size(); ++n) {
    if (is_wide_beside(at + 1, at) && !is_long_straight(at + 1) && split(at + 1)) continue;
    ++at;
  }
}

// The one long span of a long block.
bool SmoothRun::is_long_straight(std::size_t span) const {
  return width(span) > 1.5 * width_max;
}

double SmoothRun::greville(std::size_t middle) const {
  return (knots_[middle - 1] + knots_[middle] + knots_[middle + 1]) / 3.0;
}

// All that the span depends on lies on one block.
bool SmoothRun::is_straight(std::size_t span) const {
  return greville(span + 3) <= way_.leg(way_.index_at(greville(span - 2))).t_end;
}

SmoothRun::ControlPoints SmoothRun::control_points(std::size_t span) const {
  std::array<double, 6> t;
  std::array<Point, 6> point;
  for (std::size_t k = 0; k < t.size(); ++k) {
    t[k] = greville(span - 2 + k);
    point[k] = way_.at(t[k]);
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

// Bezier points of the spline between a and b within a span, by its blossom.
SmoothRun::ControlPoints SmoothRun::bezier(std::size_t span, const ControlPoints& control, double a,
                                           double b) const {
  const auto blossom = [&](double x, double y, double z) {
    ControlPoints d = control;
    const std::array<double, 3> places{x, y, z};
    for (std::size_t r = 1; r <= 3; ++r) {
      for (std::size_t k = 3; k >= r; --k) {
        const double low = knots_[span - 3 + k];
        const double high = knots_[span + 1 + k - r];
        d[k] = between(d[k - 1], d[k], (places[r - 1] - low) / (high - low));
      }
    }
    return d[3];
  };
  return {blossom(a, a, a), blossom(a, a, b), blossom(a, b, b), blossom(b, b, b)};
}

// The parts of a span that belong to one block each.
template <class Visit>
void SmoothRun::for_each_stretch(std::size_t span, Visit visit) const {
  double a = knots_[span];
  for (std::size_t index = way_.index_at(a); a < knots_[span + 1]; ++index) {
    const Leg& leg = way_.leg(index);
    const double b = std::min(leg.t_end, knots_[span + 1]);
    visit(leg, a, b);
    a = b;
  }
}

bool SmoothRun::fits(std::size_t span) const {
  if (is_straight(span)) return true;
  const ControlPoints control = control_points(span);
  bool good = true;
  for_each_stretch(span, [&](const Leg& leg, double a, double b) {
    good = good && fits_leg(leg, a, b, bezier(span, control, a, b));
  });
  return good;
}

// The deviation stays within the hull of the Bezier points of the difference, and the direction
// within that of their steps.
bool SmoothRun::fits_leg(const Leg& leg, double a, double b, const ControlPoints& points) const {
  const Point from = point_of(leg, a);
  const Point to = point_of(leg, b);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point deviation = difference(points[k], between(from, to, static_cast<double>(k) / 3.0));
    if (geometry_norm(config_, deviation) > tolerance_used * leg.tolerance.mm) return false;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(config_.axis_count); ++axis) {
      if (std::abs(deviation[axis]) > tolerance_used * axis_tolerance(config_, axis, leg.tolerance))
        return false;
    }
  }
  const Point along = difference(to, from);
  const PathMetric& metric = leg.line.geometry.metric;
  const double forward = forward_min * product(metric, along, along) / 3.0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (product(metric, difference(points[k + 1], points[k]), along) < forward) return false;
  }
  return true;
}

void SmoothRun::emit(std::size_t until, std::vector<Piece>& out) {
  for (; emitted_ < until; ++emitted_) emit_span(emitted_, out);
  frozen_ = emitted_ + support;
  forget_emitted();
}

void SmoothRun::emit_span(std::size_t span, std::vector<Piece>& out) {
  const bool straight = is_straight(span);
  const ControlPoints control = control_points(span);
  for_each_stretch(span, [&](const Leg& leg, double a, double b) {
    if (!straight || a == leg.t_start) emit_line(out);
    if (straight) {
      if (!straight_.is_open) straight_ = {true, a, b};
      straight_.to = b;
    } else {
      emit_curve(leg, bezier(span, control, a, b), out);
    }
  });
}

void SmoothRun::emit_line(std::vector<Piece>& out) {
  if (!straight_.is_open) return;
  straight_.is_open = false;
  const Leg& leg = way_.leg(way_.index_at(0.5 * (straight_.from + straight_.to)));
  Piece piece = leg.line;
  const Point end = point_of(leg, straight_.to);
  const Shape shape = line(piece.geometry.metric, emitted_to_, end);
  piece.geometry = shape.geometry;
  piece.length = shape.length;
  out.push_back(piece);
  emitted_to_ = end;
}

void SmoothRun::emit_curve(const Leg& leg, const ControlPoints& points, std::vector<Piece>& out) {
  Piece piece = leg.line;
  piece.geometry.kind = PieceKind::quintic;
  piece.geometry.start = emitted_to_;
  piece.geometry.end = points[3];
  for (std::size_t k = 0; k < axes_max; ++k) {
    const double p0 = points[0][k];
    const double p1 = points[1][k];
    const double p2 = points[2][k];
    const double p3 = points[3][k];
    piece.geometry.coefficients[k] = {
        p0, 3.0 * (p1 - p0), 3.0 * (p2 - 2.0 * p1 + p0), p3 - p0 - 3.0 * (p2 - p1), 0.0, 0.0};
  }
  measure(piece.geometry);
  piece.length = arc_length(piece.geometry);
  out.push_back(piece);
  emitted_to_ = points[3];
}

// What no span to come depends on.
void SmoothRun::forget_emitted() {
  constexpr std::size_t kept = 4;
  constexpr std::size_t batch = 32;
  if (emitted_ < kept + batch) return;
  const std::size_t count = emitted_ - kept;
  const double t = knots_[count];
  knots_.erase(knots_.begin(), knots_.begin() + static_cast<std::ptrdiff_t>(count));
  emitted_ -= count;
  settled_ -= count;
  frozen_ -= count;
  if (!straight_.is_open) way_.forget_before(t);
}

}  // namespace stanok::motion
