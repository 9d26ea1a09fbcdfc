#include "channels/cycle/jogging.h"

#include <cmath>

#include "channels/axes/jog_direction.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

// Of a jog: the one under way takes it up, or another one begins.
enum class Course : std::uint8_t { begins, goes_on };

// A held program lets its axes be moved away from the path, one move after the other, so that the
// way back is known.
std::string_view obstacle_in_hold(const Channel& channel, Course course) RT_SAFE {
  const AxisMotion& motion = channel.motion;
  if (!motion.path_is_at_rest()) return "E6070";
  if (motion.is_in_thread() || !channel.items().lets_axes_leave()) return "E6099";
  if (course == Course::goes_on) return {};
  if (motion.moves_by_hand()) return "E6056";
  return motion.aside().is_full() ? "E6100" : "";
}

std::string_view obstacle(const Channel& channel, Course course) RT_SAFE {
  if (channel.state().is_held()) return obstacle_in_hold(channel, course);
  if (channel.state().is_running() || channel.state().is_ending()) return "E6003";
  return channel.state().is_powered() ? "" : "E6006";
}

std::string_view obstacle_of_axis(const Channel& channel, int axis) RT_SAFE {
  if (!channel.axes.drive(axis).enabled) return channel.schemes.parks(axis) ? "E6058" : "E6006";
  if (!channel.axes.owns(axis) || channel.axes.is_spindle(axis)) return "E6052";
  const AxisFeedback& drive = channel.drives.feedback(axis);
  return drive.valid && drive.enabled ? "" : "E6008";
}

// A rotary axis that is not homed has directions of its own, and a parked one is where it is.
std::string_view obstacle_of_line(const Channel& channel, const AxisArray<double>& direction)
    RT_SAFE {
  for (int axis = 0; axis < channel.axes.count(); ++axis) {
    if (direction[axis] != 0.0) {
      if (const auto code = obstacle_of_axis(channel, axis); !code.empty()) return code;
    }
    const bool counts = (channel.schemes.participants() >> axis & 1U) != 0;
    if (counts && !channel.drives.feedback(axis).referenced) return "E6059";
  }
  return {};
}

void note_motion(Channel& channel) RT_SAFE {
  if (!channel.motion.manual().is_active()) return;
  if (!channel.state().is_held()) return channel.run.apply(Change::hand_begins);
  channel.run.call_off_by_hand();
  channel.motion.leave_path();
  channel.run.apply(Change::path_left);
}

template <class Begin>
std::string_view move_axis(Channel& channel, const Jog& jog, Begin&& begin) RT_SAFE {
  const Course course = channel.motion.manual().takes_up(jog) ? Course::goes_on : Course::begins;
  if (const auto code = obstacle(channel, course); !code.empty()) return code;
  if (const auto code = obstacle_of_axis(channel, jog.axis); !code.empty()) return code;
  const double from = channel.motion.path().axes[jog.axis].value;
  const auto refused = begin(from, channel.drives.feedback(jog.axis));
  note_motion(channel);
  return refused;
}

std::string_view obstacle_of_retrace(const Channel& channel) RT_SAFE {
  const AxisMotion& motion = channel.motion;
  if (!channel.state().is_held()) return "E6096";
  if (!motion.path_is_at_rest()) return "E6070";
  if (motion.is_in_thread() || !channel.items().lets_axes_leave()) return "E6099";
  if (motion.aside().is_on()) return "E6097";
  for (int axis = 0; axis < channel.axes.count(); ++axis) {
    const AxisFeedback& drive = channel.drives.feedback(axis);
    const bool is_ready = drive.valid && drive.enabled;
    if (channel.axes.drive(axis).enabled && !is_ready) return "E6008";
  }
  return {};
}

}  // namespace

std::string_view retrace(Channel& channel, const RetraceOrder& order) RT_SAFE {
  if (const auto code = obstacle_of_retrace(channel); !code.empty()) return code;
  const auto refused = channel.motion.retrace(channel.link.path, order);
  if (!channel.motion.is_off_path()) return refused;
  channel.run.call_off_by_hand();
  channel.run.apply(Change::path_left);
  return refused;
}

std::string_view jog(Channel& channel, const Jog& jog) RT_SAFE {
  return move_axis(channel, jog, [&](double from, const AxisFeedback& drive) RT_SAFE {
    return channel.motion.manual().jog(jog, from, drive);
  });
}

std::string_view turn(Channel& channel, int axis, double way) RT_SAFE {
  const Jog jog{.axis = axis, .velocity = way, .increment = std::abs(way)};
  return move_axis(channel, jog, [&](double from, const AxisFeedback& drive) RT_SAFE {
    return channel.motion.manual().turn(axis, way, from, drive);
  });
}

std::string_view jog(Channel& channel, JogFrame frame, int coordinate, JogLine line) RT_SAFE {
  const bool renews = line.increment == 0.0 && channel.motion.manual().jogs_along_line();
  if (const auto code = obstacle(channel, renews ? Course::goes_on : Course::begins); !code.empty())
    return code;
  AxisMotion& motion = channel.motion;
  const auto direction = jog_direction(frame, coordinate, motion.frame(), motion.axes_M());
  if (!direction) return "E6055";
  if (const auto code = obstacle_of_line(channel, *direction); !code.empty()) return code;
  line.direction = *direction;
  const auto refused = motion.manual().jog(line, channel.drives.feedback(), motion.path().axes);
  note_motion(channel);
  return refused;
}

}  // namespace stanok::channels
