// RequestGate: which requests of operators still mean what their askers saw.
//
// What begins motion is refused when it is too old, for its asker may have gone meanwhile: its age
// counts from the newest cycle that was seen. And a jog under a lease belongs to the session that
// began it until it ends; its renewals have no age, since they begin nothing. What is refused here
// is no input of the cycle. Thread: the real-time cycle. Owner: the coordinator.
#pragma once

#include <cstdint>
#include <optional>

#include "base/rt_safe.h"
#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"
#include "channels/coordinator/verdict.h"

namespace stanok::channels {

class Channel;

class RequestGate {
 public:
  RequestGate(double cycle_s, double age_max_s);

  // Behind so many periods without a cycle, which count as much as cycles.
  void note_gap(std::int64_t cycle, std::int64_t periods) RT_SAFE;
  // Why an event is not taken in this cycle; nothing: it is. `named`: channel `index`, or nullptr.
  [[nodiscard]] std::optional<Verdict> refusal_of(const OperatorEvent& event, std::int64_t cycle,
                                                  const Channel* named, int index) const RT_SAFE;
  // The event has been taken.
  void note(const OperatorEvent& event, int index) RT_SAFE;

 private:
  [[nodiscard]] std::int64_t age_of(const OperatorEvent& event, std::int64_t cycle) const RT_SAFE;

  double cycle_s_;
  std::int64_t cycles_max_;
  // The latest gaps: before which cycle, and all periods lost by then.
  struct Loss {
    std::int64_t cycle = 0;
    std::int64_t lost = 0;
  };
  static constexpr int losses_kept = 64;
  NumberedArray<Loss, losses_kept> losses_{};
  int newest_ = 0;
  NumberedArray<std::int32_t, channels_max> jogger_{};  // the session, of each channel
};

}  // namespace stanok::channels
