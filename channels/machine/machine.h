// Machine: all channels, their coordinator and the tables, and one cycle over all of them; free of
// threads and clocks.
//
// Two functions carry the machine: `prepare(channel)` does bounded work ahead of motion and says
// whether it is blocked; `cycle(inputs, output)` is one real-time cycle, plain data in and out. The
// daemon calls prepare from channel threads and cycle from the real-time thread; `simulate` calls
// cycle only when every preparation is blocked, which makes runs repeatable to the bit.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/ring.h"
#include "channels/contract/clock_gap.h"
#include "channels/contract/input_change.h"
#include "channels/contract/input_record.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"
#include "channels/contract/progress.h"
#include "channels/contract/reports.h"
#include "channels/messages/recorded_work.h"
#include "lang/contract/environment.h"

namespace stanok::channels {

struct CycleInputs {
  std::span<const OperatorEvent> events;
  std::span<const AxisFeedback> feedback;     // machine axis order; empty: ideal drives
  const Signals* signals = nullptr;           // nullptr: there are none
  std::span<const SpindleSensors> sensors{};  // machine spindle order; empty: there are none
  // In the order of the channels, of a run that is repeated; empty: what the preparations have
  // made.
  std::span<const Arrivals> arrivals{};
  ClockGap gap{};  // before this cycle
};

struct MachineOptions {
  bool on_at_start = false;  // drives enabled from the first cycle (simulate)
  // M0 and M60 continue at once with a message, M99 in the main program ends it (simulate).
  bool stops_go_on = false;
  bool outputs_to_inputs = false;  // where the inputs hold none
  // Force control of each channel, in their order; nullptr, or shorter: none. They outlive the
  // machine.
  std::vector<motion::FeedModifier*> feed_modifiers{};
  // For how long `input_changes` keeps what nobody has taken yet; 0: nobody takes it.
  double changes_kept_s = 0.0;
  // Runs, alarms and diagnostics that are kept of each channel.
  std::size_t reports_kept_max = 500;
  // Asked from the preparations while they compile; true: nobody waits for them any more.
  std::function<bool()> gives_up{};
};

class Machine {
 public:
  // `config` and `files` outlive the machine. Throws std::invalid_argument when the configuration
  // contradicts itself.
  Machine(const MachineConfig& config, const lang::Files& files,
          const MachineOptions& options = {});
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  [[nodiscard]] const MachineConfig& config() const;

  // Channel `index` counts from 0. One thread per channel at most.
  [[nodiscard]] Progress prepare(int index);
  // The same of a run that is repeated; not while a cycle runs.
  [[nodiscard]] Progress prepare(int index, RecordedWork& recorded);
  // Whether the axes of channel `index` may come to rest in the cut where its preparation is late;
  // from the thread that prepares it.
  [[nodiscard]] bool is_urgent(int index) const;
  // Whether channel `index` has prepared what a recorded cycle saw of it. Not while a cycle runs.
  [[nodiscard]] bool has_prepared(int index, const Arrivals& recorded) const;

  // Power-on choice of a scheme, before the first cycle. False: no such channel or scheme.
  [[nodiscard]] bool select_scheme_at_start(int channel, int scheme);

  void cycle(const CycleInputs& inputs, CycleOutput& output) RT_SAFE;

  // Whether a cycle may be made up for whose time has passed: axes move or spindles turn, and where
  // they are to go depends on nothing that was not looked at meanwhile. None looks for a contact or
  // a switch.
  [[nodiscard]] bool may_carry_on() const RT_SAFE;

  // All channels stand with nothing to do: no run, no switch, no request.
  [[nodiscard]] bool is_idle() const RT_SAFE;

  // Nothing will happen any more without an operator: every channel is idle, or held and standing,
  // or waits for channels that are.
  [[nodiscard]] bool waits_for_operator() const RT_SAFE;

  // Out of the cycle; one consumer each.
  [[nodiscard]] Ring<Event>& events();
  [[nodiscard]] Ring<InputRecord>& input_records();
  [[nodiscard]] Ring<InputChange>& input_changes();
  [[nodiscard]] Ring<OperatorReply>& replies();
  [[nodiscard]] Ring<OperatorReply>& stop_replies();  // of events with stop_id_mark
  // Of what was refused beside the cycle, in its thread. Without room it is lost, and counted.
  void answer(const OperatorReply& reply) RT_SAFE;
  // Replies that found no room; any thread.
  [[nodiscard]] std::uint64_t replies_lost() const RT_SAFE;

  // Input records that found no place so far; any thread.
  [[nodiscard]] std::uint64_t inputs_lost() const RT_SAFE;

  // Before the first cycle: runs and alarms of earlier starts, and the clock of the wall.
  void recall(Past past, TimeOfCycle time_of);
  // An alarm that no cycle has raised; its number. Any thread.
  std::uint64_t note(AlarmReport alarm);
  // Reports gathered by the preparations and the caller of `collect`; any thread.
  [[nodiscard]] std::vector<RunReport> runs() const;
  [[nodiscard]] std::vector<AlarmReport> alarms() const;
  // Errors and warnings of all loads so far.
  [[nodiscard]] std::vector<AlarmReport> load_diagnostics() const;
  // Where the next run of the channel with this id begins; nothing: at the first block.
  [[nodiscard]] std::optional<SearchReport> search(int channel) const;
  // What gives the words of a channel their meaning, as its output tells it; any thread.
  [[nodiscard]] SituationReport situation(const ChannelOutput& shown) const;
  [[nodiscard]] TablesConfig tables() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stanok::channels
