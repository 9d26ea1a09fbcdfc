#include "motion/threads/thread_builder.h"

#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"
#include "motion/path/sampling.h"
#include "motion/path/shape.h"

namespace stanok::motion {
namespace {

constexpr std::size_t blocks_max = 500;  // three segments each, in one chunk of the queue

// A corner is made for a spindle that turns so much faster than programmed, where it may be; it
// must be good for the lesser one.
constexpr double reserve_wanted = 1.45;
constexpr double reserve_least = 1.25;

// The jerk that a corner leaves to the controller, over what one block needs for its encoder, where
// it may be; the lesser one is what no random chain came off the law with.
constexpr double jerk_wanted = 1.0;
constexpr double jerk_least = 0.6;

// The part of a block that one corner may take; and the part where another one follows that needs
// room.
constexpr double part_max = 0.95;
constexpr double part_of_two = 0.475;

// Where a spindle begins to brake or to turn back its acceleration steps, that of an axis does not:
// the axis is off the helix by some 0.9 of this over the square of the observer's bandwidth, 1.7
// um.
constexpr double reversal_mm_per_s2 = 120.0;

// Turns that a spindle may overrun the bottom of a tap, where the axes have the room.
constexpr std::array<double, 3> overruns{1.0, 0.25, 0.0};

SegmentBounds largest(const SegmentBounds& one, const SegmentBounds& other) {
  return {.velocity = std::max(one.velocity, other.velocity),
          .tangent = std::max(one.tangent, other.tangent),
          .thrust = std::max(one.thrust, other.thrust),
          .curvature = std::max(one.curvature, other.curvature),
          .bend = std::max(one.bend, other.bend),
          .aberrancy = std::max(one.aberrancy, other.aberrancy)};
}

// Sums of what acts along and across the path: where s counts turns no Euclidean length is 1.
SegmentBounds bounds_by_turns(const Segment& segment, const MotionConfig& config) {
  SegmentBounds bounds = segment_bounds(segment, config);
  bounds.euclidean = {};
  return bounds;
}

ThreadFault too_slow_axis(const Segment& segment, double speed, const MotionConfig& config) {
  JetPoint point;
  JetPoint axes;
  evaluate(segment, 0.0, point);
  to_machine(segment, point, axes);
  ThreadFault fault{.kind = ThreadFault::Kind::axis_too_slow,
                    .speed_max = SpindleCoupling::speed_share / segment.bounds.velocity};
  double most = 0.0;
  for (int k = 0; k < config.axis_count; ++k) {
    const double used = std::abs(axes[k].first) / config.axes[k].velocity_max;
    if (used <= most) continue;
    most = used;
    fault.axis = k;
    fault.value = std::abs(axes[k].first) * speed;
    fault.limit = SpindleCoupling::speed_share * config.axes[k].velocity_max;
  }
  return fault;
}

ThreadFault unreachable(const Excess& excess) {
  return {.kind = ThreadFault::Kind::unreachable,
          .axis = excess.axis,
          .value = excess.position,
          .limit = excess.limit};
}

Point on(const Point& start, const Point& per_turn, double turns) {
  Point point = start;
  for (std::size_t k = 0; k < point.size(); ++k) point[k] += per_turn[k] * turns;
  return point;
}

}  // namespace

void ThreadBuilder::begin(const Point& start, const std::array<int, 3>& geometry,
                          const SpindleCoupling& coupling, double speed, double jerk_to_follow) {
  config_.geometry = geometry;
  coupling_ = coupling;
  speed_ = speed;
  jerk_to_follow_ = jerk_to_follow;
  straights_ = {};
  end_ = start;
  blocks_.clear();
}

ThreadBuilder::Straight ThreadBuilder::straight(const ThreadBlock& block,
                                                const Point& start) const {
  PathMetric metric{config_.axis_count, 0};
  for (const int axis : config_.geometry) {
    if (axis >= 0) metric.axes |= 1U << static_cast<unsigned>(axis);
  }
  const Shape shape = line(metric, start, block.end);
  Straight straight;
  straight.whole.tag = block.tag;
  straight.whole.geometry = shape.geometry;
  straight.whole.length = shape.length / block.lead_mm;
  straight.whole.feed_per_s = speed_;
  straight.whole.transform = block.transform;
  straight.whole.bounds = bounds_by_turns(straight.whole, config_);
  for (std::size_t k = 0; k < start.size(); ++k)
    straight.per_turn[k] = (block.end[k] - start[k]) / straight.whole.length;
  straight.tolerance = block.tolerance_mm;
  straight.keeps_tolerance = block.keeps_tolerance;
  straight.runs_out = block.runs_out;
  straight.from_point = start;
  return straight;
}

std::optional<ThreadFault> ThreadBuilder::fault_of(const Straight& block, double lead_mm) const {
  if (const auto excess = soft_limit_excess(block.whole, config_)) return unreachable(*excess);
  if (block.whole.bounds.velocity * speed_ > SpindleCoupling::speed_share)
    return too_slow_axis(block.whole, speed_, config_);
  const double jerk = segment_limits(block.whole.bounds, unlimited).j;
  if (jerk < jerk_to_follow_) {
    return ThreadFault{.kind = ThreadFault::Kind::encoder_too_coarse,
                       .lead_max = lead_mm * jerk / jerk_to_follow_};
  }
  return std::nullopt;
}

void ThreadBuilder::set_speed(double speed) {
  speed_ = speed;
  for (Straight& block : blocks_) block.whole.feed_per_s = speed;
}

std::optional<ThreadFault> ThreadBuilder::turn_faster(double speed) {
  if (speed <= speed_) return std::nullopt;
  for (const Straight& block : blocks_) {
    if (block.whole.bounds.velocity * speed > SpindleCoupling::speed_share)
      return too_slow_axis(block.whole, speed, config_);
  }
  const double before = speed_;
  set_speed(speed);
  auto fault = round_corners_anew();
  if (fault) set_speed(before);
  return fault;
}

std::optional<ThreadFault> ThreadBuilder::add(const ThreadBlock& block) {
  auto fault = add_where_it_is(block);
  const bool is_corner = fault && fault->kind == ThreadFault::Kind::corner_too_sharp;
  if (!is_corner || !block.runs_out || !add_earlier(block)) return fault;
  return std::nullopt;
}

// From within the block before: the turns that this one loses are those of the way out, so that the
// axis of the lead goes on by the law. False: nothing has changed.
bool ThreadBuilder::add_earlier(ThreadBlock block) {
  constexpr double first = 0.1;  // of the turns of the way out
  constexpr double growth = 1.2;
  const Straight before = blocks_.back();
  const Point end = end_;
  const double turns = straight(block, end).whole.length;
  const double turns_free = part_max * (before.whole.length - before.from);
  for (double taken = first * turns; taken < turns_free; taken *= growth) {
    Straight& shorter = blocks_.back();
    shorter.whole.length = before.whole.length - taken;
    shorter.whole.geometry.end =
        on(before.whole.geometry.start, before.per_turn, shorter.whole.length);
    end_ = shorter.whole.geometry.end;
    block.lead_mm *= straight(block, end_).whole.length / (turns + taken);
    if (!add_where_it_is(block)) return true;
    blocks_.back() = before;
  }
  end_ = end;
  return false;
}

std::optional<ThreadFault> ThreadBuilder::add_where_it_is(const ThreadBlock& block) {
  Straight next = straight(block, end_);
  if (auto fault = fault_of(next, block.lead_mm)) return fault;
  if (blocks_.size() >= blocks_max) return ThreadFault{.kind = ThreadFault::Kind::too_many_blocks};
  const SegmentBounds straights = straights_;
  straights_ = largest(straights_, next.whole.bounds);
  auto fault = append(next);
  if (fault) straights_ = straights;
  if (!fault) end_ = block.end;
  return fault;
}

// The jerk of a chain is the least of its blocks and corners together. A block with a larger lead
// leaves the corners before it less than they were made for: they are made anew.
std::optional<ThreadFault> ThreadBuilder::append(const Straight& next) {
  if (auto fault = connect(next)) return fault;
  if (leaves_jerk(bounds_of_chain(), speed_, jerk_least * jerk_to_follow_)) return std::nullopt;
  auto fault = round_corners_anew();
  if (!fault) return std::nullopt;
  blocks_.pop_back();
  if (!blocks_.empty()) blocks_.back().corner.reset();
  return fault;
}

std::optional<ThreadFault> ThreadBuilder::round_corners_anew() {
  const std::vector<Straight> made = blocks_;
  blocks_.clear();
  std::optional<ThreadFault> fault;
  for (std::size_t k = 0; k < made.size() && !fault; ++k) {
    Straight block = made[k];
    block.corner.reset();
    fault = connect(block);
  }
  const SegmentBounds bounds = bounds_of_chain();
  if (!fault && !leaves_jerk(bounds, speed_, jerk_least * jerk_to_follow_)) {
    fault = ThreadFault{.kind = ThreadFault::Kind::corner_too_sharp,
                        .speed_max = speed_that_leaves_jerk(bounds)};
  }
  if (fault) blocks_ = made;
  return fault;
}

// Limits of a chain with corners at this speed of the spindle, turns/s.
SegmentLimits ThreadBuilder::limits_at(const SegmentBounds& bounds, double speed) {
  return segment_limits(bounds, speed > 0.0 ? reserve_least * speed : unlimited);
}

// For the controller, so that the path follows the steps of the encoder. Of a speed that is not
// known nothing is asked.
bool ThreadBuilder::leaves_jerk(const SegmentBounds& bounds, double speed, double jerk) {
  return speed <= 0.0 || limits_at(bounds, speed).j >= jerk;
}

double ThreadBuilder::speed_that_leaves_jerk(const SegmentBounds& bounds) const {
  constexpr int halvings = 40;
  double low = 0.0;
  double high = speed_;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (leaves_jerk(bounds, middle, jerk_least * jerk_to_follow_) ? low : high) = middle;
  }
  return low;
}

SegmentBounds ThreadBuilder::bounds_of_chain() const {
  SegmentBounds bounds;
  for (const Straight& block : blocks_) {
    bounds = largest(bounds, block.whole.bounds);
    if (block.corner) bounds = largest(bounds, block.corner->bounds);
  }
  return bounds;
}

// Joins a block to the chain. Where the corner before left too little room, it is made smaller.
std::optional<ThreadFault> ThreadBuilder::connect(Straight next) {
  if (blocks_.empty()) {
    blocks_.push_back(next);
    return std::nullopt;
  }
  Straight one = blocks_.back();
  auto fault = join(one, next, part_max);
  if (fault && blocks_.size() > 1 && one.from > part_of_two * one.whole.length) {
    Straight before = blocks_[blocks_.size() - 2];
    fault = join(before, one, part_of_two);
    if (!fault) fault = join(one, next, part_max);
    if (!fault) blocks_[blocks_.size() - 2] = before;
  }
  if (fault) return fault;
  blocks_.back() = one;
  blocks_.push_back(next);
  return std::nullopt;
}

std::optional<ThreadFault> ThreadBuilder::add_tap(const ThreadBlock& block) {
  Straight tap = straight(block, end_);
  if (auto fault = fault_of(tap, block.lead_mm)) return fault;
  coupling_.bottom = tap.whole.length;
  coupling_.lead_mm = block.lead_mm;
  coupling_.spindle_acceleration =
      std::min(coupling_.spindle_acceleration, reversal_mm_per_s2 / block.lead_mm);
  for (const double overrun : overruns) {
    ThreadBlock longer = block;
    longer.end = on(block.end, tap.per_turn, overrun);
    Straight with_overrun = straight(longer, end_);
    if (fault_of(with_overrun, block.lead_mm)) continue;
    blocks_.push_back(with_overrun);
    break;
  }
  return std::nullopt;
}

// The change of the speed of the tip at a corner, in mm per turn.
double ThreadBuilder::change_of_lead(const Straight& one, const Straight& next) const {
  double squared = 0.0;
  for (std::size_t k = 0; k < next.per_turn.size(); ++k) {
    const double change = next.per_turn[k] - one.per_turn[k];
    if (one.whole.geometry.metric.counts(k)) squared += change * change;
  }
  return std::sqrt(squared);
}

// `turns` on both sides.
ThreadBuilder::Corner ThreadBuilder::corner(const Straight& one, const Straight& next,
                                            double turns) const {
  Corner corner{.before = one.whole, .behind = one.whole, .turns = turns, .bounds = {}};
  Geometry& before = corner.before.geometry;
  Geometry& behind = corner.behind.geometry;
  const double h = turns;
  before.kind = behind.kind = SegmentKind::even;
  before.start = on(one.whole.geometry.end, one.per_turn, -h);
  behind.end = on(next.whole.geometry.start, next.per_turn, h);
  for (int k = 0; k < config_.axis_count; ++k) {
    const double d1 = one.per_turn[k];
    const double change = next.per_turn[k] - d1;
    before.end[k] = behind.start[k] = before.start[k] + h * (d1 + change / 6.0);
    before.coefficients[k] = {before.start[k], h * d1, 0.0, h * change / 6.0, 0.0, 0.0};
    behind.coefficients[k] = {
        behind.start[k], h * (d1 + 0.5 * change), 0.5 * h * change, -h * change / 6.0, 0.0, 0.0};
  }
  for (Segment* segment : {&corner.before, &corner.behind}) {
    segment->length = turns;
    segment->bounds = bounds_by_turns(*segment, config_);
    corner.bounds = largest(corner.bounds, segment->bounds);
  }
  return corner;
}

// The corner as large as the tolerance, or, where that is allowed, as the axes need; it takes no
// more than a part of `next`.
std::optional<ThreadFault> ThreadBuilder::join(Straight& one, Straight& next, double part) const {
  constexpr double same_lead = 1e-9;       // mm
  constexpr double deviation = 1.0 / 6.0;  // over h |d2 - d1|
  constexpr double exact = 1e-6;           // mm
  constexpr double growth = 1.1;
  next.from = 0.0;
  next.from_point = next.whole.geometry.start;
  const double change = change_of_lead(one, next);
  if (change < same_lead) return std::nullopt;
  const double turns_max =
      std::min(part_max * (one.whole.length - one.from), part * next.whole.length);
  const double tolerance = std::max(exact, std::min(one.tolerance, next.tolerance));
  const bool may_grow = next.runs_out || (!one.keeps_tolerance && !next.keeps_tolerance);
  Corner found = corner(one, next, std::min(turns_max, tolerance / (deviation * change)));
  const auto has_reserve = [this](const Corner& of) {
    return segment_limits(of.bounds, unlimited).v >= reserve_wanted * speed_ &&
           leaves_jerk(largest(straights_, of.bounds), speed_, jerk_wanted * jerk_to_follow_);
  };
  while (may_grow && found.turns < turns_max && !has_reserve(found))
    found = corner(one, next, std::min(turns_max, growth * found.turns));
  const SegmentBounds bounds = largest(straights_, found.bounds);
  const double speed_max = segment_limits(found.bounds, unlimited).v / reserve_least;
  if (speed_max < speed_ || !leaves_jerk(bounds, speed_, jerk_least * jerk_to_follow_)) {
    return ThreadFault{.kind = ThreadFault::Kind::corner_too_sharp,
                       .speed_max = std::min(speed_max, speed_that_leaves_jerk(bounds))};
  }
  if (const auto excess = soft_limit_excess(found.behind, config_)) return unreachable(*excess);
  if (const auto excess = soft_limit_excess(found.before, config_)) return unreachable(*excess);
  next.from = found.turns;
  next.from_point = found.behind.geometry.end;
  one.corner = found;
  return std::nullopt;
}

ThreadChain ThreadBuilder::finish() {
  ThreadChain chain;
  const SegmentBounds bounds = bounds_of_chain();
  bool has_corner = false;
  for (const Straight& block : blocks_) {
    Segment rest = block.whole;
    rest.geometry.start = block.from_point;
    rest.length -= block.from;
    if (block.corner) {
      rest.geometry.end = block.corner->before.geometry.start;
      rest.length -= block.corner->turns;
    }
    chain.segments.push_back(rest);
    if (!block.corner) continue;
    has_corner = true;
    chain.segments.push_back(block.corner->before);
    chain.segments.push_back(block.corner->behind);
  }
  const double speed = has_corner ? speed_ : 0.0;
  const auto section = [speed](const SegmentBounds& of) {
    const SegmentLimits limits = limits_at(of, speed);
    return SpindleCoupling::Section{limits.a, limits.j};
  };
  chain.coupling = coupling_;
  chain.coupling.speed_max = limits_at(bounds, speed).v;
  chain.coupling.chain = section(bounds);
  chain.coupling.entry = section(chain.segments.front().bounds);
  chain.coupling.exit = section(chain.segments.back().bounds);
  chain.coupling.entry_end = chain.segments.front().length;
  for (const Segment& segment : chain.segments) chain.coupling.exit_begin += segment.length;
  chain.coupling.exit_begin -= chain.segments.back().length;
  blocks_.clear();
  return chain;
}

}  // namespace stanok::motion
