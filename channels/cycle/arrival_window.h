// ArrivalWindow: what a channel's cycle sees of the rings that its preparation fills.
//
// In a recorded run that is as much as that run saw in the same cycle, so that its outcome does not
// depend on how far ahead the preparation is. Counts begin anew with every reset. Thread: the
// real-time cycle, has_prepared() beside it. Owner: the channel.
#pragma once

#include "base/rt_safe.h"
#include "channels/contract/output.h"
#include "channels/messages/channel_link.h"

namespace stanok::channels {

class ArrivalWindow {
 public:
  static constexpr Arrivals all{.resets = 0,
                                .chunks = Arrivals::everything,
                                .items = Arrivals::everything,
                                .riders = Arrivals::everything,
                                .remarks = Arrivals::everything};

  // `link` outlives the window.
  explicit ArrivalWindow(ChannelLink& link) : link_(link) {}

  // Whether the preparation has made what a recorded cycle saw of it. Not of the cycle.
  [[nodiscard]] bool has_prepared(const Arrivals& recorded) const;
  // Whether it may make more, where the recorded run is known up to `known`: what influenced the
  // preparation before it made that is known, too. Not of the cycle.
  [[nodiscard]] bool may_prepare(const Arrivals& known) const {
    return known.resets > arrivals_.resets || !has_prepared(known);
  }
  // At the begin of a cycle.
  void open(const Arrivals& recorded) RT_SAFE;
  // Behind the item that says that a reset is over, the preparation has made nothing but items; all
  // else that it made is of before. First shows it, to be dropped; then counts anew.
  void show_rest() RT_SAFE;
  void begin_anew(std::uint64_t items) RT_SAFE;

  [[nodiscard]] const Arrivals& arrivals() const RT_SAFE { return arrivals_; }

 private:
  ChannelLink& link_;
  Arrivals arrivals_;   // seen in this cycle
  Arrivals forgotten_;  // with the latest reset, counted since construction
};

}  // namespace stanok::channels
