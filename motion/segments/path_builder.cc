// Blocks to segments, two blocks behind (motion/segments/path_builder.h).
//
// A line is held back until the next block is known, which it may grow by. The last block behind
// that is pending: its start is settled, its end waits for the join with the block
// that follows. A blend takes at most half of the block that follows, and of the pending block all
// that the blend at its start has left: the two never meet, and every second half is used.
#include "motion/segments/path_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "motion/bounds/segment_bounds.h"
#include "motion/path/block_metric.h"
#include "motion/path/geometry.h"
#include "motion/path/sampling.h"
#include "motion/path/shape.h"
#include "motion/path/swing.h"
#include "motion/segments/corner.h"

namespace stanok::motion {
namespace {

// "Exact" path: what a tolerance of 0 still permits, a millionth of a micrometre. It lets tangent
// joins with rounded coordinates or a step of curvature pass slowly; real corners stop.
constexpr double exact_tolerance = 1e-9;  // mm or deg
// s; an overlap that gains less is not worth that both legs are bound to each other.
constexpr double overlap_gain_min = 0.0005;

// Of the whole tolerance, that corners left out of a line may use; blends have the rest.
constexpr double straightening_share = 0.8;

constexpr double shortest_part = 0.02;  // mm; of a block that is divided near a singularity

Shape shape_of(const Point& start, const PathBlock& block, const MotionConfig& config) {
  const bool on_geometry = std::ranges::any_of(config.geometry, [&](int axis) {
    return axis >= 0 && at(block.end, axis) != at(start, axis);
  });
  BlockTravel moved = travel_of(block, start, config);
  if (moved == BlockTravel::none && on_geometry) moved = BlockTravel::geometry;
  const PathMetric metric = metric_of(moved, config);
  if (is_point_like(block, start)) return line(metric, start, block.end);
  switch (block.kind) {
    case BlockKind::arc:
      return arc(metric, start, block);
    case BlockKind::curve:
      return curve(metric, start, block);
    case BlockKind::line:
      break;
  }
  return line(metric, start, block.end);
}

SegmentProcess process_of(const BlockProcess& block) {
  return {.law = block.law,
          .path_start = block.path_start,
          .path_stop = block.path_start + block.path_length,
          .path_end = block.path_end,
          .rev_per_min = block.rev_per_min};
}

// The process of a part of the segment, between two of its path lengths.
SegmentProcess part_of_process(const Segment& whole, double from, double to) {
  SegmentProcess process = whole.process;
  const double length = process.path_stop - process.path_start;
  process.path_start = whole.process.path_start + length * (from / whole.length);
  if (to < whole.length)
    process.path_stop = whole.process.path_start + length * (to / whole.length);
  return process;
}

// The soft limits less what a smooth run may deviate. Where TCP leads the tip through rotary axes,
// their deviation is felt at the end of a lever.
MotionConfig narrowed(MotionConfig config, const Segment& segment, const Tolerance& tolerance) {
  constexpr double lever = 1000.0;  // mm
  const double swing = is_affine(segment) ? 0.0 : lever * tolerance.deg * std::numbers::pi / 180.0;
  for (AxisLimits& axis : config.axes) {
    const double margin = axis.linear ? tolerance.mm + swing : tolerance.deg;
    axis.position_min += margin;
    axis.position_max -= margin;
  }
  return config;
}

}  // namespace

PathBuilder::PathBuilder(const MotionConfig& config)
    : config_(config), straightening_(config), run_(config) {}

void PathBuilder::restart(const Point& point, const std::array<int, 3>& geometry) {
  if (geometry != config_.geometry) {
    config_.geometry = geometry;
    run_ = SmoothRun(config_);
    straightening_ = Straightening(config_);
  }
  line_.reset();
  pending_.reset();
  standing_.reset();
  run_.clear();
  stands_ = true;
  end_ = point;
}

std::optional<Unreachable> PathBuilder::add(const PathBlock& block) {
  if (travel_of(block, programmed_end(), config_) == BlockTravel::none) return stand(block);
  STANOK_ASSERT(block.rapid || block.feed_per_s > 0.0);
  Pending next = pending_from(block);
  if (next.whole.length <= 0.0) return stand(block);  // back over what was not moved before
  next.keeps_clear = !soft_limit_excess(next.whole, narrowed(config_, next.whole, next.total));
  if (!next.keeps_clear) {
    if (const auto excess = soft_limit_excess(next.whole, config_)) {
      return Unreachable{block.tag, excess->axis, excess->position, excess->limit};
    }
  }
  take(next);
  end_ = block.end;
  standing_.reset();
  if (block.ending == BlockEnding::exact_stop) finish();
  return std::nullopt;
}

std::optional<Unreachable> PathBuilder::stand(const PathBlock& block) {
  standing_ = block;
  if (block.ending == BlockEnding::exact_stop) finish();
  return std::nullopt;
}

// Where the program is, within some `standstill` of the end of the path.
const Point& PathBuilder::programmed_end() const {
  return standing_ ? standing_->end : end_;
}

void PathBuilder::keep_end() {
  if (line_) line_->keeps_end = true;
}

// A line is held back until it is known how far it goes.
void PathBuilder::take(const Pending& next) {
  if (line_ && may_straighten(*line_, next) && straighten(next)) return;
  settle_line();
  const Segment& whole = next.whole;
  const bool is_line = whole.geometry.kind == SegmentKind::line && !whole.rapid &&
                       whole.process.law == nullptr && next.corner.mm > 0.0 && next.keeps_clear;
  if (!is_line) return settle(next);
  line_ = next;
  straightening_.begin();
}

// Two blocks of one kind that meet in a corner which is too sharp for a run.
bool PathBuilder::may_straighten(const Pending& line, const Pending& next) const {
  const Segment& one = line.whole;
  const Segment& other = next.whole;
  if (line.keeps_end || !next.keeps_clear || other.geometry.kind != SegmentKind::line) return false;
  const bool is_alike = one.feed_per_s == other.feed_per_s && one.rapid == other.rapid &&
                        other.process.law == nullptr &&
                        one.process.rev_per_min == other.process.rev_per_min;
  return is_alike && judge_join(one, other) == Join::corner &&
         !run_.may_join(one, other, lower_of(line.tolerance, next.tolerance));
}

bool PathBuilder::straighten(const Pending& next) {
  const Tolerance allowed = lower_of(line_->corner, next.corner);
  const auto off = straightening_.extend(line_->whole, next.whole, allowed);
  if (!off) return false;
  line_->corner = allowed;
  line_->programmed = lower_of(line_->programmed, next.programmed);
  line_->total = lower_of(line_->total, next.total);
  line_->tolerance =
      lower_of(line_->programmed, {line_->total.mm - off->mm, line_->total.deg - off->deg});
  return true;
}

void PathBuilder::settle_line() {
  if (!line_) return;
  const Pending line = *line_;
  line_.reset();
  settle(line);
}

void PathBuilder::settle(const Pending& next) {
  if (run_.is_open() && belong_together(last_of_run_, next)) {
    run_.add(next.whole, next.tolerance, smoothed_);
    last_of_run_ = next;
    return emit_run();
  }
  if (run_.is_open()) {
    const bool turns = judge_join(last_of_run_.whole, next.whole) == Join::turn;
    close_run(turns ? SmoothRun::End::at_rest : SmoothRun::End::straight);
  }
  if (!pending_) {
    pending_ = next;
  } else if (belong_together(*pending_, next)) {
    open_run(next);
  } else {
    join(next);
  }
}

void PathBuilder::finish() {
  settle_line();
  if (run_.is_open()) close_run(SmoothRun::End::at_rest);
  if (pending_) stop();
  if (standing_) stand_at_programmed_end();
}

// Blocks that did not move may have named another end by what rounding leaves: the axes go there,
// so that they stand where the program says, to the bit.
void PathBuilder::stand_at_programmed_end() {
  PathBlock block = *standing_;
  standing_.reset();
  block.kind = BlockKind::line;
  block.rapid = true;
  block.process = {};
  for (int k = config_.axis_count; k < axes_max; ++k) block.end[k] = end_[k];
  if (block.end == end_) return;
  pending_ = pending_from(block);
  end_ = block.end;
  if (pending_->whole.length > 0.0) return stop();
  pending_.reset();
}

// A corner between blocks so long that a swing to the full tolerance has room beside those at
// their other ends: no curve over several corners is faster.
bool PathBuilder::stands_alone(const Pending& one, const Pending& next,
                               const Tolerance& tolerance) const {
  return full_swing_reach(one.whole, next.whole, tolerance, config_) <=
         0.5 * std::min(one.whole.length, next.whole.length);
}

// Two blocks that may be neighbours in a smooth run.
bool PathBuilder::belong_together(const Pending& one, const Pending& next) const {
  const bool have_laws = one.whole.process.law != nullptr || next.whole.process.law != nullptr;
  const Tolerance tolerance = lower_of(one.tolerance, next.tolerance);
  return !have_laws && one.keeps_clear && next.keeps_clear &&
         run_.may_join(one.whole, next.whole, tolerance) && !stands_alone(one, next, tolerance);
}

void PathBuilder::open_run(const Pending& next) {
  const bool begins_chain = stands_ && pending_->from == 0.0 && pending_->straight == 0.0;
  const auto end = begins_chain ? SmoothRun::End::at_rest : SmoothRun::End::straight;
  const SmoothRun::Place place =
      run_.begin(pending_->whole, pending_->tolerance, end, {pending_->from, pending_->from_point});
  if (place.s > pending_->from) emit_pending(place.s, place.point);
  pending_.reset();
  run_.add(next.whole, next.tolerance, smoothed_);
  last_of_run_ = next;
  emit_run();
}

// What is left of the last block of a run is pending; the chain ends where nothing is.
void PathBuilder::close_run(SmoothRun::End end) {
  const SmoothRun::Place place = run_.end(end, smoothed_);
  emit_run();
  if (end == SmoothRun::End::at_rest) return end_chain();
  last_of_run_.from = place.s;
  last_of_run_.from_point = place.point;
  pending_ = last_of_run_;
}

void PathBuilder::emit_run() {
  for (const Segment& segment : smoothed_) append(segment);
  smoothed_.clear();
}

PathBuilder::Pending PathBuilder::pending_from(const PathBlock& block) const {
  const Shape shape = shape_of(end_, block, config_);
  Pending pending;
  pending.whole.tag = block.tag;
  pending.whole.geometry = shape.geometry;
  pending.whole.length = shape.length;
  pending.whole.feed_per_s = block.rapid ? unlimited : block.feed_per_s;
  pending.whole.rapid = block.rapid;
  pending.whole.transform = block.transform;
  pending.whole.process = process_of(block.process);
  pending.programmed = {block.tolerance_mm, block.tolerance_deg};
  pending.tolerance = pending.programmed;
  pending.total = {std::max(block.tolerance_mm, block.straightening_mm), block.tolerance_deg};
  const bool has_own = block.straightening_mm >= 0.0;
  const double most = straightening_share * pending.total.mm;
  pending.corner = {has_own ? std::min(block.straightening_mm, most) : most,
                    straightening_share * block.tolerance_deg};
  pending.from_point = end_;
  return pending;
}

void PathBuilder::join(const Pending& block) {
  Pending next = block;
  switch (judge_join(pending_->whole, next.whole)) {
    case Join::smooth:
      emit_pending(pending_->whole.length, pending_->whole.geometry.end);
      break;
    case Join::corner:
      join_corner(next);
      break;
    case Join::turn:
      stop();
      break;
  }
  pending_ = next;
}

// A curve, or a stop, which the next block may overlap: the fastest of them.
void PathBuilder::join_corner(Pending& next) {
  const Segment& incoming = pending_->whole;
  const Segment& outgoing = next.whole;
  const Tolerance tolerance = lower_of(pending_->tolerance, next.tolerance);
  const CornerPlace place{.incoming = incoming,
                          .outgoing = outgoing,
                          .left = incoming.length - std::max(pending_->from, pending_->straight)};
  const Tolerance allowed{std::max(exact_tolerance, tolerance.mm),
                          std::max(exact_tolerance, tolerance.deg)};
  const auto curve = corner_curve(place, allowed, config_);
  if (curve && curve->keeps_speed) return take(*curve, next);
  const auto overlap = overlap_corner(incoming, outgoing, tolerance, config_);
  OverlapGain gain;
  if (overlap) gain = overlap_gain(*overlap, incoming, outgoing, config_);
  const double by_stop = time_lost_by_stop(incoming, outgoing, config_) - gain.time;
  if (curve && curve->caution * curve->time_lost <= by_stop) return take(*curve, next);
  if (gain.time <= overlap_gain_min) return stop();
  stop_with_overlap(overlap, gain.jerk_part, next);
}

// Emits a curve and what is left of the pending block before it.
void PathBuilder::take(const CornerCurve& curve, Pending& next) {
  std::vector<Segment> segments = curve.segments;
  const double corner = pending_->whole.length;
  if (curve.reach < corner - pending_->from) {
    emit_pending(corner - curve.reach, segments.front().geometry.start);
  } else {
    // two curves touch: one point to the bit
    segments.front().geometry.start = pending_->from_point;
  }
  if (segments.size() == 1) {
    append_blend(segments.front(), next, curve.reach);
  } else {
    for (const Segment& segment : segments) append(segment);
  }
  next.from = curve.reach;
  next.from_point = segments.back().geometry.end;
}

// The pending block from where the blend at its start ends up to `to`, in two parts when they may
// use different jerks.
void PathBuilder::emit_pending(double to, const Point& to_point, double jerk_part_at_end) {
  const Pending& block = *pending_;
  if (block.jerk_part == jerk_part_at_end) {
    return emit_part(block.from, block.from_point, to, to_point, jerk_part_at_end);
  }
  const double middle = 0.5 * (block.from + to);
  JetPoint point_s;
  evaluate(block.whole, middle, point_s);
  const Point middle_point = contact(point_s).position;
  emit_part(block.from, block.from_point, middle, middle_point, block.jerk_part);
  emit_part(middle, middle_point, to, to_point, jerk_part_at_end);
}

// The bounds of a segment hold for all of it: near a singularity of the scheme, where they grow
// steeply, a segment is no longer than its distance from there.
void PathBuilder::emit_part(double from, const Point& from_point, double to, const Point& to_point,
                            double jerk_part) {
  const double length = to - from;
  if (length > shortest_part && has_singularity(pending_->whole)) {
    JetPoint point_s;
    const double middle = 0.5 * (from + to);
    evaluate(pending_->whole, middle, point_s);
    const Point middle_point = contact(point_s).position;
    const double clearance = std::min({distance_to_singularity(pending_->whole, from_point),
                                       distance_to_singularity(pending_->whole, middle_point),
                                       distance_to_singularity(pending_->whole, to_point)});
    if (length > clearance) {
      emit_part(from, from_point, middle, middle_point, jerk_part);
      return emit_part(middle, middle_point, to, to_point, jerk_part);
    }
  }
  Segment segment = pending_->whole;
  if (from > 0.0 || to < segment.length) {
    const Shape rest = part(pending_->whole, from, from_point, to, to_point);
    segment.geometry = rest.geometry;
    segment.length = rest.length;
    segment.process = part_of_process(pending_->whole, from, to);
  }
  segment.bounds = segment_bounds(segment, config_);
  append(segment, jerk_part);
}

// Between two blocks of one feed law its path goes on through the blend; else the blend belongs to
// either block up to its middle.
void PathBuilder::append_blend(Segment segment, const Pending& next, double reach) {
  const Segment& incoming = pending_->whole;
  const Segment& outgoing = next.whole;
  const SegmentProcess before =
      part_of_process(incoming, std::max(incoming.length - reach, 0.0), incoming.length);
  const SegmentProcess behind = part_of_process(outgoing, 0.0, reach);
  if (before.law == behind.law) {
    if (before.law != nullptr) {
      segment.process = before;
      segment.process.path_stop = behind.path_stop;
    }
    return append(segment);
  }
  const double middle = 0.5 * segment.length;
  JetPoint point_s;
  evaluate(segment, middle, point_s);
  const Point middle_point = contact(point_s).position;
  for (const bool first : {true, false}) {
    Segment half = segment;
    const Shape shape =
        first ? part(segment, 0.0, segment.geometry.start, middle, middle_point)
              : part(segment, middle, middle_point, segment.length, segment.geometry.end);
    half.geometry = shape.geometry;
    half.length = shape.length;
    half.process = first ? before : behind;
    append(half);
  }
}

void PathBuilder::append(const Segment& segment, double jerk_part) {
  built_.push_back({.segment = segment, .jerk_part = jerk_part});
  stands_ = false;
}

void PathBuilder::end_chain() {
  built_.back().ends_chain = true;
  stands_ = true;
}

// The pending block runs to its end and the path stands there.
void PathBuilder::stop() {
  emit_pending(pending_->whole.length, pending_->whole.geometry.end);
  end_chain();
  pending_.reset();
}

// The same, but `next` may begin before, on a straight path of several times the reach: at equal
// jerks it makes 2^3 reaches meanwhile.
void PathBuilder::stop_with_overlap(const std::shared_ptr<const OverlapCorner>& overlap,
                                    double jerk_part, Pending& next) {
  constexpr double reaches = 16.0;
  emit_pending(pending_->whole.length, pending_->whole.geometry.end, jerk_part);
  end_chain();
  built_.back().overlap = overlap;
  next.jerk_part = jerk_part;
  next.straight = std::min(reaches * overlap->reach, 0.5 * next.whole.length);
  pending_.reset();
}

}  // namespace stanok::motion
