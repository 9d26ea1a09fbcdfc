// Spindles that are axes for a while, and axes that other channels have, as the cycle sees them.
//
// The drive of such an axis follows a velocity while it is a spindle: its set-point is the angle of
// the spindle in [0, 360) deg and its speed. After M902 the axis goes on from where the drive
// stands, and its position loop is closed; M903 opens it again.
#include <algorithm>
#include <cmath>

#include "channels/axes/spindle.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

constexpr double standstill_deg_per_s = 0.5;  // below, a drive that follows velocity 0 stands

}  // namespace

int Channel::spindle_index(int id) const RT_SAFE {
  for (int s = 0; s < figures_.spindle_count; ++s) {
    if (id == 0 || figures_.spindles[static_cast<std::size_t>(s)].id == id) return s;
  }
  return -1;
}

int Channel::axis_of_spindle(int id) const RT_SAFE {
  const int s = spindle_index(id);
  return s < 0 ? -1 : figures_.spindle_axis[static_cast<std::size_t>(s)];
}

bool Channel::is_spindle_now(int axis) const RT_SAFE {
  return axis >= 0 && (spindle_axes_ >> axis & 1U) != 0;
}

bool Channel::spindle_stands(int id) const RT_SAFE {
  const auto s = static_cast<std::size_t>(spindle_index(id));
  const auto axis = static_cast<std::size_t>(figures_.spindle_axis[s]);
  return spindles_[s].speed() == 0.0 && std::fabs(feedback_[axis].velocity) < standstill_deg_per_s;
}

void Channel::stop_spindle(int id) RT_SAFE {
  spindles_[static_cast<std::size_t>(spindle_index(id))].stop();
}

void Channel::close_position_loop(int id) RT_SAFE {
  const auto s = static_cast<std::size_t>(spindle_index(id));
  const int axis = figures_.spindle_axis[s];
  const auto k = static_cast<std::size_t>(axis);
  if (!is_spindle_now(axis)) return;
  const double angle = drives_are_ideal_ ? spindles_[s].angle_deg() : feedback_[k].position;
  path_.axes[k] = angle;
  setpoints_[k].position = angle;
  spindle_axes_ = static_cast<lang::AxisSet>(spindle_axes_ & ~(1U << axis));
  stand_in_frame();
}

bool Channel::position_loop_is_closed(int id) const RT_SAFE {
  const int axis = axis_of_spindle(id);
  if (axis < 0 || is_spindle_now(axis)) return false;
  const auto k = static_cast<std::size_t>(axis);
  return drives_[k].enabled && feedback_[k].enabled;
}

void Channel::open_position_loop(int id) RT_SAFE {
  const auto s = static_cast<std::size_t>(spindle_index(id));
  const int axis = figures_.spindle_axis[s];
  if (axis < 0 || is_spindle_now(axis)) return;
  spindles_[s].stop();
  const auto k = static_cast<std::size_t>(axis);
  spindles_[s].set_angle(path_.axes[k].value);
  setpoints_[k].position = spindles_[s].angle_deg();
  spindle_axes_ = static_cast<lang::AxisSet>(spindle_axes_ | 1U << axis);
}

// M2, M30, reset and the start of a program do M903.
void Channel::open_position_loops() RT_SAFE {
  for (int s = 0; s < figures_.spindle_count; ++s)
    open_position_loop(figures_.spindles[static_cast<std::size_t>(s)].id);
}

// In place of what the path says of axes that are spindles now.
void Channel::turn_spindles() RT_SAFE {
  for (int s = 0; s < figures_.spindle_count; ++s) {
    const auto i = static_cast<std::size_t>(s);
    Spindle& spindle = spindles_[i];
    const double speed_before = spindle.speed();
    spindle.advance(figures_.cycle_s);
    const int axis = figures_.spindle_axis[i];
    if (axis < 0 || !is_spindle_now(axis)) continue;
    const auto k = static_cast<std::size_t>(axis);
    AxisSetpoint& setpoint = setpoints_[k];
    setpoint = {};
    setpoint.position = spindle.angle_deg();
    setpoint.velocity = deg_per_s_of_rev_per_min * spindle.speed();
    setpoint.acceleration =
        deg_per_s_of_rev_per_min * (spindle.speed() - speed_before) / figures_.cycle_s;
    setpoint.velocity_demand = setpoint.velocity;
    setpoint.position_code = motion::position_code(setpoint.position, figures_.axes[k].codes);
    setpoint.velocity_code =
        motion::velocity_code(setpoint.position - setpoint.velocity * figures_.cycle_s,
                              setpoint.position, figures_.axes[k].codes);
  }
}

}  // namespace stanok::channels
