#include "jobs/dry_run/dry_sink.h"

#include <string>
#include <utility>

#include "channels/preparation/feed_limit.h"

namespace stanok::jobs {

void DrySink::begin(std::shared_ptr<const lang::Program> program, channels::FeedDepth depth,
                    const RecordSink& record) {
  program_ = std::move(program);
  depth_ = depth;
  record_ = record;
}

// Motion is recorded with its block. A law may leave another speed behind.
void DrySink::begin_command(const lang::Command& command) {
  speed_before_ = feed_.blocks().steady_speed();
  if (lang::move_of(command.payload) == nullptr) record_(command, nullptr);
}

// The stretches of a curve are one block of the program, under one law.
void DrySink::take_motion(const lang::Command& command, std::span<const motion::PathBlock> blocks) {
  motion::PathBlock whole = blocks.back();
  motion::BlockProcess& process = whole.process;
  process.path_length += process.path_start - blocks.front().process.path_start;
  process.path_start = blocks.front().process.path_start;
  whole.end = as_programmed(*lang::move_of(command.payload), whole);
  record_(command, &whole);
  if (depth_ == channels::FeedDepth::path) estimate_law(whole);
}

// The end of a block with its words to the last bit: on a cylinder the path has lengths for
// degrees.
motion::Point DrySink::as_programmed(const lang::Move& move, const motion::PathBlock& block) const {
  motion::Point end = feed_.blocks().programmed(block.end);
  for (std::size_t k = 0; k < end.size() && !move.machine_coordinates; ++k) {
    if ((move.words >> k & 1U) != 0) end[k] = move.end[k];
  }
  return end;
}

void DrySink::estimate_law(const motion::PathBlock& block) {
  const motion::BlockProcess& process = block.process;
  if (process.law == nullptr) return;
  const double planned = process.rev_per_min;
  const motion::LawPart part{
      .from_mm = process.path_start,
      .to_mm = process.path_start + process.path_length,
      .feed_per_s = block.feed_per_s,
      .rev_per_min = planned > 0.0 ? planned : speed_before_,
  };
  const auto estimate = motion::estimate(*process.law, part);
  if (!estimate) return;
  const motion::LawUnits& units = process.law->units();
  const bool follows_diameter = speed_before_ <= 0.0 || units.speed == motion::LawSpeed::m_per_min;
  LawBlock found{.place = {},
                 .kind = process.law->kind(),
                 .units = units,
                 .path_mm = process.path_length,
                 .estimate = *estimate,
                 .time_is_least = planned > 0.0 && follows_diameter};
  found.place.file = std::string(lang::file_name(*program_, block.tag.file));
  found.place.line = static_cast<int>(block.tag.line);
  laws_.push_back(std::move(found));
}

void DrySink::take_segment(const motion::PathBuilder::Built& built) {
  if (feed_warning_) return;
  feed_warning_ = channels::feed_above_limit(built.segment, motion_);
  if (feed_warning_)
    lang::put_at_block(*program_, {built.segment.tag.file, built.segment.tag.line}, *feed_warning_);
}

}  // namespace stanok::jobs
