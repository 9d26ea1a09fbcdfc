#include "motion/retrace/retrace.h"

#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

constexpr double as_good_as_there = 1e-9;  // mm or deg

}  // namespace

Retrace::Retrace(const MotionConfig& config, const PathHistory& history,
                 const kinematics::LengthChanges* lengths)
    : config_(config), track_(history), feed_(track_), planner_(config), place_(lengths) {}

void Retrace::begin(const Segment* held, double way, const Point& axes_M) RT_SAFE {
  track_.begin(held, way);
  is_on_ = true;
  stops_ = true;
  motion_ = {};
  left_ = 0.0;
  place_.stand_at(axes_M, {});
  if (track_.is_empty()) return;
  at_ = track_.before(track_.last());
  track_.read(at_, piece_);
  s_ = piece_.length;
}

void Retrace::end() RT_SAFE {
  is_on_ = false;
  stops_ = true;
  motion_ = {};
  cursor_.drop(feed_.queue());
}

void Retrace::go(RetraceWay way, double length) RT_SAFE {
  if (!stops_) {
    left_ = way == way_ ? left_ + length : std::max(left_ - length, 0.0);
    return;
  }
  if (!motion::is_at_rest(motion_) || is_at_end(way)) return;
  stops_ = false;
  left_ = length;
  const bool is_course_under_way = way == way_ && cursor_.has_chunk();
  if (!is_course_under_way) begin_course(way);
}

bool Retrace::is_at_end(RetraceWay way) const RT_SAFE {
  if (track_.is_empty()) return true;
  return way == RetraceWay::back ? at_ == track_.first() && s_ <= 0.0
                                 : track_.behind(at_) == track_.last() && s_ >= piece_.length;
}

std::uint64_t Retrace::blocks_left() const RT_SAFE {
  return is_at_end(RetraceWay::back) ? 0 : track_.blocks_up_to(at_);
}

// From the current place, which is not the last one that way. A place between two pieces belongs to
// the one that comes.
void Retrace::begin_course(RetraceWay way) RT_SAFE {
  cursor_.drop(feed_.queue());
  way_ = way;
  const bool is_back = way == RetraceWay::back;
  const bool is_behind_piece = is_back ? s_ <= 0.0 : s_ >= piece_.length;
  if (is_behind_piece) {
    at_ = is_back ? track_.before(at_) : track_.behind(at_);
    track_.read(at_, piece_);
    s_ = is_back ? piece_.length : 0.0;
  }
  number_ = cursor_.segment_number();
  feed_.begin(way, is_back ? track_.behind(at_) : at_);
  motion_ = {.s = is_back ? piece_.length - s_ : s_};
}

void Retrace::advance(const FeedControl& control, RetraceOutput& out) RT_SAFE {
  feed_.advance();
  FeedControl asked = control;
  asked.controlled_per_s = 0.0;
  asked.law_part = 1.0;
  asked.spindle_rev_per_min = 0.0;
  asked.closed_from_block = FeedControl::no_gate;
  double time = config_.cycle_s;
  constexpr int chunks_per_cycle_max = 8;
  for (int round = 0; round < chunks_per_cycle_max && time > 0.0; ++round) {
    if (!cursor_.has_chunk()) {
      if (stops_ || feed_.queue().chunks.empty()) break;
      enter();
    }
    asked.hold = stops_;
    time = run(asked, time);
    if (!finish_chunk()) break;
  }
  find_piece();
  const double part = piece_.segment().rapid ? control.rapid_override : control.feed_override;
  if ((left_ <= as_good_as_there || part == 0.0) && motion::is_at_rest(motion_)) stops_ = true;
  if (is_at_end(way_) && !cursor_.has_chunk()) stops_ = true;
  report(out);
}

void Retrace::enter() RT_SAFE {
  cursor_.enter(feed_.queue());
  planner_.forget();
}

// Where it shall stop, as far as that is in sight.
PathWall Retrace::wall() RT_SAFE {
  if (left_ == unlimited) return {};
  const PathQueue& queue = feed_.queue();
  const double s = motion_.s + std::max(left_, 0.0);
  double end = cursor_.segment_start();
  const std::uint32_t seen = cursor_.segments_seen(queue);
  for (std::uint32_t k = 0; k < seen; ++k) {
    end += queue.segments[k].length;
    if (s < end) return {.segment = cursor_.segment_number() + k, .s = s};
  }
  return {};
}

double Retrace::run(const FeedControl& control, double time) RT_SAFE {
  const PathMotion before = motion_;
  const bool is_stop = control.hold || control.feed_override == 0.0;
  const UsedLimits used =
      is_stop && !motion::is_at_rest(motion_) ? UsedLimits::of_stops : UsedLimits::of_axes;
  double left = 0.0;
  if (!planner_.advance(feed_.queue(), cursor_, control, used, wall(), time, motion_, left)) {
    motion_ = {.s = motion_.s};
    return 0.0;
  }
  left_ -= motion_.s - before.s;
  constexpr double jump = 1e-11;  // mm; far below any limit
  const double length = cursor_.chunk().length;
  if (motion::is_at_rest(motion_) && std::abs(motion_.s - length) < jump) motion_.s = length;
  cursor_.go_to(feed_.queue(), motion_.s);
  return left;
}

// Leaves the current chunk behind; false: it goes on.
bool Retrace::finish_chunk() RT_SAFE {
  PathQueue& queue = feed_.queue();
  const double length = cursor_.chunk().length;
  if (motion_.s < length) return false;
  if (cursor_.chunk().last) {
    if (!motion::is_at_rest(motion_)) return false;
    find_piece();
    cursor_.leave(queue);
    motion_ = {};
    return true;
  }
  if (queue.chunks.empty()) return false;
  cursor_.leave(queue);
  cursor_.enter(queue);
  planner_.shift(length);
  motion_.s -= length;
  cursor_.go_to(queue, motion_.s);
  return true;
}

// The piece that the cursor has come to, and how far into it.
void Retrace::find_piece() RT_SAFE {
  if (!cursor_.has_chunk()) return;
  const bool is_back = way_ == RetraceWay::back;
  const bool is_new = number_ < cursor_.segment_number();
  for (; number_ < cursor_.segment_number(); ++number_)
    at_ = is_back ? track_.before(at_) : track_.behind(at_);
  if (is_new) track_.read(at_, piece_);
  const double s = cursor_.s_in_segment(feed_.queue(), motion_.s);
  s_ = is_back ? piece_.length - s : s;
}

void Retrace::report(RetraceOutput& out) RT_SAFE {
  out.s_speed = motion_.v;
  if (track_.is_empty()) return;
  out.tag = piece_.segment().tag;
  const double sign = way_ == RetraceWay::back ? -1.0 : 1.0;
  JetPoint point_s;
  evaluate(piece_.segment(), s_, point_s);
  along_time(point_s, sign * motion_.v, sign * motion_.a, sign * motion_.j, config_.axis_count,
             out.point);
  place_.follow(piece_.segment(), out.point, out.axes);
}

}  // namespace stanok::motion
