// ScopeFeed: brings outputs, events and times of all cycles to the scope; the publisher's thread.
#pragma once

#include "daemon/publish/publisher_thread.h"
#include "daemon/scope/scope.h"

namespace stanok::daemon {

class ScopeFeed final : public CycleListener {
 public:
  // Both outlive the feed.
  ScopeFeed(Scope& scope, RealTimeLoop& loop) : scope_(scope), times_(loop.times()) {}

  void on_event(const channels::Event& event) override { scope_.take(event); }

  // The times of a cycle come a moment later than its output: they are those of the cycle before.
  // Where outputs were lost, the times of theirs are left out, too.
  void on_output(const channels::CycleOutput& output) override {
    CycleTimes times;
    constexpr std::size_t behind_max = 2;
    do {
      if (times_.pop(times)) last_ = times;
    } while (times_.size() > behind_max);
    scope_.take({output, last_});
  }

 private:
  Scope& scope_;
  Ring<CycleTimes>& times_;
  CycleTimes last_;
};

}  // namespace stanok::daemon
