// WaitDesk: waits between channels: for the end of a program, at marks; deadlocks.
//
// Thread: the real-time cycle. Owner: the coordinator, whose first errands are those of the
// channels.
#pragma once

#include <optional>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/errand.h"
#include "channels/coordinator/rendezvous.h"
#include "channels/coordinator/verdict.h"

namespace stanok::channels {

class WaitDesk {
 public:
  // Both outlive the desk. `errands`: the requests of each channel, by index.
  WaitDesk(const ChannelTable& channels, NumberedSpan<Errand> errands, double cycle_s)
      : channels_(channels), errands_(errands), cycle_s_(cycle_s) {}

  // For the end of the run that goes on there; `seconds` < 0: for ever.
  [[nodiscard]] Verdict wait_for_end(Errand& errand, double seconds, const Channel& target) const
      RT_SAFE;
  // Until all partners are at the mark.
  [[nodiscard]] Verdict wait_at_mark(const Errand& errand) const RT_SAFE;

  // Once a cycle, in the order of channels: who came to a mark, who is missed for ever, who may go
  // on. `conclude`: ends a request that cannot be met.
  template <class Conclude>
  void advance(Conclude&& conclude) RT_SAFE {
    for (int k = 0; k < channels_.count(); ++k) {
      if (comes_to_mark(k)) {
        if (const auto fault = arrive_at_mark(k)) conclude(errand_of(k), *fault);
      }
      arrive_at_soft_mark(k);
    }
    meet();
  }

  // Whether channel `index` waits, without a time-out, for other channels.
  [[nodiscard]] bool is_waiting_for_channels(int index) const RT_SAFE;

 private:
  [[nodiscard]] Errand& errand_of(int index) const RT_SAFE { return errands_[index]; }
  // In the cycle in which its request begins to wait there. Who waits no more has left its mark.
  [[nodiscard]] bool comes_to_mark(int index) RT_SAFE;
  [[nodiscard]] std::optional<Verdict> arrive_at_mark(int index) RT_SAFE;
  void arrive_at_soft_mark(int index) RT_SAFE;
  void meet() RT_SAFE;
  void work_soft_mark(int index) RT_SAFE;
  [[nodiscard]] std::optional<Verdict> fault_of_arrival(int index) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> lost_partner(int index) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> deadlock(int index) const RT_SAFE;
  [[nodiscard]] ChannelSet awaited_by(int index) const RT_SAFE;
  void describe_wait(int index, int awaited, ReasonText& text) const RT_SAFE;

  const ChannelTable& channels_;
  NumberedSpan<Errand> errands_;
  double cycle_s_;
  Rendezvous rendezvous_;
  ChannelSet released_ = 0;  // stood at a soft mark that is met now, and have not yet left it
};

}  // namespace stanok::channels
