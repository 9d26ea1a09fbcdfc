// What a program does that is hardly meant, although each of its blocks is right: cutting while no
// spindle turns, a speed that the spindle does not have, radius compensation at the end.
//
// Each kind is told once in a run. Owner: the dry run of a channel; fed with its commands in order.
#pragma once

#include <optional>

#include "base/diagnostic.h"
#include "channels/contract/machine_config.h"
#include "lang/contract/command.h"

namespace stanok::jobs {

class ProgramAdvice {
 public:
  // Both must outlive this.
  ProgramAdvice(const channels::MachineConfig& machine, const channels::ChannelConfig& channel)
      : machine_(machine), channel_(channel) {}

  // The warning that `command` is the first cause of, without its place.
  [[nodiscard]] std::optional<Diagnostic> advice(const lang::Command& command);

 private:
  [[nodiscard]] std::optional<Diagnostic> at_spindle(const lang::SpindleCommand& spindle);
  [[nodiscard]] std::optional<Diagnostic> at_move(const lang::Move& move);
  [[nodiscard]] std::optional<Diagnostic> at_end(const lang::ProgramEnd& end);

  const channels::MachineConfig& machine_;
  const channels::ChannelConfig& channel_;
  bool cuts_with_spindle_ = false;  // a spindle turned or a tool was changed in this run
  bool spindle_turns_ = false;
  bool told_standing_ = false;
  bool told_speed_ = false;
};

}  // namespace stanok::jobs
