// DrySink: what a dry run keeps of the results of a PathFeed: records of commands, the warning of
// feeds that the axes limit, estimates of feed laws. Path and items are not executed.
//
// Thread: that of the dry run, which owns it. Invariant: every command is recorded once, but for
// motion that cannot be made a block.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "channels/preparation/path_feed.h"
#include "motion/feed_laws/law_estimate.h"

namespace stanok::jobs {

// One record after block preparation; `block` only for motion. Both are valid during the call.
using RecordSink =
    std::function<void(const lang::Command& command, const motion::PathBlock* block)>;

// A block under a feed law, and what is to be expected of it.
struct LawBlock {
  Place place;
  motion::LawKind kind = motion::LawKind::none;
  motion::LawUnits units;
  double path_mm = 0.0;
  motion::LawEstimate estimate;
  bool time_is_least = false;  // the spindle follows the diameter: planned for its highest speed
};

class DrySink final : public channels::FeedSink {
 public:
  // All arguments outlive the sink.
  DrySink(const motion::MotionConfig& motion, const channels::PathFeed& feed)
      : motion_(motion), feed_(feed) {}

  // What follows belongs to `program` and is followed to `depth`; `record` holds until the next
  // call.
  void begin(std::shared_ptr<const lang::Program> program, channels::FeedDepth depth,
             const RecordSink& record);

  [[nodiscard]] channels::FeedDepth depth() const override { return depth_; }
  void begin_command(const lang::Command& command) override;
  void take_motion(const lang::Command& command,
                   std::span<const motion::PathBlock> blocks) override;
  void take_segment(const motion::PathBuilder::Built& built) override;

  // The warning of feeds above what the axes allow, once a program.
  [[nodiscard]] const std::optional<Diagnostic>& feed_warning() const { return feed_warning_; }
  // In their order; of a run to the depth `path`.
  [[nodiscard]] std::vector<LawBlock> take_laws() { return std::move(laws_); }

 private:
  [[nodiscard]] motion::Point as_programmed(const lang::Move& move,
                                            const motion::PathBlock& block) const;
  void estimate_law(const motion::PathBlock& block);

  const motion::MotionConfig& motion_;
  const channels::PathFeed& feed_;
  std::shared_ptr<const lang::Program> program_;
  channels::FeedDepth depth_ = channels::FeedDepth::positions;
  RecordSink record_;
  std::optional<Diagnostic> feed_warning_;
  double speed_before_ = 0.0;  // of the spindle where the command begins; rev/min
  std::vector<LawBlock> laws_;
};

}  // namespace stanok::jobs
