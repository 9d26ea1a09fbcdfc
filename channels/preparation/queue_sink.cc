#include "channels/preparation/queue_sink.h"

#include <utility>
#include <variant>

#include "channels/preparation/feed_limit.h"
#include "channels/preparation/program_requests.h"

namespace stanok::channels {

QueueSink::QueueSink(const motion::MotionConfig& motion, ChannelLink& link, SharedVariables& shared,
                     SituationBook& blocks)
    : motion_(motion), link_(link), shared_(shared), situations_(blocks), look_ahead_(motion) {}

void QueueSink::take_motion(const lang::Command& /*command*/,
                            std::span<const motion::PathBlock> blocks) {
  for (const motion::PathBlock& block : blocks) situations_.tell_end(block.tag, block.end);
}

// Segments without a law pass as long as none with a law waits before them.
void QueueSink::take_segment(const motion::PathBuilder::Built& built) {
  warn_of_feed(built.segment);
  const bool may_pass = laws_.is_empty() && built.segment.process.law == nullptr;
  may_pass ? look_ahead_.add(built) : laws_.add(built);
}

void QueueSink::warn_of_feed(const motion::Segment& segment) {
  if (feed_is_warned_of_) return;
  const auto warning = feed_above_limit(segment, motion_);
  if (!warning) return;
  feed_is_warned_of_ = true;
  take_remark({segment.tag, SpokenText{FixedText<8>(warning->code), ShortText(warning->message)}});
}

void QueueSink::take_thread(motion::ThreadChain&& chain) {
  while (!laws_.is_empty()) look_ahead_.add(laws_.next());
  look_ahead_.add(std::move(chain));
}

void QueueSink::take_item(const Item& item) {
  pending_items_.push_back(item);
  pending_items_.back().after_rider = link_.riders.pushed() + pending_riders_.size();
}

void QueueSink::take_request(const motion::BlockTag& tag, const lang::ProgramRequest& request) {
  take_item({.tag = tag, .content = request_of(request, shared_)});
}

bool QueueSink::flush() {
  while (!pending_remarks_.empty() && link_.remarks.push(pending_remarks_.front()))
    pending_remarks_.pop_front();
  while (!pending_riders_.empty() && link_.riders.push(pending_riders_.front()))
    pending_riders_.pop_front();
  if (!pending_riders_.empty()) return false;
  if (!look_ahead_.deliver(link_.path)) return false;
  while (!laws_.is_empty()) {
    look_ahead_.add(laws_.next());
    if (!look_ahead_.deliver(link_.path)) return false;
  }
  while (!pending_items_.empty()) {
    Item& item = pending_items_.front();
    item.after_chunk = link_.path.chunks.pushed();
    if (!link_.items.push(item)) return false;
    pending_items_.pop_front();
  }
  return pending_remarks_.empty();
}

void QueueSink::forget() {
  look_ahead_.clear();
  laws_.clear();
  pending_items_.clear();
  pending_remarks_.clear();
  pending_riders_.clear();
}

}  // namespace stanok::channels
