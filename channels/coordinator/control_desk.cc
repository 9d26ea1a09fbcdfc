#include "channels/coordinator/control_desk.h"

namespace stanok::channels {

Verdict ControlDesk::set(std::int32_t id, std::int32_t session) RT_SAFE {
  const int index = channels_.index_of(id);
  if (index < 0) return refusal("E6001", "a channel must be named");
  controller_[index] = session;
  return success();
}

bool ControlDesk::admits(const Errand& errand) const RT_SAFE {
  const std::int32_t controller = of(errand.target);
  const std::int32_t admitted =
      errand.asker == operator_asker ? errand.controller : of(errand.asker);
  return controller == 0 || controller == admitted;
}

std::optional<Verdict> ControlDesk::foreign_axis(int index, lang::AxisSet axes) const RT_SAFE {
  const Channel& claimant = channels_[index];
  for (int axis = 0; axis < claimant.axes.count(); ++axis) {
    if ((axes >> axis & 1U) == 0 || claimant.axes.owns(axis)) continue;
    const int owner = ownership_.owner(claimant.axes.machine_axis(axis));
    if (of(owner) == 0 || of(owner) == of(index)) continue;
    Verdict verdict = refusal("E6080", "axis ");
    verdict.text.append(claimant.axes.name(axis).view()).append(" belongs to channel ");
    verdict.text.append(channels_[owner].id()).append(", which is controlled by another operator");
    return verdict;
  }
  return std::nullopt;
}

}  // namespace stanok::channels
