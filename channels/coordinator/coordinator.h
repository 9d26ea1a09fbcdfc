// Coordinator: what channels and operators ask of channels, decided inside the cycle, in channel
// order.
//
// It takes in wishes as errands, steps each once a cycle until it is done, one after the other
// where they would meet, and answers. The work is that of its desks. Decisions depend on the cycle
// only, never on thread timing (docs/developer/architecture.md#time-and-determinism). Thread: the
// real-time cycle. Owner: the machine. Invariant: errand k is the request of channel k, those
// behind are the operators'.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>

#include "channels/contract/command_rules.h"
#include "channels/contract/operator_event.h"
#include "channels/coordinator/axis_ownership.h"
#include "channels/coordinator/channel_errands.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/control_desk.h"
#include "channels/coordinator/errand.h"
#include "channels/coordinator/machine_stores.h"
#include "channels/coordinator/operator_desk.h"
#include "channels/coordinator/request_gate.h"
#include "channels/coordinator/value_desk.h"
#include "channels/coordinator/verdict.h"
#include "channels/coordinator/wait_desk.h"

namespace stanok::channels {

// Where replies go: those to stops have a ring, and a consumer, of their own.
struct ReplyRings {
  Ring<OperatorReply>& usual;
  Ring<OperatorReply>& stops;
  std::atomic<std::uint64_t>& lost;  // that found no room
};

struct CoordinatorTimes {
  double cycle_s = 0.001;
  double request_age_max_s = 0.5;
};

class Coordinator {
 public:
  // All outlive the coordinator.
  Coordinator(std::span<Channel* const> channels, const OwnerFailures& on_owner_failure,
              CoordinatorTimes times, ReplyRings replies, const MachineStores& stores);
  Coordinator(const Coordinator&) = delete;
  Coordinator& operator=(const Coordinator&) = delete;

  // False, and its asker has been told: what the command was meant for is no more.
  [[nodiscard]] bool admits(const OperatorEvent& event, std::int64_t cycle) RT_SAFE;
  void note_gap(std::int64_t cycle, std::int64_t periods) RT_SAFE {
    gate_.note_gap(cycle, periods);
  }
  void take(const OperatorEvent& event) RT_SAFE;
  // After all channels have done their cycle.
  void step() RT_SAFE;

  // Before the first cycle: the axes of the schemes that are active now belong to their channels.
  void settle_owners() { ownership_ = AxisOwnership(channels_.all()); }

  // Outputs of axes that several channels have are those of the channel that moves them.
  void show_owners(CycleOutput& output) const RT_SAFE { ownership_.show_owners(output); }

  [[nodiscard]] bool is_quiet() const RT_SAFE;
  // Whether channel `index` waits, without a time-out, for other channels.
  [[nodiscard]] bool is_waiting_for_channels(int index) const RT_SAFE {
    return waits_.is_waiting_for_channels(index);
  }

 private:
  // Takes a step of an errand: one overload for each kind of request.
  struct Step;
  static constexpr std::size_t operator_errands = 16;

  [[nodiscard]] std::optional<Verdict> refusal_by_rule(OperatorAction action,
                                                       const Channel* named) const RT_SAFE;
  void begin_errand(const OperatorEvent& event, int target) RT_SAFE;
  void adopt_request(int index) RT_SAFE;
  [[nodiscard]] bool is_its_turn(const Errand& errand) const RT_SAFE;
  [[nodiscard]] bool is_asker_held(const Errand& errand) const RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand) RT_SAFE;
  void conclude(Errand& errand, const Verdict& verdict) RT_SAFE;
  void reply(std::uint64_t id, const Verdict& verdict) RT_SAFE;

  ChannelTable channels_;
  AxisOwnership ownership_;
  ReplyRings replies_;
  NumberedArray<Errand, channels_max + operator_errands> errands_{};
  std::uint64_t errands_taken_ = 0;
  RequestGate gate_;
  ControlDesk control_;
  OperatorDesk operators_;
  ValueDesk values_;
  WaitDesk waits_;
  ChannelErrands channel_errands_;
};

}  // namespace stanok::channels
