// Which channel moves each axis of the machine, where several channels have it.
//
// An axis belongs to the channel that claimed it last, with a scheme of which it is part or that
// parks it; nobody else writes its setpoints. It can be claimed while it takes no part in the
// scheme of its owner, or while its owner runs no program and the axis stands
// (docs/integrator/kinematics.md, "Axes of several channels").
#pragma once

#include <span>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/contract/output.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {

inline constexpr int machine_axes_max = channels_max * motion::axes_max;

class AxisOwnership {
 public:
  // The axes of the power-on schemes belong to their channels; then the first one that has the
  // axis.
  explicit AxisOwnership(std::span<Channel* const> channels);

  // Index of the channel that moves the axis of the machine; -1: no channel has it.
  [[nodiscard]] int owner(int machine_axis) const RT_SAFE { return owner_[machine_axis]; }

  // What stands against a claim: an axis, by index in the claiming channel, and who has it.
  struct Obstacle {
    int axis = -1;  // -1: nothing
    int owner = -1;
    bool owner_is_busy = false;  // else the axis is moving
  };
  [[nodiscard]] Obstacle obstacle(int channel, lang::AxisSet axes) const RT_SAFE;
  // Hands the axes over. There must be no obstacle.
  void claim(int channel, lang::AxisSet axes) RT_SAFE;

  // Shows the setpoints and drive commands of the owner in the outputs of all that have the axis.
  void show_owners(CycleOutput& output) const RT_SAFE;

 private:
  [[nodiscard]] Channel& channel(int index) const RT_SAFE { return *channels_[index]; }

  NumberedArray<Channel*, channels_max> channels_{};
  int channel_count_ = 0;
  NumberedArray<int, machine_axes_max> owner_{};
};

}  // namespace stanok::channels
