// Claims of axes that several channels have.
#include "channels/coordinator/axis_ownership.h"

#include <algorithm>

namespace stanok::channels {
namespace {

bool contains(lang::AxisSet axes, int axis) RT_SAFE {
  return (axes >> axis & 1U) != 0;
}

}  // namespace

AxisOwnership::AxisOwnership(std::span<Channel* const> channels)
    : channel_count_(static_cast<int>(channels.size())) {
  std::copy(channels.begin(), channels.end(), channels_.begin());
  owner_.fill(-1);
  for (const bool by_scheme : {true, false}) {
    for (int c = 0; c < channel_count_; ++c) {
      for (int axis = 0; axis < channel(c).axes.count(); ++axis) {
        int& owner = owner_[channel(c).axes.machine_axis(axis)];
        if (by_scheme && !contains(channel(c).schemes.participants(), axis)) continue;
        if (owner < 0) owner = c;
      }
    }
  }
  for (int c = 0; c < channel_count_; ++c) {
    for (int axis = 0; axis < channel(c).axes.count(); ++axis)
      channel(c).axes.set_owned(axis, owner(channel(c).axes.machine_axis(axis)) == c);
  }
}

AxisOwnership::Obstacle AxisOwnership::obstacle(int claimant, lang::AxisSet axes) const RT_SAFE {
  for (int axis = 0; axis < channel(claimant).axes.count(); ++axis) {
    if (!contains(axes, axis) || channel(claimant).axes.owns(axis)) continue;
    const int holder = owner(channel(claimant).axes.machine_axis(axis));
    const Channel& other = channel(holder);
    const int theirs = other.axes.of_machine_axis(channel(claimant).axes.machine_axis(axis));
    const bool is_used = contains(other.schemes.participants(), theirs);
    // During a change of scheme it is the coming scheme that counts, too.
    if (other.items().change().is_pending() || (is_used && other.state().is_running()))
      return {axis, holder, true};
    if (is_used && !other.motion.is_standing()) return {axis, holder, false};
  }
  return {};
}

void AxisOwnership::claim(int claimant, lang::AxisSet axes) RT_SAFE {
  for (int axis = 0; axis < channel(claimant).axes.count(); ++axis) {
    if (!contains(axes, axis) || channel(claimant).axes.owns(axis)) continue;
    const int machine_axis = channel(claimant).axes.machine_axis(axis);
    int& holder = owner_[machine_axis];
    channel(claimant).take_axis(
        axis, channel(holder).yield_axis(channel(holder).axes.of_machine_axis(machine_axis)));
    holder = claimant;
  }
}

void AxisOwnership::show_owners(CycleOutput& output) const RT_SAFE {
  for (int c = 0; c < channel_count_; ++c) {
    for (int axis = 0; axis < channel(c).axes.count(); ++axis) {
      if (channel(c).axes.owns(axis)) continue;
      const int machine_axis = channel(c).axes.machine_axis(axis);
      const int holder = owner(machine_axis);
      const int theirs = channel(holder).axes.of_machine_axis(machine_axis);
      const ChannelOutput& from = output.channels[holder];
      ChannelOutput& to = output.channels[c];
      to.axes[axis] = from.axes[theirs];
      to.drives[axis] = from.drives[theirs];
    }
  }
}

}  // namespace stanok::channels
