#include "motion/time_optimum/stretch_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/path/geometry.h"
#include "motion/path/sampling.h"
#include "motion/time_optimum/phase_list.h"

namespace stanok::motion {
namespace {

constexpr double rounding = 1e-9;

constexpr double interval_time = 0.003;  // s, at the speed that is estimated
constexpr double faster_max = 2.0;       // than the plan, where intervals are laid
constexpr double rest_time = 0.002;      // s, of the phases out of rest and into it
constexpr double rest_growth = 0.3;      // of intervals there, over the distance from rest
constexpr std::size_t intervals_min = 4;
constexpr std::size_t intervals_max = 4096;  // of a place that is passed very slowly
constexpr double least_piece = 1e-9;         // mm, of a segment

constexpr LimitShare share_at_first{.force = 0.993, .speed = 1.0};
constexpr double rest_share = 0.995;  // of the jerk of the plan, next to rest
constexpr double share_min = 0.5;
constexpr int proofs_max = 5;
constexpr double far_at_first = 0.3;

// What an interval gets that used too much: less by more than that, and more so each time.
double lowered(double share, double use, int proof) {
  return std::max(share - (proof + 1) * (1.5 * share * (use - 1.0) + 1e-3), share_min);
}

// The longest interval whose derivatives five places tell of: of an arc and of rotary axes that
// lead a tip as in motion/path/sampling.h.
double longest_interval(const Segment& segment, int axis_count) {
  const Geometry& g = segment.geometry;
  double parts = g.kind == SegmentKind::line ? 1.0 : 2.0;
  if (g.kind == SegmentKind::arc) parts = std::abs(g.sweep) * 8.0 / std::numbers::pi;
  if (!is_affine(segment)) {
    for (int k = 3; k < axis_count; ++k) {
      parts = std::max(parts, std::abs(g.end[k] - g.start[k]) / 10.0);
    }
  }
  return segment.length / std::max(parts, 1.0);
}

}  // namespace

std::span<const Phase> StretchPlan::plan(const Stretch& stretch) {
  const End begin = begin_of(stretch);
  const End end = end_of(stretch);
  if (!(end.s > begin.s)) return {};
  if (!lay_grid(stretch, begin, end)) return {};
  if (grid_.size() < intervals_min || grid_.axes() == 0) return {};
  std::vector<Phase> before;
  append_between(stretch.phases, stretch.s0, stretch.s1, before);
  shares_.assign(grid_.size(), share_at_first);
  for (int proof = 0; proof < proofs_max; ++proof) {
    if (!search(stretch, begin, end)) return {};
    planned_.clear();
    append_phases(grid_, spline_, begin.s, planned_);
    if (tighten(planned_, proof)) continue;
    make_phases(begin, end);
    // Also false where rounding next to rest has left no number.
    if (duration_of(planned_) < duration_of(before)) return planned_;
    return {};
  }
  return {};
}

// From the plan, or from less than its speed where no motion within the limits is found from there.
bool StretchPlan::search(const Stretch& stretch, const End& begin, const End& end) {
  constexpr double slower = 0.5;  // of v^2
  for (const double less : {0.0, slower}) {
    spline_.reset(grid_, begin.state, end.state);
    start_from_plan(stretch, begin.s);
    slow_down(less);
    if (optimum_.improve(grid_, shares_, spline_, far_at_first)) return true;
  }
  return false;
}

StretchPlan::End StretchPlan::begin_of(const Stretch& stretch) {
  const Phase& first = stretch.phases.front();
  const PathMotion motion = motion_in(first, stretch.s0);
  if (motion.v > 0.0) return {.state = {motion.v, motion.a}, .s = stretch.s0, .rest = {}};
  const double t = std::min(rest_time, 0.5 * first.duration);
  const double j = rest_share * std::abs(first.j);
  Phase rest{.duration = t, .s = stretch.s0, .j = j};
  const PathMotion then = motion_at(rest, t);
  rest.s_end = then.s;
  rest.v_end = then.v;
  return {.state = {then.v, then.a}, .s = then.s, .rest = rest};
}

// Next to rest the plan is its own mirror image.
StretchPlan::End StretchPlan::end_of(const Stretch& stretch) {
  const Phase& last = stretch.phases.back();
  const PathMotion motion = motion_in(last, stretch.s1);
  if (motion.v > 0.0) return {.state = {motion.v, motion.a}, .s = stretch.s1, .rest = {}};
  const double t = std::min(rest_time, 0.5 * last.duration);
  const double j = rest_share * std::abs(last.j);
  const EndState state{.v = 0.5 * j * t * t, .a = -j * t};
  const double s = stretch.s1 - j * t * t * t / 6.0;
  return {.state = state,
          .s = s,
          .rest = Phase{
              .duration = t, .s = s, .v = state.v, .a = state.a, .j = j, .s_end = stretch.s1}};
}

// Squared speeds at the ends of segments that acceleration alone allows.
void StretchPlan::estimate(const Stretch& stretch, const End& begin, const End& end) {
  const std::size_t first = stretch.index->at(begin.s);
  const std::size_t count = stretch.index->before(end.s) - first + 1;
  const auto segments = stretch.segments.subspan(first, count);
  estimates_.assign(count + 1, unlimited);
  estimates_.front() = begin.state.v * begin.state.v;
  estimates_.back() = end.state.v * end.state.v;
  const auto top = [&](std::size_t k) {
    const double v = segment_limits(segments[k].bounds, segments[k].feed_per_s).v;
    return v * v;
  };
  const auto rise = [&](std::size_t k) {
    return 2.0 * segments[k].length / segments[k].bounds.tangent;
  };
  for (std::size_t k = 0; k + 1 < count; ++k) {
    estimates_[k + 1] = std::min({top(k), top(k + 1), estimates_[k] + rise(k)});
  }
  for (std::size_t k = count - 1; k > 0; --k) {
    estimates_[k] = std::min(estimates_[k], estimates_[k + 1] + rise(k));
  }
}

// Of a segment that is laid out in part the intervals are as short as they may become. False: one
// has a peak that the places of its intervals do not tell of, or there are too many of them.
bool StretchPlan::lay_grid(const Stretch& stretch, const End& begin, const End& end) {
  estimate(stretch, begin, end);
  grid_.clear();
  PhaseWalk walk(stretch.phases);
  const std::size_t first = stretch.index->at(begin.s);
  const std::size_t last = stretch.index->before(end.s);
  for (std::size_t k = first; k <= last; ++k) {
    const PhaseWalk before = walk;
    const std::size_t interval = grid_.size();
    double longest = longest_interval(stretch.segments[k], axis_count_);
    constexpr int halvings = 4;
    for (int n = 0;; ++n, longest *= 0.5) {
      lay_knots(stretch, walk, k, begin, end, first, longest);
      if (knots_.size() < 2) break;
      grid_.add(stretch.segments[k], knots_, stretch.jerk_parts[k]);
      if (grid_.size() > intervals_max) return false;
      if (tells_of_peaks(stretch, k, interval)) break;
      if (n == halvings && is_laid_whole(stretch.segments[k])) return false;
      if (n == halvings) break;
      grid_.cut(interval);
      walk = before;
    }
  }
  grid_.finish();
  return true;
}

bool StretchPlan::is_laid_whole(const Segment& segment) const {
  return knots_.front() <= 0.0 && knots_.back() >= segment.length;
}

// The bounds of the segment are proved (motion/bounds/segment_bounds.h): the places of its
// intervals must come near them, and tell of what is between, unless all that is nothing at the
// highest speed.
bool StretchPlan::tells_of_peaks(const Stretch& stretch, std::size_t segment,
                                 std::size_t first_interval) const {
  constexpr double near = 0.93;
  constexpr double nothing = 0.01;  // of the limit of jerk
  constexpr double missed = 0.003;
  const Segment& of = stretch.segments[segment];
  const double v = segment_limits(of.bounds, of.feed_per_s).v;
  if (of.bounds.aberrancy * v * v * v < nothing) return true;
  return grid_.largest_miss(first_interval) * v * v * v < missed &&
         grid_.largest_aberrancy(first_interval) * stretch.jerk_parts[segment] >=
             near * of.bounds.aberrancy;
}

// Knots as far from each other as the speed covers in a few cycles; the speed rises from both ends
// by what acceleration, and close to rest jerk, allow.
void StretchPlan::lay_knots(const Stretch& stretch, PhaseWalk& walk, std::size_t segment,
                            const End& begin, const End& end, std::size_t first, double longest) {
  const Segment& of = stretch.segments[segment];
  const double start = stretch.index->start(segment);
  const double from = std::max(begin.s - start, 0.0);
  const double to = std::min(end.s, stretch.index->start(segment + 1)) - start;
  knots_.clear();
  if (to - from < least_piece) return;
  const double top = segment_limits(of.bounds, of.feed_per_s).v;
  const auto speed = [&](double b, double s) {
    const double by_jerk = std::cbrt(4.5 / of.bounds.thrust * s * s);
    return std::min(std::sqrt(b + 2.0 / of.bounds.tangent * s), std::sqrt(b) + by_jerk);
  };
  knots_.push_back(from);
  for (double s = from; s < to && knots_.size() <= intervals_max;) {
    const double v = std::min({top, speed(estimates_[segment - first], s - from),
                               speed(estimates_[segment - first + 1], to - s),
                               faster_max * walk.at(start + s).v});
    const double after_rest = begin.rest ? start + s - begin.rest->s : unlimited;
    const double before_rest = end.rest ? end.rest->s_end - start - s : unlimited;
    const double step = std::min({longest, interval_time * std::max(v, 1e-3 * top),
                                  rest_growth * after_rest, rest_growth * before_rest});
    s = to - s < 1.5 * step ? to : s + step;
    knots_.push_back(s);
  }
}

// A control point is where the tangents at both ends of its interval meet: of two that differ, the
// one at the side of the shorter neighbour counts for more, whose jerk depends on it the most.
void StretchPlan::start_from_plan(const Stretch& stretch, double s0) {
  PhaseWalk walk(stretch.phases);
  double s = s0;
  PathMotion from = walk.at(s);
  for (std::size_t m = 0; m < grid_.size(); ++m) {
    const double h = grid_.length(m);
    s += h;
    const PathMotion to = walk.at(s);
    if (m > 0 && m + 1 < grid_.size()) {
      const double before = grid_.length(m - 1);
      const double after = grid_.length(m + 1);
      const double at_start = from.v * from.v;
      const double at_end = to.v * to.v;
      const double point =
          (after * (at_start + from.a * h) + before * (at_end - to.a * h)) / (before + after);
      constexpr double low = 0.25;
      const bool is_low = point < low * std::min(at_start, at_end);
      spline_.points()[m + 1] = is_low ? std::max(at_start, at_end) : point;
    }
    from = to;
  }
}

// Squared speeds lower by the part `less`, less and less so towards the ends, whose states stay.
void StretchPlan::slow_down(double less) {
  const std::size_t n = grid_.size();
  const double ramp = std::min(0.25 * static_cast<double>(n), 30.0);  // intervals
  for (std::size_t i = 2; i < n; ++i) {
    const double x = std::min(1.0, static_cast<double>(std::min(i - 1, n - i)) / ramp);
    spline_.points()[i] *= 1.0 - less * x * x * (3.0 - 2.0 * x);
  }
}

// With the phases next to rest, and the ends to the bit.
void StretchPlan::make_phases(const End& begin, const End& end) {
  planned_.back().s_end = end.s;
  planned_.back().v_end = end.state.v;
  if (begin.rest) planned_.insert(planned_.begin(), *begin.rest);
  if (end.rest) planned_.push_back(*end.rest);
  for (Phase& phase : planned_) phase.pace = use_.pace_limits();
}

// Lowers the shares of intervals that use too much, and of their neighbours; false: there are none.
bool StretchPlan::tighten(std::span<const Phase> phases, int proof) {
  std::vector<LimitShare> tightened(shares_);
  bool is_any = false;
  use_ = {};
  for (std::size_t m = 0; m < grid_.size(); ++m) {
    const PhaseUse of = use_of(grid_, m, phases[2 * m], phases[2 * m + 1]);
    use_.include(of);
    const double force = of.force / force_max;
    if (force <= 1.0 + rounding && of.speed <= 1.0 + rounding) continue;
    is_any = true;
    const std::size_t last = std::min(m + 1, grid_.size() - 1);
    for (std::size_t k = m > 0 ? m - 1 : 0; k <= last; ++k) {
      LimitShare& share = tightened[k];
      if (force > 1.0 + rounding)
        share.force = std::min(share.force, lowered(shares_[m].force, force, proof));
      if (of.speed > 1.0 + rounding)
        share.speed = std::min(share.speed, lowered(shares_[m].speed, of.speed, proof));
    }
  }
  shares_.swap(tightened);
  return is_any;
}

}  // namespace stanok::motion
