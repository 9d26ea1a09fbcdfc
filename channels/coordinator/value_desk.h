// ValueDesk: values that programs read and write in the cycle: shared variables, tables, inputs and
// what the machine knows of itself.
//
// Thread: the real-time cycle. Owner: the coordinator.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "channels/coordinator/axis_ownership.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/errand.h"
#include "channels/coordinator/machine_stores.h"
#include "channels/coordinator/verdict.h"

namespace stanok::channels {

template <class Kind>
concept ValueRequest =
    IsOneOf<Kind, requests::ToolRead, requests::ToolWrite, requests::OffsetRead,
            requests::OffsetWrite, requests::MachineValueRead, requests::AnalogRead,
            requests::InputWait, requests::SharedNumberRead, requests::SharedNumberWrite,
            requests::SharedNumberCombine, requests::SharedTextRead, requests::SharedTextWrite,
            requests::SharedTextAppend>;

class ValueDesk {
 public:
  // Both outlive the desk, and what `stores` names.
  ValueDesk(const ChannelTable& channels, const AxisOwnership& ownership,
            const MachineStores& stores, double cycle_s)
      : channels_(channels), ownership_(ownership), stores_(stores), cycle_s_(cycle_s) {}

  // Of an errand with a ValueRequest.
  [[nodiscard]] Verdict step(Errand& errand) RT_SAFE;

 private:
  // Reads or writes: one overload for each kind of request.
  struct Access;
  [[nodiscard]] Verdict wait_for(const requests::InputWait& wait, Errand& errand) const RT_SAFE;
  [[nodiscard]] Verdict machine_value(const requests::MachineValueRead& read,
                                      const Channel& asker) const RT_SAFE;
  [[nodiscard]] Verdict input(std::string_view name, int index) const RT_SAFE;
  [[nodiscard]] std::optional<double> value_of_axis(std::string_view name, const Channel& asker,
                                                    int axis) const RT_SAFE;

  const ChannelTable& channels_;
  const AxisOwnership& ownership_;
  MachineStores stores_;
  double cycle_s_;
};

}  // namespace stanok::channels
