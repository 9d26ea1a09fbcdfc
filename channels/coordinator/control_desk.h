// ControlDesk: who has a channel to himself, as far as programs and commands under way depend on
// it.
//
// The daemon refuses what others ask for; here ends what reaches a channel by another way: the
// program of another channel, an axis that is claimed, a command that was asked for before. Thread:
// the real-time cycle. Owner: the coordinator.
#pragma once

#include <cstdint>
#include <optional>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/coordinator/axis_ownership.h"
#include "channels/coordinator/channel_table.h"
#include "channels/coordinator/errand.h"
#include "channels/coordinator/verdict.h"

namespace stanok::channels {

class ControlDesk {
 public:
  // Both outlive the desk.
  ControlDesk(const ChannelTable& channels, const AxisOwnership& ownership)
      : channels_(channels), ownership_(ownership) {}

  // The session has the channel with this id from here on; 0: nobody has.
  [[nodiscard]] Verdict set(std::int32_t id, std::int32_t session) RT_SAFE;
  // The session that has the channel; 0: nobody.
  [[nodiscard]] std::int32_t of(int channel) const RT_SAFE { return controller_[channel]; }
  // A program acts for whoever has its own channel. A command of an operator was admitted for the
  // session that had the channel then.
  [[nodiscard]] bool admits(const Errand& errand) const RT_SAFE;
  // Channel `index` may not take an axis from a channel that somebody else has.
  [[nodiscard]] std::optional<Verdict> foreign_axis(int index, lang::AxisSet axes) const RT_SAFE;

 private:
  const ChannelTable& channels_;
  const AxisOwnership& ownership_;
  NumberedArray<std::int32_t, channels_max> controller_{};
};

}  // namespace stanok::channels
