// TouchDesk: touching off. A point where the axes stand gets a coordinate, by a work offset or by
// the length of a tool; said in words of the display, whatever codes are active.
//
// The answer holds the old and the new value and a number with which they can be exchanged again. A
// value or change that the machine file thinks unlikely wants to be confirmed. The value itself
// is made in the cycle, where the axes stand, and only in the situation that the asker has seen.
// Owner: the dispatch. Thread: that of the operator server.
#pragma once

#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "daemon/cycle/running_machine.h"
#include "daemon/desk/command_desk.h"

namespace stanok::daemon {

class TouchDesk {
 public:
  // Both outlive the desk.
  TouchDesk(RunningMachine& machine, CommandDesk& desk) : machine_(machine), desk_(desk) {}

  // Parameters as their rows in protocol/contract/methods_of_tables.cc.
  void touch_offset(const nlohmann::json& parameters, int channel, Answer answer);
  void touch_tool(const nlohmann::json& parameters, int channel, Answer answer);
  // Gives the value of before back, where nobody has changed it since.
  void undo(const nlohmann::json& parameters, Answer answer);

 private:
  // A value of a table that was touched off.
  struct Touch {
    std::uint64_t number = 0;
    channels::OperatorCommand back;  // that brings the old value
    double before = 0.0;
    double after = 0.0;
  };
  // What is touched off, as far as it is known before the cycle has it.
  struct Wanted {
    std::uint32_t situation = 0;
    std::size_t axis = 0;   // of the channel
    double point_W = 0.0;   // where the axis is to be, in the workpiece system
    double expected = 0.0;  // change of the value, mm or deg
    const char* unit = "mm";
  };
  using Refusal = std::optional<protocol::Failure>;

  [[nodiscard]] Expected<Wanted, protocol::Failure> wanted(const nlohmann::json& parameters,
                                                           int channel) const;
  // `entry`: the ToolSet or OffsetSet that it comes to, as far as it is known.
  [[nodiscard]] Refusal doubt(const nlohmann::json& parameters,
                              const channels::OperatorCommand& entry, const Wanted& wanted,
                              int channel) const;
  [[nodiscard]] std::optional<double> value_of(const channels::OperatorCommand& place) const;
  void submit(const channels::OperatorEvent& event, const channels::OperatorCommand& back,
              Answer answer);

  static constexpr std::size_t touches_max = 100;

  RunningMachine& machine_;
  CommandDesk& desk_;
  std::deque<Touch> touches_;
  std::uint64_t touched_ = 0;  // so far
};

}  // namespace stanok::daemon
