// LengthDesk: lengths of tools that operators change while programs are held. They count at once:
// the path goes on with them from where it is held, and the axes are led there by a return.
//
// Thread: the real-time cycle. Owner: the operators' desk.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "channels/contract/operator_command.h"
#include "channels/contract/tool_value.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/machine_stores.h"
#include "channels/coordinator/verdict.h"

namespace stanok::channels {

// X, Y, Z as 0, 1, 2, for a length or its wear; -1: another value.
[[nodiscard]] int axis_of_length(ToolValue value) RT_SAFE;

class LengthDesk {
 public:
  // Both outlive the desk, and what `stores` names.
  LengthDesk(const ChannelTable& channels, const MachineStores& stores)
      : channels_(channels), stores_(stores) {}

  // The change of a length of a tool along X, Y or Z (0, 1, 2) by the next write of the tables.
  [[nodiscard]] kinematics::LengthChange next(int tool, int edge, int axis, double by_mm) const
      RT_SAFE;
  // Why a held channel cannot take it now.
  [[nodiscard]] std::optional<Verdict> refusal_in_hold(const kinematics::LengthChange& change) const
      RT_SAFE;
  // It is written now, and nothing refuses it: who sees the write finds the change.
  void apply(const kinematics::LengthChange& change) const RT_SAFE;

 private:
  const ChannelTable& channels_;
  MachineStores stores_;
};

}  // namespace stanok::channels
