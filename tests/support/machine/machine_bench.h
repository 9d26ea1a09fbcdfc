// MachineBench: a machine in memory, its programs in memory, and a virtual clock; for tests of
// channels and above.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/machine/machine.h"

namespace stanok::testing {

// Program texts by name; nothing on disk.
class MemoryFiles final : public lang::Files {
 public:
  std::map<std::string, std::string> texts;

  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override;
};

// Three linear axes 250 mm/s, 2500 mm/s2, 50000 mm/s3 and B, C 120 deg/s, 1200, 24000 on channel 1
// with the schemes 1 (cartesian X Y Z, B and C parked at 0) and 2 (head_table, pivot 200 mm);
// channel 2 is a master channel.
[[nodiscard]] channels::MachineConfig two_channel_machine();

// A lathe: X, Z 250 mm/s, 2500 mm/s2, 50000 mm/s3; spindle 1 to 3000 rev/min, which becomes C with
// 120 deg/s, 1200, 24000 after M902. Its axes by their places in the channel.
[[nodiscard]] channels::MachineConfig turning_machine();
inline constexpr std::size_t lathe_X = 0;
inline constexpr std::size_t lathe_Z = 1;
inline constexpr std::size_t lathe_C = 2;

// Channels 1 and 2 with an axis of their own (X1 and X2, both called X) and C, which both have.
// Schemes 1 leave C out, schemes 2 have it.
[[nodiscard]] channels::MachineConfig machine_with_a_shared_axis();

// Channels 1 to `count` with one axis X each (machine axes X1, X2, ...): 250 mm/s, 2500 mm/s2,
// 50000 mm/s3.
[[nodiscard]] channels::MachineConfig machine_of_one_axis_channels(int count);

class MachineBench {
 public:
  explicit MachineBench(channels::MachineConfig config = two_channel_machine(),
                        const channels::MachineOptions& options = {.on_at_start = true,
                                                                   .stops_go_on = true});
  ~MachineBench();
  MachineBench(const MachineBench&) = delete;
  MachineBench& operator=(const MachineBench&) = delete;

  void program(const std::string& name, const std::string& text) { files_.texts[name] = text; }

  // Asks for an operator's action in the next cycle.
  void ask(channels::OperatorAction action, int channel, const std::string& text = "",
           double value = 0.0, int number = 0);
  void ask(channels::OperatorEvent event);
  void run(int channel, const std::string& program) {
    ask(channels::OperatorAction::program_run, channel, program);
  }

  // What the drives answer from here on, in the order of the machine's axes; empty: ideal drives.
  void feedback(std::vector<channels::AxisFeedback> feedback) { feedback_ = std::move(feedback); }

  // What the sensors of the spindles tell from here on; empty: there are none.
  void sensors(std::vector<channels::SpindleSensors> sensors) { sensors_ = std::move(sensors); }

  // What the inputs of programs are from here on.
  void inputs(const Signals& inputs) { inputs_ = inputs; }

  // One cycle, all preparations blocked before; returns its output.
  const channels::CycleOutput& cycle();
  // Until nothing happens any more without an operator; fails the test after `cycles_max`. `watch`
  // sees every cycle.
  void run_to_end(const std::function<void(const channels::CycleOutput&)>& watch = {},
                  int cycles_max = 200000);

  [[nodiscard]] channels::Machine& machine() { return *machine_; }
  [[nodiscard]] const channels::Machine& machine() const { return *machine_; }
  [[nodiscard]] const channels::CycleOutput& output() const { return output_; }
  [[nodiscard]] const channels::ChannelOutput& channel(int id) const;
  [[nodiscard]] std::vector<std::string> alarm_codes() const;
  // Where nobody looks at them none may be a refusal, but for a test that says so: a test of a
  // program that was not loaded tests nothing.
  [[nodiscard]] const std::vector<channels::OperatorReply>& replies() const {
    are_replies_seen_ = true;
    return replies_;
  }
  void may_refuse() { are_replies_seen_ = true; }
  // Codes of all events so far.
  [[nodiscard]] const std::vector<std::string>& event_codes() const { return event_codes_; }

 private:
  channels::MachineConfig config_;
  MemoryFiles files_;
  std::unique_ptr<channels::Machine> machine_;
  channels::CycleOutput output_;
  std::vector<channels::OperatorEvent> events_;
  std::vector<channels::OperatorReply> replies_;
  mutable bool are_replies_seen_ = false;
  std::vector<std::string> event_codes_;
  std::vector<channels::AxisFeedback> feedback_;
  std::vector<channels::SpindleSensors> sensors_;
  std::optional<Signals> inputs_;
  std::uint64_t next_id_ = 1;
};

}  // namespace stanok::testing
