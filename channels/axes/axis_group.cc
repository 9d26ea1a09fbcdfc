#include "channels/axes/axis_group.h"

#include "base/units.h"

namespace stanok::channels {
namespace {

constexpr DriveCommand free_to_move{.enabled = true, .brake_closed = false};
constexpr DriveCommand braked{.enabled = false, .brake_closed = true};

}  // namespace

AxisGroup::AxisGroup(const ChannelConstants& constants) : constants_(constants), owned_(all()) {
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    setpoints_[k].position = constants.start[k];
    setpoints_[k].position_code =
        motion::position_code(constants.start[k], constants.axes[k].codes);
  }
  for (const int axis : constants.spindle_axis) {
    if (axis >= 0) spindles_ = static_cast<lang::AxisSet>(spindles_ | 1U << axis);
  }
}

int AxisGroup::named(std::string_view name) const RT_SAFE {
  for (int axis = 0; axis < count(); ++axis) {
    if (this->name(axis).view() == name) return axis;
  }
  return -1;
}

int AxisGroup::of_machine_axis(int machine_axis) const RT_SAFE {
  for (int axis = 0; axis < count(); ++axis) {
    if (this->machine_axis(axis) == machine_axis) return axis;
  }
  return -1;
}

void AxisGroup::set_owned(int axis, bool owned) RT_SAFE {
  const unsigned bit = 1U << axis;
  owned_ = static_cast<lang::AxisSet>(owned ? owned_ | bit : owned_ & ~bit);
}

YieldedAxis AxisGroup::yield(int axis) RT_SAFE {
  set_owned(axis, false);
  return {setpoint(axis).position, drive(axis)};
}

void AxisGroup::take(int axis, const YieldedAxis& yielded) RT_SAFE {
  set_owned(axis, true);
  at(axis) = {};
  place(axis, yielded.position);
  drives_[axis] = yielded.drive;
}

void AxisGroup::become_spindle(int axis, double angle_deg) RT_SAFE {
  at(axis).position = angle_deg;
  spindles_ = static_cast<lang::AxisSet>(spindles_ | 1U << axis);
}

void AxisGroup::become_axis(int axis, double position) RT_SAFE {
  at(axis).position = position;
  spindles_ = static_cast<lang::AxisSet>(spindles_ & ~(1U << axis));
}

void AxisGroup::power(lang::AxisSet free) RT_SAFE {
  release(free);
  brake(static_cast<lang::AxisSet>(all() & ~free));
}

void AxisGroup::release(lang::AxisSet axes) RT_SAFE {
  command(static_cast<lang::AxisSet>(axes & owned_), free_to_move);
}

void AxisGroup::brake(lang::AxisSet axes) RT_SAFE {
  command(static_cast<lang::AxisSet>(axes & owned_), braked);
}

void AxisGroup::command(lang::AxisSet axes, const DriveCommand& drive) RT_SAFE {
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if ((axes >> k & 1U) != 0) drives_[k] = drive;
  }
}

void AxisGroup::close_brakes(lang::AxisSet axes) RT_SAFE {
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if ((axes >> k & 1U) != 0) drives_[k].brake_closed = true;
  }
}

void AxisGroup::switch_on(lang::AxisSet axes) RT_SAFE {
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if ((axes >> k & 1U) != 0) drives_[k].enabled = true;
  }
}

lang::AxisSet AxisGroup::enabled() const RT_SAFE {
  unsigned axes = 0;
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if (drives_[k].enabled) axes |= 1U << k;
  }
  return static_cast<lang::AxisSet>(axes);
}

void AxisGroup::follow(const motion::JetPoint& axes_M) RT_SAFE {
  for (int axis = 0; axis < count(); ++axis) {
    AxisSetpoint& setpoint = at(axis);
    const kinematics::Jet& jet = axes_M[axis];
    const motion::CodeScale& codes = constants(axis).codes;
    setpoint.velocity_code = motion::velocity_code(setpoint.position, jet.value, codes);
    setpoint.position = jet.value;
    setpoint.velocity = jet.first;
    setpoint.acceleration = jet.second;
    setpoint.jerk = jet.third;
    setpoint.position_code = motion::position_code(jet.value, codes);
  }
}

void AxisGroup::turn(int axis, const Spindle& spindle, double speed_before) RT_SAFE {
  const motion::CodeScale& codes = constants(axis).codes;
  const double cycle_s = constants_.cycle_s;
  AxisSetpoint& setpoint = at(axis);
  setpoint = {};
  setpoint.position = spindle.angle_deg();
  setpoint.velocity = deg_per_s_of_rev_per_min * spindle.speed();
  setpoint.acceleration = deg_per_s_of_rev_per_min * (spindle.speed() - speed_before) / cycle_s;
  setpoint.velocity_demand = setpoint.velocity;
  setpoint.position_code = motion::position_code(setpoint.position, codes);
  setpoint.velocity_code = motion::velocity_code(setpoint.position - setpoint.velocity * cycle_s,
                                                 setpoint.position, codes);
}

void AxisGroup::place(int axis, double position) RT_SAFE {
  at(axis).position = position;
  at(axis).position_code = motion::position_code(position, constants(axis).codes);
}

void AxisGroup::show(ChannelOutput& output) const RT_SAFE {
  output.axis_count = count();
  output.axes = setpoints_;
  output.drives = drives_;
  for (int axis = 0; axis < count(); ++axis)
    output.drives[axis].follows_velocity = is_spindle(axis);
}

lang::AxisSet axes_to_home(const AxisGroup& group) RT_SAFE {
  unsigned axes = 0;
  for (int axis = 0; axis < group.count(); ++axis) {
    const bool is_homed_by_search = group.constants(axis).manual.homing.order > 0;
    if (is_homed_by_search && group.owns(axis) && !group.is_spindle(axis)) axes |= 1U << axis;
  }
  return static_cast<lang::AxisSet>(axes);
}

}  // namespace stanok::channels
