#include "motion/look_ahead/speed_plan.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::motion {
namespace {

// A segment counts as violated, and two speeds as different, beyond this part of the speed.
constexpr double speed_tolerance = 1e-10;

// How many places are tried for a key point that frees a ramp of bad limits, and how many segments
// are looked at for each.
constexpr int detours_tried = 8;
constexpr std::size_t segments_looked_at = 16;

// Whether better limits are worth another look at a ramp.
bool pays(const RampLimits& now, const RampLimits& then) {
  constexpr double gain = 1.05;
  return then.a > gain * now.a || then.j > gain * now.j;
}

}  // namespace

bool SpeedPlan::plan(const std::vector<SpeedSegment>& segments, double v_start) {
  take(segments);
  spans_.clear();
  Key left{.boundary = 0, .v = v_start};
  std::vector<Key> pending{{.boundary = segments.size(), .v = 0.0}};
  // Each round adds a key point, accepts a span or lowers a speed; the bound only guards against
  // rounding.
  for (std::size_t round = 0; round < 64 * segments.size() + 64; ++round) {
    if (pending.empty()) return true;
    Key& right = pending.back();
    KeySpan span;
    if (left.begins_stair) {
      accept(left.stair, left, pending);
      continue;
    }
    const Fit result = fit(left, right, unlimited, span);
    if (result == Fit::left_too_fast) {
      if (!lower_left(pending, left, right)) return false;
      continue;
    }
    if (result == Fit::right_too_fast) {
      right.v = reachable_speed(left.v, distance(left.boundary, right.boundary),
                                limits_over(left.boundary, right.boundary));
      right.begins_stair = false;
      continue;
    }
    if (const auto key = later_start(left, right, span)) {
      pending.push_back(*key);
      continue;
    }
    if (const auto key = earlier_end(left, right, span)) {
      pending.push_back(*key);
      continue;
    }
    const std::size_t segment = slowest_violated(span);
    if (segment != npos) {
      if (add_keys(left, segment, pending)) continue;
      if (fit(left, right, v_[segment], span) != Fit::fits) return false;
    }
    accept(span, left, pending);
  }
  return false;
}

void SpeedPlan::take(const std::vector<SpeedSegment>& segments) {
  const std::size_t n = segments.size();
  boundaries_.resize(n + 1);
  for (std::vector<double>* column : {&v_, &minus_v_, &a_, &j_}) column->resize(n);
  boundaries_[0] = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    boundaries_[i + 1] = boundaries_[i] + segments[i].length;
    v_[i] = segments[i].v;
    minus_v_[i] = -segments[i].v;
    a_[i] = segments[i].ramp.a;
    j_[i] = segments[i].ramp.j;
  }
  slowest_.build(v_);
  fastest_.build(minus_v_);
  least_a_.build(a_);
  least_j_.build(j_);
}

// The key point on the left is too fast for the room there is: it is lowered, and the span that
// led to it is planned again. False at the start of the plan, whose speed is given.
bool SpeedPlan::lower_left(std::vector<Key>& pending, Key& left, const Key& right) {
  if (spans_.empty()) return false;
  const double v = reachable_speed(right.v, distance(left.boundary, right.boundary),
                                   limits_over(left.boundary, right.boundary));
  pending.push_back({.boundary = left.boundary, .v = std::min(v, left.v)});
  left = {.boundary = spans_.back().first, .v = spans_.back().v0};
  spans_.pop_back();
  return true;
}

void SpeedPlan::accept(const KeySpan& span, Key& left, std::vector<Key>& pending) {
  spans_.push_back(span);
  left = pending.back();
  pending.pop_back();
}

double SpeedPlan::distance(std::size_t from, std::size_t to) const {
  return std::abs(boundaries_[to] - boundaries_[from]);
}

RampLimits SpeedPlan::limits_over(std::size_t first, std::size_t last) const {
  return {.a = least_a_.value(first, last - 1), .j = least_j_.value(first, last - 1)};
}

RampLimits SpeedPlan::limits_between(double s0, double s1) const {
  const auto begin = boundaries_.begin();
  const auto after_start = std::upper_bound(begin, boundaries_.end(), s0);
  const auto end = std::lower_bound(after_start, boundaries_.end(), s1);
  const auto first = checked_size(std::max<std::ptrdiff_t>(after_start - begin - 1, 0));
  const auto last = checked_size(end - begin);
  const std::size_t n = v_.size();
  return limits_over(std::min(first, n - 1), std::clamp(last, first + 1, n));
}

// Limits of a ramp that leaves a boundary, over the segments it touches: a lower limit makes the
// ramp longer, and a longer ramp may touch more segments, until nothing changes.
RampLimits SpeedPlan::outward_limits(std::size_t from, Direction direction, double v0,
                                     double v1) const {
  const bool forward = direction == Direction::forward;
  const double s = boundaries_[from];
  const double whole = forward ? boundaries_.back() - s : s;
  const std::size_t next = forward ? from : from - 1;
  RampLimits limits = limits_over(next, next + 1);
  for (double reach = 0.0; reach < whole;) {
    reach = std::min(std::max(ramp_distance(v0, v1, limits), reach), whole);
    const RampLimits found = forward ? limits_between(s, s + reach) : limits_between(s - reach, s);
    if (found.a >= limits.a && found.j >= limits.j) break;
    limits = lower_of(limits, found);
  }
  return limits;
}

double SpeedPlan::highest_limit(std::size_t first, std::size_t last) const {
  return -fastest_.value(first, last - 1);
}

double SpeedPlan::boundary_limit(std::size_t boundary) const {
  if (boundary == 0) return v_.front();
  if (boundary == v_.size()) return v_.back();
  return std::min(v_[boundary - 1], v_[boundary]);
}

double SpeedPlan::duration(const KeySpan& span) const {
  const double up = span.up_distance();
  const double down = span.down_distance();
  const double held = distance(span.first, span.last) - up - down;
  return ramp_duration(span.v0, span.top, span.up) + ramp_duration(span.top, span.v1, span.down) +
         held / span.top;
}

SpeedPlan::Fit SpeedPlan::fit(const Key& left, const Key& right, double v_cap,
                              KeySpan& span) const {
  span = {.first = left.boundary, .last = right.boundary, .v0 = left.v, .v1 = right.v};
  const double cap =
      std::max({std::min(v_cap, highest_limit(left.boundary, right.boundary)), left.v, right.v});
  span.top = cap;
  span.up = outward_limits(left.boundary, Direction::forward, left.v, cap);
  span.down = outward_limits(right.boundary, Direction::backward, right.v, cap);
  const double length = distance(left.boundary, right.boundary);
  if (span.up_distance() + span.down_distance() <= length) return Fit::fits;
  return fit_peak(cap, span);
}

// There is no room for the top wanted: the ramps meet at a lower one. Their limits follow from the
// segments they touch, as in outward_limits.
SpeedPlan::Fit SpeedPlan::fit_peak(double v_cap, KeySpan& span) const {
  constexpr int rounds = 16;
  const double s0 = boundaries_[span.first];
  const double s1 = boundaries_[span.last];
  span.up = limits_over(span.first, span.first + 1);
  span.down = limits_over(span.last - 1, span.last);
  for (int round = 0;; ++round) {
    if (round == rounds) span.up = span.down = limits_over(span.first, span.last);
    const bool rises = span.v0 < span.v1;
    const double least = ramp_distance(span.v0, span.v1, rises ? span.up : span.down);
    if (least > s1 - s0) return rises ? Fit::right_too_fast : Fit::left_too_fast;
    span.top = peak_speed(span.v0, span.v1, s1 - s0, span.up, span.down, v_cap);
    if (round == rounds) return Fit::fits;
    const RampLimits up = limits_between(s0, std::min(s0 + span.up_distance(), s1));
    const RampLimits down = limits_between(std::max(s1 - span.down_distance(), s0), s1);
    if (up.a >= span.up.a && up.j >= span.up.j && down.a >= span.down.a && down.j >= span.down.j) {
      return Fit::fits;
    }
    span.up = lower_of(up, span.up);
    span.down = lower_of(down, span.down);
  }
}

// The highest speed at a boundary that a ramp over the segments between it and a key point attains.
double SpeedPlan::speed_across(const Key& from, std::size_t boundary) const {
  const std::size_t first = std::min(from.boundary, boundary);
  const std::size_t last = std::max(from.boundary, boundary);
  const double v = reachable_speed(from.v, distance(first, last), limits_over(first, last));
  return std::min({v, slowest_.value(first, last - 1), boundary_limit(boundary)});
}

// The fastest path from `left` to `right` over a key point at `boundary`: slow between the slow
// end, which lies against the direction, and that key point, at the speed of that end or up to the
// highest that can be reached there.
std::optional<SpeedPlan::Detour> SpeedPlan::best_detour(const Key& left, const Key& right,
                                                        std::size_t boundary,
                                                        Direction direction) const {
  const bool forward = direction == Direction::forward;
  const Key& slow = forward ? left : right;
  const double v_max = forward ? slowest_.value(left.boundary, boundary)
                               : slowest_.value(boundary - 1, right.boundary - 1);
  std::optional<Detour> best;
  for (const double v : {slow.v, speed_across(slow, boundary)}) {
    if (v <= 0.0 || v < slow.v || v > v_max) continue;
    const Key middle{.boundary = boundary, .v = v};
    KeySpan before;
    KeySpan after;
    if (fit(left, middle, forward ? v : unlimited, before) != Fit::fits) continue;
    if (fit(middle, right, forward ? unlimited : v, after) != Fit::fits) continue;
    const double time = duration(before) + duration(after);
    if (best && best->duration <= time) continue;
    best = Detour{.key = middle, .duration = time, .limits = forward ? after.up : before.down};
  }
  return best;
}

// Behind the last of the first segments from `start` on, before `stop` and `reach`, that are as bad
// as `limits`.
std::size_t SpeedPlan::behind_worst(std::size_t start, std::size_t stop, double reach,
                                    const RampLimits& limits) const {
  std::size_t next = npos;
  const std::size_t end = std::min(stop, start + segments_looked_at);
  for (std::size_t i = start; i < end && i + 1 < stop && boundaries_[i + 1] < reach; ++i) {
    if (a_[i] <= limits.a || j_[i] <= limits.j) next = i + 1;
  }
  return next;
}

// Looks backwards where the function above looks forwards.
std::size_t SpeedPlan::before_worst(std::size_t end, std::size_t stop, double reach,
                                    const RampLimits& limits) const {
  std::size_t next = npos;
  const std::size_t first = std::max(stop, end > segments_looked_at ? end - segments_looked_at : 0);
  for (std::size_t i = end; i > first && i - 1 > stop && boundaries_[i - 1] > reach; --i) {
    if (a_[i - 1] <= limits.a || j_[i - 1] <= limits.j) next = i - 1;
  }
  return next;
}

std::optional<SpeedPlan::Key> SpeedPlan::later_start(const Key& left, const Key& right,
                                                     const KeySpan& span) const {
  if (span.top <= left.v) return std::nullopt;
  const double reach = boundaries_[left.boundary] + span.up_distance();
  std::optional<Key> best;
  double best_duration = duration(span) * (1.0 - 1e-9);
  RampLimits limits = span.up;
  std::size_t start = left.boundary;
  for (int k = 0; k < detours_tried; ++k) {
    start = behind_worst(start, right.boundary, reach, limits);
    if (start == npos || !pays(limits, limits_between(boundaries_[start], reach))) break;
    const auto detour = best_detour(left, right, start, Direction::forward);
    if (!detour) break;
    limits = detour->limits;
    if (detour->duration >= best_duration) continue;
    best = detour->key;
    best_duration = detour->duration;
  }
  return best;
}

std::optional<SpeedPlan::Key> SpeedPlan::earlier_end(const Key& left, const Key& right,
                                                     const KeySpan& span) const {
  if (span.top <= right.v) return std::nullopt;
  const double reach = boundaries_[right.boundary] - span.down_distance();
  std::optional<Key> best;
  double best_duration = duration(span) * (1.0 - 1e-9);
  RampLimits limits = span.down;
  std::size_t end = right.boundary;
  for (int k = 0; k < detours_tried; ++k) {
    end = before_worst(end, left.boundary, reach, limits);
    if (end == npos || !pays(limits, limits_between(reach, boundaries_[end]))) break;
    const auto detour = best_detour(left, right, end, Direction::backward);
    if (!detour) break;
    limits = detour->limits;
    if (detour->duration >= best_duration) continue;
    best = detour->key;
    best_duration = detour->duration;
  }
  return best;
}

std::size_t SpeedPlan::slowest_violated(const KeySpan& span) const {
  const double allowed = 1.0 + speed_tolerance;
  const std::size_t slowest = slowest_.place(span.first, span.last - 1);
  if (span.top <= v_[slowest] * allowed) return npos;
  const double s0 = boundaries_[span.first];
  const double s1 = boundaries_[span.last];
  const RampCourse up(span.v0, span.top, span.up);
  const RampCourse down(span.v1, span.top, span.down);
  const double top_first = s0 + up.length();
  const double top_last = std::max(s1 - down.length(), top_first);
  std::size_t found = npos;
  const auto consider = [&](std::size_t i) {
    if (found == npos || v_[i] < v_[found]) found = i;
  };
  std::size_t i = span.first;
  for (; i < span.last && boundaries_[i + 1] < top_first; ++i) {
    const double v = v_[i] * allowed;
    if (v < span.top && s0 + up.distance_to(v) < boundaries_[i + 1]) consider(i);
  }
  const std::size_t top_begin = std::min(i, span.last - 1);
  std::size_t k = span.last;
  for (; k > top_begin + 1 && boundaries_[k - 1] > top_last; --k) {
    const double v = v_[k - 1] * allowed;
    if (v < span.top && s1 - down.distance_to(v) > boundaries_[k - 1]) consider(k - 1);
  }
  const std::size_t held = slowest_.place(top_begin, k - 1);
  if (span.top > v_[held] * allowed) consider(held);
  return found;
}

bool SpeedPlan::add_keys(Key& left, std::size_t segment, std::vector<Key>& pending) {
  const Key right = pending.back();
  const double v = v_[segment];
  std::size_t begin = segment;
  std::size_t end = segment + 1;
  const double same = v * (1.0 + speed_tolerance);
  while (begin > left.boundary && v_[begin - 1] >= v && v_[begin - 1] <= same) --begin;
  while (end < right.boundary && v_[end] >= v && v_[end] <= same) ++end;
  const double reached =
      boundaries_[left.boundary] +
      ramp_distance(left.v, v, outward_limits(left.boundary, Direction::forward, left.v, v));
  const double left_at =
      boundaries_[right.boundary] -
      ramp_distance(right.v, v, outward_limits(right.boundary, Direction::backward, right.v, v));
  if (reached > boundaries_[end] && end < right.boundary && left.v <= v) {
    return add_stair(left, right, end, Direction::forward, pending);
  }
  if (left_at < boundaries_[begin] && begin > left.boundary && right.v <= v) {
    return add_stair(left, right, begin, Direction::backward, pending);
  }
  // A key point beside the segment that is faster than the segment leaves no choice: it will be
  // lowered.
  const bool ends_inside = end < right.boundary && (left_at >= boundaries_[end] || right.v > v);
  const bool begins_inside = begin > left.boundary && (reached <= boundaries_[begin] || left.v > v);
  if (ends_inside) pending.push_back({.boundary = end, .v = std::min(v, boundary_limit(end))});
  if (begins_inside) {
    pending.push_back({.boundary = begin, .v = std::min(v, boundary_limit(begin))});
  }
  return ends_inside || begins_inside;
}

void SpeedPlan::append_phases(const KeySpan& span, std::vector<Phase>& phases) const {
  const auto hold = [&](double s0, double s1, double v) {
    if (!(s1 > s0) || v <= 0.0) {
      if (!phases.empty()) phases.back().s_end = s1;
      return;
    }
    if (!phases.empty() && phases.back().a == 0.0 && phases.back().j == 0.0 &&
        phases.back().v == v) {
      s0 = phases.back().s;
      phases.pop_back();
    }
    phases.push_back({.duration = (s1 - s0) / v, .s = s0, .v = v, .s_end = s1, .v_end = v});
  };
  const double s0 = boundaries_[span.first];
  const double s1 = boundaries_[span.last];
  const PhaseRun up = ramp_up(s0 + span.wait_first, span.v0, span.top, span.up);
  const PhaseRun down = ramp_down(span.top, s1 - span.wait_last, span.v1, span.down);
  double at = s0;
  if (up.size() > 0) {
    hold(s0, up[0].s, span.v0);
    phases.insert(phases.end(), up.begin(), up.end());
    at = up[up.size() - 1].s_end;
  }
  if (down.size() == 0) {
    hold(at, s1, span.top);
    return;
  }
  hold(at, down[0].s, span.top);
  phases.insert(phases.end(), down.begin(), down.end());
  hold(down[down.size() - 1].s_end, s1, span.v1);
}

}  // namespace stanok::motion
