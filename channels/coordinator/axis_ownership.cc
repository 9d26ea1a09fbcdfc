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
      for (int axis = 0; axis < channel(c).axis_count(); ++axis) {
        int& owner = owner_[static_cast<std::size_t>(channel(c).machine_axis(axis))];
        if (by_scheme && !contains(channel(c).axes_of_scheme(), axis)) continue;
        if (owner < 0) owner = c;
      }
    }
  }
  for (int c = 0; c < channel_count_; ++c) {
    for (int axis = 0; axis < channel(c).axis_count(); ++axis)
      channel(c).set_owned(axis, owner(channel(c).machine_axis(axis)) == c);
  }
}

AxisOwnership::Obstacle AxisOwnership::obstacle(int claimant, lang::AxisSet axes) const RT_SAFE {
  for (int axis = 0; axis < channel(claimant).axis_count(); ++axis) {
    if (!contains(axes, axis) || channel(claimant).owns(axis)) continue;
    const int holder = owner(channel(claimant).machine_axis(axis));
    const Channel& other = channel(holder);
    const int theirs = other.axis_of_machine_axis(channel(claimant).machine_axis(axis));
    const bool is_used = contains(other.axes_of_scheme(), theirs);
    // During a change of scheme it is the coming scheme that counts, too.
    if (other.is_switching() || (is_used && other.is_running())) return {axis, holder, true};
    if (is_used && !other.is_standing()) return {axis, holder, false};
  }
  return {};
}

void AxisOwnership::claim(int claimant, lang::AxisSet axes) RT_SAFE {
  for (int axis = 0; axis < channel(claimant).axis_count(); ++axis) {
    if (!contains(axes, axis) || channel(claimant).owns(axis)) continue;
    const int machine_axis = channel(claimant).machine_axis(axis);
    int& holder = owner_[static_cast<std::size_t>(machine_axis)];
    channel(claimant).take_axis(
        axis, channel(holder).yield_axis(channel(holder).axis_of_machine_axis(machine_axis)));
    holder = claimant;
  }
}

void AxisOwnership::show_owners(CycleOutput& output) const RT_SAFE {
  for (int c = 0; c < channel_count_; ++c) {
    for (int axis = 0; axis < channel(c).axis_count(); ++axis) {
      if (channel(c).owns(axis)) continue;
      const int machine_axis = channel(c).machine_axis(axis);
      const int holder = owner(machine_axis);
      const auto theirs =
          static_cast<std::size_t>(channel(holder).axis_of_machine_axis(machine_axis));
      const auto ours = static_cast<std::size_t>(axis);
      const ChannelOutput& from = output.channels[static_cast<std::size_t>(holder)];
      ChannelOutput& to = output.channels[static_cast<std::size_t>(c)];
      to.axes[ours] = from.axes[theirs];
      to.drives[ours] = from.drives[theirs];
    }
  }
}

}  // namespace stanok::channels
