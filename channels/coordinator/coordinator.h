// Coordinator: what channels and operators ask of channels, decided inside the cycle, in channel
// order.
//
// An errand is one such wish on its way: a request of a program (channel_run, channel_wait,
// #kinematics, ...) or an operator's event. It is stepped once a cycle until it is done. Decisions
// depend on the cycle only, never on thread timing
// (docs/developer/architecture.md#time-and-determinism).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "channels/contract/command_rules.h"
#include "channels/contract/operator_event.h"
#include "channels/coordinator/axis_ownership.h"
#include "channels/coordinator/rendezvous.h"
#include "channels/cycle/channel.h"
#include "channels/stores/live_tables.h"
#include "channels/stores/shared_variables.h"

namespace stanok::channels {

// What belongs to the machine and not to one channel; owned by it.
struct MachineStores {
  SharedVariables* shared = nullptr;
  LiveTables* tables = nullptr;
  const Signals* inputs = nullptr;
};

// Where replies go: those to stops have a ring, and a consumer, of their own.
struct ReplyRings {
  Ring<OperatorReply>& usual;
  Ring<OperatorReply>& stops;
};

class Coordinator {
 public:
  Coordinator(std::span<Channel* const> channels,
              const std::array<OwnerFailure, channels_max>& on_owner_failure, double cycle_s,
              ReplyRings replies, MachineStores stores);

  void take(const OperatorEvent& event) RT_SAFE;
  // After all channels have done their cycle.
  void step() RT_SAFE;

  // Before the first cycle: the axes of the schemes that are active now belong to their channels.
  void settle_owners();

  // Outputs of axes that several channels have are those of the channel that moves them.
  void show_owners(CycleOutput& output) const RT_SAFE { ownership_.show_owners(output); }

  [[nodiscard]] bool is_quiet() const RT_SAFE;
  // Whether channel `index` waits, without a timeout, for other channels.
  [[nodiscard]] bool is_waiting_for_channels(int index) const RT_SAFE;

 private:
  static constexpr int operator_asker = -1;
  static constexpr std::size_t operator_errands = 16;

  struct Errand {
    bool active = false;
    std::uint64_t order = 0;       // in which errands came
    std::uint32_t generation = 0;  // of the target, when it was asked
    std::int32_t controller = 0;   // of the target, when it was asked
    int asker = operator_asker;    // index of the channel that asks
    std::uint64_t reply_id = 0;
    Job job = Job::program;
    lang::RequestKind kind = lang::RequestKind::sync;
    int target = -1;  // index of the channel concerned
    int number = 0;
    double value = 0.0;
    ChannelSet members = 0;  // mark_wait
    RequestData request;     // of a program
    double seconds = -1.0;
    int stage = 0;
    std::int64_t cycles = 0;  // since the errand began
    std::uint32_t awaited_run = 0;
    bool homes = false;         // of an operator: looks for the marks of axes
    bool input_before = false;  // input_wait: the input in the cycle before
    motion::BlockTag tag;
    ShortText text;
  };

  // How an errand stands after a step.
  struct Verdict {
    bool done = true;
    bool ok = true;
    bool raises = false;  // lang::Answer
    double number = 0.0;
    FixedText<8> code;
    ReasonText text;
  };
  static Verdict pending() RT_SAFE;
  static Verdict success(double number = 0.0) RT_SAFE;
  static Verdict refusal(std::string_view code, std::string_view text) RT_SAFE;
  // "channel 2 <claim>"
  static Verdict refusal(std::string_view code, const Channel& channel, std::string_view claim)
      RT_SAFE;
  [[nodiscard]] static bool is_busy(const Channel& channel) RT_SAFE;

  [[nodiscard]] std::optional<Verdict> refusal_by_rule(OperatorAction action,
                                                       const Channel* named) const RT_SAFE;
  static void begin_stop(OperatorAction action, Channel& channel) RT_SAFE;
  [[nodiscard]] static bool begins_something(const Errand& errand) RT_SAFE;
  [[nodiscard]] bool is_its_turn(const Errand& errand) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> obstacle(const Errand& errand, OperatorAction action,
                                                const Channel& target) const RT_SAFE;
  // Control of channels by one session (coordinator_control.cc)
  [[nodiscard]] Verdict set_controller(const OperatorEvent& event) RT_SAFE;
  [[nodiscard]] bool is_under_control_of_others(const Errand& errand) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> foreign_axis(int index, lang::AxisSet axes) const RT_SAFE;
  void adopt_requests() RT_SAFE;
  void conclude(Errand& errand, const Verdict& verdict) RT_SAFE;
  void follow_owners() RT_SAFE;
  [[nodiscard]] Verdict step(Errand& errand) RT_SAFE;
  [[nodiscard]] Verdict step_load(Errand& errand, Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_start(Errand& errand, Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_run(Errand& errand, Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_stop(Errand& errand, Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_reset(Errand& errand, Channel& target) RT_SAFE;
  // Axes moved by hand (coordinator_manual.cc)
  [[nodiscard]] Verdict jog(const OperatorEvent& event, Channel* channel) RT_SAFE;
  [[nodiscard]] Verdict step_home(Errand& errand, Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_restart(Channel& asker) RT_SAFE;
  [[nodiscard]] Verdict step_kinematics(Errand& errand, Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_spindle_to_axis(Errand& errand, Channel& asker) RT_SAFE;
  [[nodiscard]] static std::optional<Verdict> unreferenced(const Channel& target,
                                                           lang::AxisSet axes) RT_SAFE;
  // Nothing: all these axes of channel `index` are its own now.
  [[nodiscard]] std::optional<Verdict> claim(int index, lang::AxisSet axes) RT_SAFE;
  // Values (coordinator_values.cc)
  [[nodiscard]] Verdict step_shared(const Errand& errand) RT_SAFE;
  [[nodiscard]] Verdict combine_shared(const Errand& errand) RT_SAFE;
  [[nodiscard]] Verdict step_table(const Errand& errand) RT_SAFE;
  [[nodiscard]] Verdict step_input_wait(Errand& errand) RT_SAFE;
  [[nodiscard]] Verdict step_value(const Errand& errand) RT_SAFE;
  [[nodiscard]] Verdict input_value(bool analog, int index) const RT_SAFE;
  [[nodiscard]] std::optional<double> axis_value(std::string_view name, const Channel& asker,
                                                 int axis) const RT_SAFE;

  // Waits and marks (coordinator_waits.cc)
  [[nodiscard]] Verdict step_wait(Errand& errand, const Channel& target) RT_SAFE;
  [[nodiscard]] Verdict step_mark_wait(const Errand& errand) RT_SAFE;
  void work_marks() RT_SAFE;
  void arrive_at_mark(int index) RT_SAFE;
  void arrive_at_soft_mark(int index) RT_SAFE;
  void work_soft_mark(int index) RT_SAFE;
  [[nodiscard]] std::optional<Verdict> fault_of_arrival(int index) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> lost_partner(int index) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> deadlock(int index) const RT_SAFE;
  [[nodiscard]] ChannelSet awaited_by(int index) const RT_SAFE;
  void describe_wait(int index, int awaited, ReasonText& text) const RT_SAFE;

  [[nodiscard]] bool is_asker_held(const Errand& errand) const RT_SAFE;
  [[nodiscard]] ChannelSet channels_with_ids(std::uint32_t ids) const RT_SAFE;
  [[nodiscard]] Channel& channel(int index) const RT_SAFE {
    return *channels_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] Channel* channel_with_id(int id, int& index) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> apply_at_once(const OperatorEvent& event, Channel* channel)
      RT_SAFE;
  [[nodiscard]] Verdict switch_on(const Channel* named) RT_SAFE;
  // Tables (coordinator_tables.cc)
  [[nodiscard]] Verdict set_tool(const OperatorEvent& event) RT_SAFE;
  [[nodiscard]] Verdict set_offset(const OperatorEvent& event) RT_SAFE;
  // The cutting process (coordinator_process.cc)
  Verdict interrupt_feed(const OperatorEvent& event, Channel* channel) RT_SAFE;
  Verdict switch_automatic_feed(const OperatorEvent& event, Channel* channel) RT_SAFE;
  Verdict control_force(const OperatorEvent& event, Channel* channel) RT_SAFE;
  void set_overrides(const OperatorEvent& event, Channel& channel) RT_SAFE;
  void reply(std::uint64_t id, const Verdict& verdict) RT_SAFE;

  std::array<Channel*, channels_max> channels_{};
  int channel_count_ = 0;
  AxisOwnership ownership_;
  std::array<OwnerFailure, channels_max> on_owner_failure_{};
  double cycle_s_;
  ReplyRings replies_;
  MachineStores stores_;
  std::array<Errand, channels_max + operator_errands>
      errands_{};  // first one per channel, then the operators'
  std::array<int, channels_max>
      owner_{};  // who started the run of a channel; operator_asker: an operator
  std::array<std::uint32_t, channels_max> owner_run_{};  // in which run of the owner
  std::array<std::int32_t, channels_max>
      controller_{};  // session that has the channel to itself; 0: nobody
  std::uint64_t errands_taken_ = 0;
  Rendezvous rendezvous_;
  ChannelSet released_ = 0;  // stood at a soft mark that is met now, and have not yet left it
};

}  // namespace stanok::channels
