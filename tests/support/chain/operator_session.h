// Sessions of an operator: random lines by hand at a shipped machine, and what they leave behind.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "tests/support/chain/line_source.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {

// Shipped machine files with a table of tools, without folder and ending.
[[nodiscard]] std::vector<std::string> machines_with_tools();
[[nodiscard]] channels::MachineConfig shipped_machine(const std::string& name);

// A channel of such a machine in one of its schemes, its programs in one of the dialects.
struct HandPlace {
  std::string machine;
  int channel = 1;
  int scheme = 1;
  lang::Dialect dialect = lang::Dialect::stanok;

  [[nodiscard]] channels::MachineConfig config() const;
  [[nodiscard]] std::string name() const;
  friend void PrintTo(const HandPlace& place, std::ostream* out) { *out << place.name(); }
};
// All channels that move axes, in each of their schemes, in the dialect of stanok; and the first
// one of each machine in the others. With a sanitizer the first of each machine, and a fourth of
// all others.
[[nodiscard]] std::vector<HandPlace> hand_places();

// How a channel is left: what an operator sees of it and what the next line depends on.
struct ChannelLeft {
  std::vector<double> axes_M;
  channels::TablesConfig tables;
  kinematics::Frame frame;
  kinematics::PointMode mode = kinematics::PointMode::axes;
  std::vector<double> words;  // that lead to where the axes stand
  std::vector<std::string> codes;
  lang::ToolLength length;
  int tool = 0;
  double spindle_rev_per_min = 0.0;
};

// In words, what differs; empty: nothing does (mm, deg: 1e-9).
[[nodiscard]] std::string difference(const ChannelLeft& a, const ChannelLeft& b);

// A machine in memory that is worked by hand, at one of its channels.
class HandBench {
 public:
  explicit HandBench(channels::MachineConfig machine, int channel = 1);

  // Types a line and waits until it is done; the code of what went wrong, or nothing.
  [[nodiscard]] std::string type(const std::string& line);
  // Runs the text up to an M0 behind it and holds there; the code of the alarm, or nothing.
  // `subprograms` come behind the end.
  [[nodiscard]] std::string run_to_stop(const std::string& text,
                                        const std::string& subprograms = "");
  // Asks for something and waits until nothing happens any more; the code of a refusal, or nothing.
  [[nodiscard]] std::string ask(const channels::CommandFields& command);
  // Begins a program and lets so many cycles pass.
  void begin(const std::string& text, std::size_t cycles);
  // Until nothing happens any more, or nothing without the operator.
  void settle();
  // Lets cycles pass.
  void pass(std::size_t cycles);
  // The machine as it would be set up after power was off: tables and places of its axes.
  [[nodiscard]] channels::MachineConfig kept() const;

  [[nodiscard]] ChannelLeft left();
  // The words that lead to where the axes stand, as the display has them.
  [[nodiscard]] lang::AxisValues shown();
  // A line that types them back, in the units of the channel.
  [[nodiscard]] std::string typed_back();
  [[nodiscard]] MachineBench& bench() { return bench_; }
  [[nodiscard]] const MachineBench& bench() const { return bench_; }
  [[nodiscard]] const channels::MachineConfig& machine() const { return machine_; }
  [[nodiscard]] const channels::ChannelConfig& channel() const;
  [[nodiscard]] const channels::ChannelOutput& now() const { return bench_.channel(channel_); }
  [[nodiscard]] bool has_alarm() { return !bench_.machine().alarms().empty(); }

 private:
  [[nodiscard]] std::string wait(const std::function<bool()>& is_over);

  channels::MachineConfig machine_;
  int channel_;
  MachineBench bench_;
};

// An operator at a channel who types random lines. A line that the machine refuses, or at which it
// fails, is none: the machine is set up anew by what it took before.
class OperatorSession {
 public:
  OperatorSession(const channels::MachineConfig& machine, int channel, Choices& choices,
                  WordCounts counts = {});

  void type(int count);
  // A machine that was never worked at, in place of this one; one that was switched off and on.
  void forget();
  void restart();
  // What the machine took, in their order, and as a program.
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] HandBench& bench() { return *bench_; }
  [[nodiscard]] const WordCounts& counts() const { return source_.counts(); }

 private:
  void set_up_anew();

  const channels::MachineConfig& machine_;
  int channel_;
  LineSource source_;
  std::vector<std::string> lines_;
  std::unique_ptr<HandBench> bench_;
};

}  // namespace stanok::testing
