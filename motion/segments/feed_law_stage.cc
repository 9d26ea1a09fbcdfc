#include "motion/segments/feed_law_stage.h"

#include <algorithm>

#include "motion/feed_laws/feed_law.h"
#include "motion/path/geometry.h"
#include "motion/path/shape.h"

namespace stanok::motion {
namespace {

// Gives a segment the feed and the speed of a stretch.
void apply(const FeedLaw& law, const LawStretch& stretch, std::uint64_t increments,
           Segment& segment) {
  SegmentProcess& process = segment.process;
  process.kind = law.kind();
  process.speed = law.units().speed;
  process.increments = increments;
  process.spindle_speed = stretch.speed;
  if (law.units().speed == LawSpeed::rev_per_min && process.rev_per_min > 0.0)
    process.rev_per_min = stretch.speed;
  if (stretch.feed > 0.0)
    segment.feed_per_s = feed_per_s(stretch.feed, law.units(), process.rev_per_min);
}

}  // namespace

double feed_per_s(double feed, const LawUnits& units, double rev_per_min) RT_SAFE {
  return (units.per_revolution ? feed * rev_per_min : feed) / s_per_min;
}

PathBuilder::Built FeedLawStage::next() {
  if (waiting_.front().segment.process.law != nullptr) return next_part();
  PathBuilder::Built built = waiting_.front();
  waiting_.pop_front();
  return built;
}

// Up to the next increment of the law, or the rest of the segment.
PathBuilder::Built FeedLawStage::next_part() {
  const PathBuilder::Built& whole = waiting_.front();
  const SegmentProcess& process = whole.segment.process;
  const FeedLaw& law = *process.law;
  const double length = whole.segment.length;
  const double path_per_s = (process.path_stop - process.path_start) / length;
  const double path_from = process.path_start + path_per_s * from_;
  const std::uint64_t increments = law.increments_at(path_from);
  const LawStretch stretch = law.stretch(increments);
  const bool is_rest = stretch.end_mm >= process.path_stop - same_path_mm;
  const double to = is_rest ? length : (stretch.end_mm - process.path_start) / path_per_s;
  const bool comes_to_increment = stretch.end_mm <= process.path_stop + same_path_mm;
  const bool law_goes_on = stretch.end_mm < process.path_end - same_path_mm;

  PathBuilder::Built built = whole;
  Segment& segment = built.segment;
  Point to_point = whole.segment.geometry.end;
  if (!is_rest) {
    JetPoint point_s;
    evaluate(whole.segment, to, point_s);
    to_point = contact(point_s).position;
  }
  if (from_ > 0.0 || !is_rest) {
    const Point from_point = from_ > 0.0 ? from_point_ : whole.segment.geometry.start;
    const Shape shape = part(whole.segment, from_, from_point, to, to_point);
    segment.geometry = shape.geometry;
    segment.length = shape.length;
  }
  apply(law, stretch, increments, segment);
  segment.process.path_start = path_from;
  segment.process.path_stop = std::min(stretch.end_mm, process.path_stop);
  built.counts_as_block = true;
  segment.process.spindle_speed_behind = law.stretch(law.increments_at(process.path_stop)).speed;
  if (stretch.stand_mm > 0.0 && comes_to_increment && law_goes_on) {
    built.ends_chain = true;
    built.overlap.reset();
    built.stand_mm = stretch.stand_mm;
  } else if (!is_rest) {
    built.ends_chain = false;
    built.overlap.reset();
  }
  from_ = is_rest ? 0.0 : to;
  from_point_ = to_point;
  if (is_rest) waiting_.pop_front();
  return built;
}

void FeedLawStage::clear() {
  waiting_.clear();
  from_ = 0.0;
}

}  // namespace stanok::motion
