// OperatorDesk: commands of operators that take effect in the cycle in which they come: power,
// holds, overrides, switches, jogs, tables, the cutting process.
//
// Whether a channel admits a command is decided before (channels/contract/command_rules.h). Thread:
// the real-time cycle. Owner: the coordinator.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "channels/contract/operator_event.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/control_desk.h"
#include "channels/coordinator/length_desk.h"
#include "channels/coordinator/machine_stores.h"
#include "channels/coordinator/verdict.h"
#include "lang/contract/changed_rows.h"

namespace stanok::channels {

class OperatorDesk {
 public:
  // Both outlive the desk, and what `stores` names.
  OperatorDesk(const ChannelTable& channels, ControlDesk& control, const MachineStores& stores)
      : channels_(channels), control_(control), stores_(stores), lengths_(channels, stores) {}

  // `channel`: the one that the event names; nullptr: all. Nothing: the command takes time.
  [[nodiscard]] std::optional<Verdict> apply(const OperatorEvent& event, Channel* channel) RT_SAFE;

 private:
  // Applies a command: one overload for each.
  struct Application;
  [[nodiscard]] Verdict switch_on(const Channel* named) RT_SAFE;
  [[nodiscard]] std::optional<Verdict> refusal_in_run(std::optional<double> now, double to,
                                                      std::string_view unit) const RT_SAFE;
  [[nodiscard]] std::optional<Verdict> refusal_of_tool(const commands::ToolSet& command,
                                                       ToolValue value, double by) const RT_SAFE;
  [[nodiscard]] Verdict set_tool(const commands::ToolSet& command) RT_SAFE;
  [[nodiscard]] Verdict set_offset(const commands::OffsetSet& command) RT_SAFE;
  [[nodiscard]] Verdict touch(const Channel& channel, const commands::OffsetTouch& command) RT_SAFE;
  [[nodiscard]] Verdict touch(Channel& channel, const commands::ToolTouch& command) RT_SAFE;
  void settle(const lang::ChangedRows& rows) RT_SAFE;

  const ChannelTable& channels_;
  ControlDesk& control_;
  MachineStores stores_;
  LengthDesk lengths_;
};

}  // namespace stanok::channels
