#include "motion/time_optimum/plan_improvement.h"

#include <algorithm>

#include "motion/time_optimum/phase_list.h"

namespace stanok::motion {
namespace {

constexpr double same_speed = 1.0 - 1e-9;
constexpr double held_min = 0.02;           // s at the feed, between two stretches
constexpr double typical_interval = 0.003;  // s
constexpr std::size_t stretch_max = 600;    // intervals that are planned together
constexpr double room_time = 0.01;          // s, of the feed held beside a stretch, at most
constexpr double room_part = 0.25;          // and of that phase
constexpr std::size_t divided_min = 8;      // phases
constexpr int places_max = 3;
constexpr std::size_t joined_max = 200;  // phases that are planned again with what follows
// Of one segment: the queue of phases has room for several chunks of whole segments.
constexpr std::size_t segment_phases_max = 8192;

// What no stretch passes, whatever the path.
PaceLimits widest_of(const MotionConfig& config) {
  PhaseUse use{.force = StretchPlan::force_max};
  for (std::size_t k = 0; k < static_cast<std::size_t>(config.axis_count); ++k) {
    const AxisLimits& axis = config.axes[k];
    use.include({.velocity = axis.velocity_max / axis.acceleration_max,
                 .thrust = axis.velocity_max / axis.jerk_max,
                 .coupling = axis.acceleration_max / axis.jerk_max});
  }
  return use.pace_limits();
}

bool is_even(const Phase& phase) {
  return phase.a == 0.0 && phase.j == 0.0;
}

// Where a stretch may be divided: no speed changes where the phase begins.
bool is_level(const Phase& phase) {
  return phase.a == 0.0 && phase.v > 0.0;
}

// Whether the speed is lowest there: it has fallen before and rises behind. Every motion within the
// limits can come to such a state and go on from it; to the top of a ramp that uses all of them
// leads no other way than that ramp.
bool is_lowest(const std::vector<Phase>& phases, std::size_t k) {
  if (!is_level(phases[k])) return false;
  std::size_t before = k;
  while (before > 0 && is_even(phases[before - 1])) --before;
  std::size_t behind = k;
  while (behind < phases.size() && is_even(phases[behind])) ++behind;
  const bool has_fallen = before == 0 || phases[before - 1].v > phases[before - 1].v_end;
  const bool rises = behind == phases.size() || phases[behind].v_end > phases[behind].v;
  return has_fallen && rises;
}

}  // namespace

PlanImprovement::PlanImprovement(const MotionConfig& config)
    : stretch_plan_(config), widest_(widest_of(config)) {}

void PlanImprovement::improve(const PlannedPath& path, std::vector<Phase>& phases) {
  path_ = path;
  index_.reset(path.segments);
  find_parts(phases);
  std::ranges::reverse(parts_);
  improved_.clear();
  done_ = 0.0;
  while (!parts_.empty()) {
    const Part part = parts_.back();
    parts_.pop_back();
    if (phases_on(index_.at(part.s0)) > segment_phases_max || !may_gain(part)) continue;
    const bool is_planned = plan_part(phases, with_room(phases, part)) || plan_part(phases, part);
    if (!is_planned) divide(phases, part);
  }
  if (done_ == 0.0) return;
  append_between(phases, done_, unlimited, improved_);
  join_pace_limits();
  phases.swap(improved_);
}

// Of what is done.
std::size_t PlanImprovement::phases_on(std::size_t segment) const {
  const double start = index_.start(segment);
  const auto on_it = [start](const Phase& phase) { return phase.s_end > start; };
  const auto behind = std::ranges::find_if_not(improved_.rbegin(), improved_.rend(), on_it);
  return static_cast<std::size_t>(behind - improved_.rbegin());
}

// Stretches that meet are run more slowly under limits that they have in common: those of their
// parts, or the widest where not all parts are known at one time.
void PlanImprovement::join_pace_limits() {
  const auto has_none = [](const Phase& phase) { return !phase.pace.holds(); };
  for (auto first = improved_.begin(); first != improved_.end();) {
    first = std::find_if_not(first, improved_.end(), has_none);
    const auto last = std::find_if(first, improved_.end(), has_none);
    const bool is_known = !(path_.follows_others && first == improved_.begin()) &&
                          !(path_.goes_on && last == improved_.end());
    PaceLimits all = is_known ? PaceLimits{} : widest_;
    for (auto phase = first; phase != last; ++phase) all = highest_of(all, phase->pace);
    for (; first != last; ++first) first->pace = all;
  }
}

// With some of the feed that is held on either side: a ramp that uses the limits to the full ends
// just there, and a stretch may use somewhat less of them.
PlanImprovement::Part PlanImprovement::with_room(const std::vector<Phase>& phases,
                                                 const Part& part) const {
  const auto room = [&](const Phase& phase) {
    return phase.v * std::min(room_time, room_part * phase.duration);
  };
  Part wide = part;
  const bool begins_behind_held =
      part.first > 0 && part.s0 == phases[part.first].s && holds_feed(phases[part.first - 1]);
  if (begins_behind_held) wide.s0 -= room(phases[--wide.first]);
  const bool ends_before_held = part.last < phases.size() &&
                                part.s1 == phases[part.last - 1].s_end &&
                                holds_feed(phases[part.last]);
  if (ends_before_held) wide.s1 += room(phases[wide.last++]);
  return wide;
}

bool PlanImprovement::plan_part(const std::vector<Phase>& phases, const Part& part) {
  return plan_joined(phases, part) || plan_alone(phases, part);
}

bool PlanImprovement::plan_alone(const std::vector<Phase>& phases, const Part& part) {
  const std::span<const Phase> planned = stretch_plan_.plan(stretch_of(phases, part));
  if (planned.empty()) return false;
  append_between(phases, done_, part.s0, improved_);
  last_planned_ = improved_.size();
  improved_.insert(improved_.end(), planned.begin(), planned.end());
  done_ = part.s1;
  return true;
}

// Where the part follows a stretch that was planned: with the end of that one, whose speed at the
// place where they meet was that of the plan of ramps. From some of its states, which use nearly
// all of the limits, no other motion goes on.
bool PlanImprovement::plan_joined(const std::vector<Phase>& phases, const Part& part) {
  if (part.s0 != done_ || improved_.empty()) return false;
  std::size_t back = std::min(joined_max, (improved_.size() - last_planned_) / 2);
  for (int k = 0; k < places_max && back > 0; ++k, back = back * 2 / 3) {
    if (plan_from(improved_.size() - back, phases, part)) return true;
  }
  return false;
}

bool PlanImprovement::plan_from(std::size_t first, const std::vector<Phase>& phases,
                                const Part& part) {
  joined_.assign(improved_.begin() + static_cast<std::ptrdiff_t>(first), improved_.end());
  append_between(phases, part.s0, part.s1, joined_);
  const Stretch stretch{.segments = path_.segments,
                        .jerk_parts = path_.jerk_parts,
                        .index = &index_,
                        .phases = joined_,
                        .s0 = joined_.front().s,
                        .s1 = part.s1};
  const std::span<const Phase> planned = stretch_plan_.plan(stretch);
  if (planned.empty()) return false;
  improved_.resize(first);
  last_planned_ = first;
  improved_.insert(improved_.end(), planned.begin(), planned.end());
  done_ = part.s1;
  return true;
}

bool PlanImprovement::holds_feed(const Phase& phase) const {
  if (phase.a != 0.0 || phase.j != 0.0 || phase.duration < held_min) return false;
  const std::size_t last = index_.before(phase.s_end);
  for (std::size_t k = index_.at(phase.s); k <= last; ++k) {
    if (phase.v < same_speed * path_.segments[k].feed_per_s) return false;
  }
  return true;
}

// Steps of a law, and what turns so suddenly within itself that a few places do not tell of it: the
// proof of a stretch would not see the peak of a cusp.
bool PlanImprovement::stays(std::size_t segment) const {
  constexpr double sudden = 10.0;  // a quintic blend has some 5
  const Segment& of = path_.segments[segment];
  return of.process.law != nullptr || of.bounds.aberrancy * of.length > sudden * of.bounds.bend;
}

// Between places where the plan holds the feed. Long ones are divided where the speed is lowest, or
// where a = 0.
void PlanImprovement::find_parts(const std::vector<Phase>& phases) {
  parts_.clear();
  constexpr double most = stretch_max;  // also of a phase that never ends
  std::size_t first = 0;
  std::size_t intervals = 0;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    const bool is_held = holds_feed(phases[k]);
    const bool is_long = (intervals > stretch_max && is_lowest(phases, k)) ||
                         (intervals > 2 * stretch_max && is_level(phases[k]));
    if (is_held || is_long) {
      add_part(phases, first, k);
      first = is_held ? k + 1 : k;
      intervals = 0;
    }
    const double estimate = std::min(most, phases[k].duration / typical_interval);
    const auto by_time = static_cast<std::size_t>(estimate);
    intervals += std::max(by_time, index_.at(phases[k].s_end) - index_.at(phases[k].s));
  }
  add_part(phases, first, phases.size());
}

// Without the segments that stay: what lies between two of them is a stretch.
void PlanImprovement::add_part(const std::vector<Phase>& phases, std::size_t first,
                               std::size_t last) {
  if (first == last) return;
  const double s_end = phases[last - 1].s_end;
  double s0 = phases[first].s;
  const std::size_t last_segment = index_.before(s_end);
  for (std::size_t k = index_.at(s0); k <= last_segment; ++k) {
    if (!stays(k)) continue;
    if (index_.start(k) > s0) parts_.push_back({s0, index_.start(k), first, last});
    s0 = index_.start(k + 1);
  }
  if (s_end > s0) parts_.push_back({s0, s_end, first, last});
}

// Not on straight lines in one direction, whose ramps are the fastest already.
bool PlanImprovement::may_gain(const Part& part) const {
  const std::size_t last = index_.before(part.s1);
  bool bends = false;
  for (std::size_t k = index_.at(part.s0); k <= last; ++k) {
    const Segment& segment = path_.segments[k];
    const SegmentBounds& bounds = segment.bounds;
    bends = bends || bounds.curvature > 0.0 || bounds.bend > 0.0 || bounds.aberrancy > 0.0;
  }
  return bends;
}

// With the phases that reach into it alone.
Stretch PlanImprovement::stretch_of(const std::vector<Phase>& phases, const Part& part) const {
  std::size_t first = part.first;
  std::size_t last = part.last;
  while (phases[first].s_end <= part.s0) ++first;
  while (last > first + 1 && phases[last - 1].s >= part.s1) --last;
  return {.segments = path_.segments,
          .jerk_parts = path_.jerk_parts,
          .index = &index_,
          .phases = std::span<const Phase>(phases).subspan(first, last - first),
          .s0 = part.s0,
          .s1 = part.s1};
}

// A stretch of which no motion was proved: where the speed is lowest, or a = 0, nearest to its
// middle.
void PlanImprovement::divide(const std::vector<Phase>& phases, const Part& part) {
  if (part.last - part.first < divided_min) return;
  const std::size_t middle = (part.first + part.last) / 2;
  const auto off = [middle](std::size_t at) { return at > middle ? at - middle : middle - at; };
  std::size_t best = 0;
  bool is_best_lowest = false;
  for (std::size_t k = part.first + 2; k + 2 < part.last; ++k) {
    if (!is_level(phases[k]) || phases[k].s <= part.s0 || phases[k].s >= part.s1) continue;
    const bool is_low = is_lowest(phases, k);
    const bool is_better = is_low == is_best_lowest ? off(k) < off(best) : is_low;
    if (best != 0 && !is_better) continue;
    best = k;
    is_best_lowest = is_low;
  }
  if (best == 0) return;
  parts_.push_back({phases[best].s, part.s1, best, part.last});
  parts_.push_back({part.s0, phases[best].s, part.first, best});
}

}  // namespace stanok::motion
