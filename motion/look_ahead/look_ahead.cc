#include "motion/look_ahead/look_ahead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::motion {
namespace {

// Blocks from one tag to the next one; programs count their blocks.
std::uint64_t blocks_between(const BlockTag& from, const BlockTag& to) {
  if (from.run != to.run) return 1;
  return to.block >= from.block ? to.block - from.block : 1;
}

// Moves the phases before `s` from the front of one list to the end of another; a phase across `s`
// is split there.
void split_phases(std::vector<Phase>& phases, double s, std::vector<Phase>& before) {
  std::size_t count = 0;
  while (count < phases.size() && phases[count].s_end <= s) ++count;
  before.insert(before.end(), phases.begin(), phases.begin() + static_cast<std::ptrdiff_t>(count));
  phases.erase(phases.begin(), phases.begin() + static_cast<std::ptrdiff_t>(count));
  if (phases.empty() || phases.front().s >= s) return;
  Phase& across = phases.front();
  const double t = time_at(across, s);
  const PathMotion middle = motion_at(across, t);
  Phase first = across;
  first.duration = t;
  first.s_end = s;
  first.v_end = middle.v;
  before.push_back(first);
  across.duration -= t;
  across.s = s;
  across.v = middle.v;
  across.a = middle.a;
}

void shift(std::vector<Phase>& phases, double ds) {
  for (Phase& phase : phases) {
    phase.s -= ds;
    phase.s_end -= ds;
  }
}

constexpr std::size_t phases_kept_max = 200;

}  // namespace

LookAhead::LookAhead(const MotionConfig& config) : config_(config), improvement_(config) {}

void LookAhead::add(const PathBuilder::Built& built) {
  const Segment& segment = built.segment;
  STANOK_ASSERT(segment.length > 0.0);
  const std::uint64_t known = blocks_.empty() ? 0 : blocks_.back();
  const bool begins = window_.empty() || built.counts_as_block;
  blocks_.push_back(known + (begins ? 1 : blocks_between(window_.back().tag, segment.tag)));
  window_.push_back(segment);
  speeds_.push_back(speed_segment(segment, 1.0));
  speeds_.back().ramp.j *= built.jerk_part;
  jerk_parts_.push_back(built.jerk_part);
  chain_end_ = {.overlap = built.overlap, .stand_mm = built.stand_mm};
  if (built.ends_chain || blocks_.back() - blocks_.front() >= plan_at_blocks_) {
    plan_window(built.ends_chain ? Behind::end : Behind::more);
  }
}

void LookAhead::add(ThreadChain chain) {
  STANOK_ASSERT(window_.empty() && chain.segments.size() <= chunk_segments_max);
  Committed committed;
  committed.chunk = {.segments = static_cast<std::uint32_t>(chain.segments.size()),
                     .last = true,
                     .coupling = chain.coupling};
  for (const Segment& segment : chain.segments) committed.chunk.length += segment.length;
  committed.segments = std::move(chain.segments);
  ready_.push_back(std::move(committed));
}

bool LookAhead::deliver(PathQueue& queue) {
  while (!ready_.empty()) {
    Committed& next = ready_.front();
    if (next.overlap) return true;
    if (queue.segments.space() < next.segments.size() ||
        queue.phases.space() < next.phases.size() || queue.chunks.space() == 0) {
      return false;
    }
    bool pushed = true;
    for (const Segment& segment : next.segments) pushed = queue.segments.push(segment) && pushed;
    for (const Phase& phase : next.phases) pushed = queue.phases.push(phase) && pushed;
    next.chunk.sequence = delivered_.next_number();
    pushed = queue.chunks.push(next.chunk) && pushed;
    STANOK_ASSERT(pushed);
    delivered_.note(next.chunk, queue);
    ready_.pop_front();
  }
  return true;
}

bool LookAhead::is_empty() const {
  return window_.empty() && planned_.segments.empty() && ready_.empty();
}

void LookAhead::clear() {
  window_.clear();
  speeds_.clear();
  jerk_parts_.clear();
  blocks_.clear();
  planned_ = {};
  v_start_ = 0.0;
  plan_at_blocks_ = 2 * blocks_beyond;
  rest_.phases.clear();
  rest_.keys.clear();
  ready_.clear();
}

void LookAhead::plan_window(Behind behind) {
  if (!plan_.plan(speeds_, v_start_)) {
    run_last_plan_on(behind);
    if (window_.empty()) return;
    const bool stops = plan_.plan(speeds_, v_start_);
    STANOK_ASSERT(stops);
  }
  phases_.clear();
  for (const KeySpan& span : plan_.spans()) plan_.append_phases(span, phases_);
  const std::size_t boundary =
      behind == Behind::end
          ? window_.size()
          : cut_at_or_before(std::min(last_boundary_to_commit(), start_of_last_descent()));
  if (boundary == 0) {
    plan_at_blocks_ += blocks_beyond;
    return;
  }
  commit(boundary, behind);
  plan_at_blocks_ = 2 * blocks_beyond;
}

// Takes the window up to a boundary with a = 0, keeps what the plan holds for the rest, and commits
// what will not be planned again.
void LookAhead::commit(std::size_t boundary, Behind behind) {
  const double s_end = plan_.boundary(boundary);
  std::vector<Phase> phases;
  if (behind == Behind::end) {
    phases.swap(phases_);
  } else {
    split_phases(phases_, s_end, phases);
  }
  rest_.phases.swap(phases_);
  shift(rest_.phases, s_end);
  rest_.keys.clear();
  for (const KeySpan& span : plan_.spans()) {
    if (span.last <= boundary) continue;
    rest_.keys.push_back(
        {.segments = span.last - boundary, .s = plan_.boundary(span.last) - s_end, .v = span.v1});
  }
  STANOK_ASSERT(!phases.empty());
  const double v = phases.back().v_end;
  take(boundary, phases);
  forget(boundary, v);
  improvement_.improve({.segments = planned_.segments,
                        .jerk_parts = planned_.jerk_parts,
                        .follows_others = planned_.phases.front().v > 0.0,
                        .goes_on = behind == Behind::more},
                       planned_.phases);
  commit_chunks(behind == Behind::end ? planned_.segments.size() : count_to_commit(), behind);
}

// Adds the first segments of the window to what is planned.
void LookAhead::take(std::size_t segments, std::vector<Phase>& phases) {
  const auto count = static_cast<std::ptrdiff_t>(segments);
  planned_.segments.insert(planned_.segments.end(), window_.begin(), window_.begin() + count);
  planned_.jerk_parts.insert(planned_.jerk_parts.end(), jerk_parts_.begin(),
                             jerk_parts_.begin() + count);
  planned_.blocks.insert(planned_.blocks.end(), blocks_.begin(), blocks_.begin() + count);
  shift(phases, -planned_.length);
  planned_.phases.insert(planned_.phases.end(), phases.begin(), phases.end());
  for (std::size_t k = 0; k < segments; ++k) planned_.length += window_[k].length;
}

// Without the end of a stretch, which is planned again with what follows.
std::size_t LookAhead::count_to_commit() const {
  const std::vector<Phase>& phases = planned_.phases;
  std::size_t count = planned_.segments.size();
  std::size_t k = phases.size();
  const std::size_t last = phases.size() - std::min(phases.size(), phases_kept_max);
  while (k > last && phases[k - 1].pace.holds()) --k;
  if (k == phases.size()) return count;
  double s = planned_.length;
  while (count > 1 && s > phases[k].s) s -= planned_.segments[--count].length;
  return count;
}

// The segments that came since cannot be joined at the speed of the last cut: the last plan is run
// as it is up to its next key point from which they can be; at the latest that is where it ends, at
// rest.
void LookAhead::run_last_plan_on(Behind behind) {
  STANOK_ASSERT(!rest_.keys.empty());
  std::size_t k = 0;
  for (; k + 1 < rest_.keys.size(); ++k) {
    const auto first = speeds_.begin() + static_cast<std::ptrdiff_t>(rest_.keys[k].segments);
    if (plan_.plan({first, speeds_.end()}, rest_.keys[k].v)) break;
  }
  const RestKey key = rest_.keys[k];
  std::vector<Phase> phases;
  split_phases(rest_.phases, key.s, phases);
  take(key.segments, phases);
  forget(key.segments, key.v);
  commit_chunks(planned_.segments.size(), window_.empty() ? behind : Behind::more);
  shift(rest_.phases, key.s);
  rest_.keys.erase(rest_.keys.begin(), rest_.keys.begin() + static_cast<std::ptrdiff_t>(k + 1));
  for (RestKey& rest : rest_.keys) {
    rest.segments -= key.segments;
    rest.s -= key.s;
  }
}

// Puts the first segments of what is planned and their phases into chunks of the size allowed.
void LookAhead::commit_chunks(std::size_t segments, Behind behind) {
  std::vector<Phase>& phases = planned_.phases;
  const std::uint64_t known = blocks_.empty() ? planned_.blocks.back() : blocks_.back();
  double s_first = 0.0;
  double s_last = 0.0;
  for (std::size_t first = 0; first < segments;) {
    const std::size_t last = end_of_chunk(first, s_first, segments);
    for (std::size_t k = first; k < last; ++k) s_last += planned_.segments[k].length;
    Committed committed;
    const auto begin = planned_.segments.begin();
    committed.segments.assign(begin + static_cast<std::ptrdiff_t>(first),
                              begin + static_cast<std::ptrdiff_t>(last));
    if (last == planned_.segments.size()) {
      committed.phases.swap(phases);
    } else {
      split_phases(phases, s_last, committed.phases);
    }
    shift(committed.phases, s_first);
    double time = 0.0;
    for (const Phase& phase : committed.phases) time += phase.duration;
    committed.chunk = {
        .segments = static_cast<std::uint32_t>(committed.segments.size()),
        .phases = static_cast<std::uint32_t>(committed.phases.size()),
        .last = behind == Behind::end && last == segments,
        .length = s_last - s_first,
        .time_s = time,
        .lookahead_blocks = static_cast<std::uint32_t>(known - planned_.blocks[first])};
    if (committed.chunk.last) {
      committed.overlap = chain_end_.overlap;
      committed.chunk.stand_mm = chain_end_.stand_mm;
    }
    if (!ready_.empty() && ready_.back().overlap) decide_overlap(ready_.back(), committed);
    ready_.push_back(std::move(committed));
    first = last;
    s_first = s_last;
  }
  shift(phases, s_last);
  const auto count = static_cast<std::ptrdiff_t>(segments);
  planned_.segments.erase(planned_.segments.begin(), planned_.segments.begin() + count);
  planned_.jerk_parts.erase(planned_.jerk_parts.begin(), planned_.jerk_parts.begin() + count);
  planned_.blocks.erase(planned_.blocks.begin(), planned_.blocks.begin() + count);
  planned_.length = 0.0;
  for (const Segment& segment : planned_.segments) planned_.length += segment.length;
}

// The segment behind the last one of a chunk that begins with `first`, at `s_first` along the
// phases.
std::size_t LookAhead::end_of_chunk(std::size_t first, double s_first, std::size_t segments) const {
  const std::size_t last = std::min(segments, first + chunk_segments_max);
  if (planned_.phases.size() <= chunk_phases_max) return last;
  const double s_max = planned_.phases[chunk_phases_max].s;
  std::size_t k = first;
  for (double s = s_first; k < last && (k == first || s + planned_.segments[k].length <= s_max);
       ++k) {
    s += planned_.segments[k].length;
  }
  return k;
}

// How long the next chain, which begins with `start`, may overlap the one that ends with `end`.
void LookAhead::decide_overlap(Committed& end, const Committed& start) const {
  const Segment& last = end.segments.back();
  const Segment& first = start.segments.front();
  // Paths that are nothing beside the length of their block give way to blends: no overlap.
  const auto is_of_block = [](const Segment& segment) {
    return segment.geometry.kind == SegmentKind::line || segment.geometry.kind == SegmentKind::arc;
  };
  if (is_of_block(last) && is_of_block(first)) {
    end.chunk.overlap_s =
        overlap_duration(*end.overlap, last_ramp(end.phases), first_ramp(start.phases),
                         {.incoming = last.length, .outgoing = first.length}, config_);
  }
  end.overlap.reset();
}

// Takes committed segments out of the window; what remains starts at speed `v`.
void LookAhead::forget(std::size_t segments, double v) {
  const auto count = static_cast<std::ptrdiff_t>(segments);
  window_.erase(window_.begin(), window_.begin() + count);
  speeds_.erase(speeds_.begin(), speeds_.begin() + count);
  jerk_parts_.erase(jerk_parts_.begin(), jerk_parts_.begin() + count);
  blocks_.erase(blocks_.begin(), blocks_.begin() + count);
  v_start_ = v;
}

std::size_t LookAhead::last_boundary_to_commit() const {
  if (blocks_.back() - blocks_.front() < blocks_beyond) return 0;
  const auto beyond =
      std::upper_bound(blocks_.begin(), blocks_.end(), blocks_.back() - blocks_beyond);
  return checked_size(beyond - blocks_.begin());
}

// The last boundary at or before the one given where a span holds its highest speed; nothing: there
// is none behind its start.
std::optional<std::size_t> LookAhead::last_held(const KeySpan& span, std::size_t boundary) const {
  const double held_from = plan_.boundary(span.first) + span.wait_first + span.up_distance();
  const double held_to = plan_.boundary(span.last) - span.wait_last - span.down_distance();
  std::size_t b = std::min(boundary, span.last);
  for (; b > span.first && plan_.boundary(b) > held_from; --b) {
    if (plan_.boundary(b) < held_to) return b;
  }
  return std::nullopt;
}

// The last boundary with a = 0, at or before the one given: where the plan holds the feed, so that
// nothing is lost when what follows is planned apart, else anywhere.
std::size_t LookAhead::cut_at_or_before(std::size_t boundary) const {
  const auto& spans = plan_.spans();
  if (boundary == 0 || spans.empty()) return 0;
  const auto after =
      std::upper_bound(spans.begin(), spans.end(), boundary,
                       [](std::size_t place, const KeySpan& span) { return place < span.first; });
  for (auto span = std::make_reverse_iterator(after); span != spans.rend(); ++span) {
    const std::optional<std::size_t> held = last_held(*span, boundary);
    if (held && is_feed(span->top, *held)) return *held;
  }
  const KeySpan& span = *(after - 1);
  if (span.last <= boundary) return span.last;
  return last_held(span, boundary).value_or(span.first);
}

// Whether a speed is the feed on both sides of a boundary.
bool LookAhead::is_feed(double v, std::size_t boundary) const {
  constexpr double rounding = 1e-9;
  const double feed = std::max(window_[boundary - 1].feed_per_s, window_[boundary].feed_per_s);
  return v >= feed * (1.0 - rounding);
}

// Whether the speed at the start of a span of the plan is as high as it can be, whatever comes
// later: it was committed, or a segment beside it allows no more.
bool LookAhead::begins_at_limit(const KeySpan& span) const {
  constexpr double rounding = 1e-9;
  if (span.first == 0) return true;
  const double limit = std::min(speeds_[span.first - 1].v, speeds_[span.first].v);
  return span.v0 >= limit * (1.0 - rounding);
}

// The boundary behind which the plan only slows down for the end of what is known.
std::size_t LookAhead::start_of_last_descent() const {
  const auto& spans = plan_.spans();
  const auto only_slows = [](const KeySpan& span) {
    return span.top <= span.v0 && span.v1 < span.v0;
  };
  if (spans.empty()) return 0;
  std::size_t k = spans.size() - 1;
  while (k > 0 && only_slows(spans[k]) && !begins_at_limit(spans[k])) --k;
  const KeySpan& span = spans[k];
  const double descent = plan_.boundary(span.last) - span.wait_last - span.down_distance();
  std::size_t boundary = span.last;
  while (boundary > span.first && plan_.boundary(boundary) > descent) --boundary;
  return boundary;
}

}  // namespace stanok::motion
