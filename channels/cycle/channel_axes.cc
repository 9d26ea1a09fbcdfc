// The axes of one channel: which are its own now, and what a claim of another channel changes.
#include "channels/cycle/channel.h"

namespace stanok::channels {

int Channel::axis_of_machine_axis(int machine_axis) const RT_SAFE {
  for (int axis = 0; axis < figures_.axis_count; ++axis) {
    if (figures_.machine_axis[static_cast<std::size_t>(axis)] == machine_axis) return axis;
  }
  return -1;
}

lang::AxisSet Channel::axes_of_scheme() const RT_SAFE {
  const kinematics::Scheme* scheme = find_scheme(scheme_);
  return scheme == nullptr ? lang::AxisSet{0} : static_cast<lang::AxisSet>(scheme->participants());
}

lang::AxisSet Channel::axes_of_scheme(int id) const RT_SAFE {
  const kinematics::Scheme* scheme = find_scheme(id);
  if (scheme == nullptr) return 0;
  unsigned axes = scheme->participants();
  for (const kinematics::Parking& parking : scheme->config().parking) axes |= 1U << parking.axis;
  for (const auto& [axis, position] : scheme->config().retract) axes |= 1U << axis;
  return static_cast<lang::AxisSet>(axes);
}

void Channel::set_owned(int axis, bool owned) RT_SAFE {
  const unsigned bit = 1U << axis;
  owned_ = static_cast<lang::AxisSet>(owned ? owned_ | bit : owned_ & ~bit);
}

Channel::YieldedAxis Channel::yield_axis(int axis) RT_SAFE {
  const auto k = static_cast<std::size_t>(axis);
  set_owned(axis, false);
  return {setpoints_[k].position, drives_[k]};
}

// The path stands: it begins anew from where the axis is.
void Channel::take_axis(int axis, const YieldedAxis& yielded) RT_SAFE {
  const auto k = static_cast<std::size_t>(axis);
  set_owned(axis, true);
  path_.axes[k] = yielded.position;
  setpoints_[k] = {};
  setpoints_[k].position = yielded.position;
  setpoints_[k].position_code = motion::position_code(yielded.position, figures_.axes[k].codes);
  drives_[k] = yielded.drive;
  drive_was_ready_[k] = false;
  stand_in_frame();
}

void Channel::release_axes(lang::AxisSet axes) RT_SAFE {
  set_axes(axes, true);
}

}  // namespace stanok::channels
