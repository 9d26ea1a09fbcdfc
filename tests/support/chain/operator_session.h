// Sessions of an operator: random lines by hand at a shipped machine, and the same lines as one
// program.
//
// Each line is chosen where the axes stand then, so that most stay within the travel. A third of
// the moves are incremental; all that gives words their meaning is changed between them: work
// offsets, G52, G92, rotation, planes, scaling, mirror, units, lengths of every kind, tools, rows
// of both tables, stored points, cycles and probing.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "tests/support/chain/random_program.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {

// Shipped machine files with a table of tools, without folder and ending.
[[nodiscard]] std::vector<std::string> machines_with_tools();
[[nodiscard]] channels::MachineConfig shipped_machine(const std::string& name);

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

// Draws lines for channel 1 of a machine, and counts what it has drawn.
class LineSource {
 public:
  LineSource(const channels::MachineConfig& machine, Choices& choices);

  // The first line of a session: a state that the kind of machine does not matter for.
  [[nodiscard]] std::string first() const;
  // `shown`: the words that lead to where the axes stand.
  [[nodiscard]] std::string next(const lang::AxisValues& shown);
  // What was drawn, by the word that stands for its class.
  [[nodiscard]] const std::map<std::string, int>& drawn() const { return drawn_; }

 private:
  [[nodiscard]] std::string move(const lang::AxisValues& shown);
  [[nodiscard]] std::string of_offsets();
  [[nodiscard]] std::string of_tools();
  [[nodiscard]] std::string of_frames();
  [[nodiscard]] std::string of_cycles(const lang::AxisValues& shown);
  [[nodiscard]] std::string of_modes();
  [[nodiscard]] std::string words(const std::string& letters, double low, double high);
  [[nodiscard]] std::string any_of(const std::vector<std::string>& texts);
  [[nodiscard]] int any_tool();
  [[nodiscard]] std::size_t place_of(const std::string& word) const;
  void count(const std::string& what) { ++drawn_[what]; }

  const channels::MachineConfig& machine_;
  const channels::ChannelConfig& channel_;
  Choices& choices_;
  std::map<std::string, int> drawn_;
};

// A machine in memory that is worked by hand.
class HandBench {
 public:
  explicit HandBench(channels::MachineConfig machine);

  // Types a line and waits until it is done; the code of what went wrong, or nothing.
  [[nodiscard]] std::string type(const std::string& line);
  // Runs the text up to its M0 and holds there; the code of the alarm, or nothing.
  [[nodiscard]] std::string run_to_stop(const std::string& text);
  // Until nothing happens any more.
  void settle();

  [[nodiscard]] ChannelLeft left();
  // The words that lead to where the axes stand, as the display has them; and those of a way.
  [[nodiscard]] lang::AxisValues shown();
  // A line that types them back, in the units of the channel.
  [[nodiscard]] std::string typed_back();
  [[nodiscard]] MachineBench& bench() { return bench_; }
  [[nodiscard]] const channels::ChannelOutput& now() const { return bench_.channel(1); }

 private:
  [[nodiscard]] std::string wait(const std::function<bool()>& is_over);

  channels::MachineConfig machine_;
  MachineBench bench_;
};

}  // namespace stanok::testing
