// SearchSink: of a program that a block search passes over only the state of the machine counts;
// positions are followed, nothing becomes a path or an item.
//
// Thread: that of its PathFeed. Owner: the search. Invariant: the collector has seen each command
// that the feed has begun, in program order.
#pragma once

#include "channels/preparation/feed_sink.h"
#include "lang/run/block_search.h"

namespace stanok::channels {

class SearchSink final : public FeedSink {
 public:
  // The collector outlives the sink.
  explicit SearchSink(lang::SearchCollector& collector) : collector_(collector) {}

  [[nodiscard]] FeedDepth depth() const override { return FeedDepth::positions; }
  void begin_command(const lang::Command& command) override { collector_.take(command); }

 private:
  lang::SearchCollector& collector_;
};

}  // namespace stanok::channels
