// Axes of one channel moved by hand: jog, homing, and the watch over their limit switches.
#include <cmath>

#include "channels/cycle/channel.h"
#include "motion/limit_guard.h"

namespace stanok::channels {

int Channel::axis_named(std::string_view name) const RT_SAFE {
  for (int k = 0; k < figures_.axis_count; ++k) {
    if (axis_name(k).view() == name) return k;
  }
  return -1;
}

std::string_view Channel::jog(const Jog& jog) RT_SAFE {
  const auto k = static_cast<std::size_t>(jog.axis);
  if (running_ || resetting_) return "E6003";
  if (!powered_) return "E6006";
  if (!drives_[k].enabled) return is_parked(jog.axis) ? "E6058" : "E6006";
  if (!owns(jog.axis) || is_spindle_now(jog.axis)) return "E6052";
  if (!feedback_[k].valid || !feedback_[k].enabled) return "E6008";
  return manual_.jog(jog, path_.axes[k].value, feedback_[k]);
}

bool Channel::is_parked(int axis) const RT_SAFE {
  const kinematics::Scheme* const scheme = find_scheme(scheme_);
  return scheme != nullptr && (scheme->participants() >> axis & 1U) == 0;
}

// Those that look for a mark, and that this channel moves now.
lang::AxisSet Channel::axes_to_home() const RT_SAFE {
  unsigned axes = 0;
  for (int k = 0; k < figures_.axis_count; ++k) {
    const bool has_mark = figures_.axes[static_cast<std::size_t>(k)].manual.homing.order > 0;
    if (has_mark && owns(k) && !is_spindle_now(k)) axes |= 1U << k;
  }
  return static_cast<lang::AxisSet>(axes);
}

void Channel::return_to_parking() RT_SAFE {
  const kinematics::Scheme* const scheme = find_scheme(scheme_);
  if (scheme == nullptr) return;
  for (const kinematics::Parking& parking : scheme->config().parking) {
    const auto k = static_cast<std::size_t>(parking.axis);
    if (drives_[k].enabled && owns(parking.axis) && !is_spindle_now(parking.axis))
      manual_.go(parking.axis, path_.axes[k].value, parking.position);
  }
}

// The path stands: it begins anew from where the axes come to.
void Channel::move_by_hand() RT_SAFE {
  manual_.advance(feedback_, path_.axes);
  stand_in_frame();
}

bool Channel::begin_homing_of_spindle(int id) RT_SAFE {
  const int axis = axis_of_spindle(id);
  if (axis < 0 || figures_.axes[static_cast<std::size_t>(axis)].manual.homing.order == 0)
    return false;
  manual_.home(static_cast<lang::AxisSet>(1U << axis));
  return true;
}

int Channel::axis_on_limit_switch() const RT_SAFE {
  for (int k = 0; k < figures_.axis_count; ++k) {
    if ((on_limit_switch_ >> k & 1U) != 0) return k;
  }
  return -1;
}

// A setpoint that is no number, or a step that no axis can make, is a fault of our own and never
// reaches a drive: the axes stay where they were commanded last, and their drives go off.
bool Channel::guard_setpoints(Steps steps) RT_SAFE {
  constexpr double steps_allowed = 2.0;  // of the longest at the axis' highest velocity
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const kinematics::Jet& axis = path_.axes[i];
    const double step = std::abs(axis.value - setpoints_[i].position);
    if (!owns(k)) continue;
    const double step_max = steps_allowed * motion_.axes[i].velocity_max * figures_.cycle_s +
                            figures_.axes[i].codes.resolution;
    const bool is_number = std::isfinite(axis.value) && std::isfinite(axis.first) &&
                           std::isfinite(axis.second) && std::isfinite(axis.third);
    const bool may_step = steps == Steps::of_numbers || is_spindle_now(k);
    if (is_number && (step <= step_max || may_step)) continue;
    FixedText<128> text("axis ");
    text.append(axis_name(k).view());
    text.append(is_number ? " would step farther than it can move in a cycle"
                          : " would get a setpoint that is no number");
    for (std::size_t n = 0; n < motion::axes_max; ++n) path_.axes[n] = setpoints_[n].position;
    interpolator_.drop_path(link_.path);
    stand_in_frame();
    fault("A9002", text.view());
    return false;
  }
  return true;
}

// The last guard: planning lets nothing pass a soft limit, so whatever comes too near to one to
// stand before it is a fault (motion/limit_guard.h). Moves by hand keep their own limits.
void Channel::guard_limits() RT_SAFE {
  if (!running_ || resetting_ || manual_.is_active()) return;
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!owns(k) || is_spindle_now(k)) continue;
    const kinematics::Jet& axis = path_.axes[i];
    const double slack =
        figures_.axes[i].codes.resolution + std::abs(axis.first) * figures_.cycle_s;
    if (!motion::passes_limit(axis, motion_.axes[i], slack)) continue;
    FixedText<128> text("axis ");
    text.append(axis_name(k).view()).append(" comes too near to its soft limit to stand before it");
    return fault("A2003", text.view());
  }
}

// Who comes onto a limit switch is stopped; homing looks after its switches itself.
void Channel::watch_limit_switches() RT_SAFE {
  const bool homes = manual_.homing() == ManualMotion::Outcome::running;
  for (int k = 0; k < figures_.axis_count; ++k) {
    const AxisFeedback& drive = feedback_[static_cast<std::size_t>(k)];
    const unsigned bit = 1U << k;
    const bool was_on = (on_limit_switch_ & bit) != 0;
    const bool is_on = drive.valid && (drive.limit_negative || drive.limit_positive);
    on_limit_switch_ =
        static_cast<lang::AxisSet>(is_on ? on_limit_switch_ | bit : on_limit_switch_ & ~bit);
    if (!is_on || was_on || homes || !drives_[static_cast<std::size_t>(k)].enabled) continue;
    FixedText<128> text("axis ");
    text.append(axis_name(k).view());
    text.append(drive.limit_negative ? " stands on the limit switch at its negative end"
                                     : " stands on the limit switch at its positive end");
    fault("A2002", text.view());
  }
}

}  // namespace stanok::channels
