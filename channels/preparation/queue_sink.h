// QueueSink: the results of a PathFeed on their way to the cycle: path through laws and look-ahead,
// items, riders and remarks, into the rings of the channel.
//
// Thread: that of the preparation. Owner: the channel's preparation. Invariant: an item enters its
// ring after all path and riders that come before it in the program.
#pragma once

#include <deque>

#include "channels/messages/channel_link.h"
#include "channels/preparation/feed_sink.h"
#include "channels/stores/shared_variables.h"
#include "channels/stores/situation_book.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/segments/feed_law_stage.h"

namespace stanok::channels {

class QueueSink final : public FeedSink {
 public:
  // All arguments outlive the sink.
  QueueSink(const motion::MotionConfig& motion, ChannelLink& link, SharedVariables& shared,
            SituationBook& blocks);

  // A warning that is given once a run is due again.
  void begin_run() { feed_is_warned_of_ = false; }

  [[nodiscard]] FeedDepth depth() const override { return FeedDepth::path; }
  void take_motion(const lang::Command& command,
                   std::span<const motion::PathBlock> blocks) override;
  void take_segment(const motion::PathBuilder::Built& built) override;
  void take_thread(motion::ThreadChain&& chain) override;
  void take_item(const Item& item) override;
  void take_request(const motion::BlockTag& tag, const lang::ProgramRequest& request) override;
  void take_rider(const Rider& rider) override { pending_riders_.push_back(rider); }
  void take_remark(const Remark& remark) override { pending_remarks_.push_back(remark); }

  // Delivers what the rings have room for; true when nothing is left that waits for room.
  [[nodiscard]] bool flush();
  // How long the motion takes that the cycle has before it.
  [[nodiscard]] double seconds_ahead() { return look_ahead_.seconds_in(link_.path); }
  // Less the last chunk, which the cycle does not enter before the next one is there.
  [[nodiscard]] double seconds_free() { return look_ahead_.seconds_free_in(link_.path); }
  // Items wait for room, and with them all that comes behind.
  [[nodiscard]] bool holds_items() const { return !pending_items_.empty(); }
  // What was not delivered is dropped.
  void forget();

 private:
  void warn_of_feed(const motion::Segment& segment);

  const motion::MotionConfig& motion_;
  ChannelLink& link_;
  SharedVariables& shared_;
  SituationBook& situations_;
  motion::FeedLawStage laws_;
  motion::LookAhead look_ahead_;
  bool feed_is_warned_of_ = false;  // once a run
  std::deque<Item> pending_items_;
  std::deque<Remark> pending_remarks_;
  std::deque<Rider> pending_riders_;
};

}  // namespace stanok::channels
