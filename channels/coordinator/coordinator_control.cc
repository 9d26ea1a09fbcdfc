// Who has a channel to himself, as far as programs and commands under way depend on it.
//
// The daemon refuses what others ask for; here ends what reaches a channel by another way: the
// program of another channel, an axis that is claimed, a command that was asked for before.
#include "channels/coordinator/coordinator.h"

namespace stanok::channels {

Coordinator::Verdict Coordinator::set_controller(const OperatorEvent& event) RT_SAFE {
  int index = -1;
  if (channel_with_id(event.channel, index) == nullptr)
    return refusal("E6001", "a channel must be named");
  controller_[static_cast<std::size_t>(index)] = event.number;
  return success();
}

// A program acts for whoever has its own channel. A command of an operator was admitted for the
// session that had the channel then.
bool Coordinator::is_under_control_of_others(const Errand& errand) const RT_SAFE {
  const std::int32_t controller = controller_[static_cast<std::size_t>(errand.target)];
  const std::int32_t admitted = errand.asker == operator_asker
                                    ? errand.controller
                                    : controller_[static_cast<std::size_t>(errand.asker)];
  return controller != 0 && controller != admitted;
}

// Channel `index` may not take an axis from a channel that somebody else has.
std::optional<Coordinator::Verdict> Coordinator::foreign_axis(int index, lang::AxisSet axes) const
    RT_SAFE {
  const Channel& claimant = channel(index);
  for (int axis = 0; axis < claimant.axes.count(); ++axis) {
    if ((axes >> axis & 1U) == 0 || claimant.axes.owns(axis)) continue;
    const int owner = ownership_.owner(claimant.axes.machine_axis(axis));
    const std::int32_t controller = controller_[static_cast<std::size_t>(owner)];
    if (controller == 0 || controller == controller_[static_cast<std::size_t>(index)]) continue;
    Verdict verdict = refusal("E6080", "axis ");
    verdict.text.append(claimant.axes.name(axis).view()).append(" belongs to channel ");
    verdict.text.append(channel(owner).id()).append(", which is under control of another operator");
    return verdict;
  }
  return std::nullopt;
}

}  // namespace stanok::channels
