#include "channels/axes/axis_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "channels/axes/setpoint_guard.h"

namespace stanok::channels {
namespace {

// Axes that a scheme gives up to whole turns only are where they are.
bool are_apart(const motion::Point& a, const motion::Point& b, const kinematics::Transform& frame)
    RT_SAFE {
  constexpr double same_place = 1e-6;  // mm, deg
  const unsigned winding = frame.scheme == nullptr ? 0U : frame.scheme->winding_axes();
  for (std::size_t k = 0; k < a.size(); ++k) {
    if ((winding >> k & 1U) == 0 && std::abs(a[k] - b[k]) > same_place) return true;
  }
  return false;
}

}  // namespace

AxisMotion::AxisMotion(const motion::MotionConfig& config, const ChannelConstants& constants,
                       SchemeTable& schemes, AxisGroup& axes, const DriveGuard& drives)
    : config_(config),
      constants_(constants),
      schemes_(schemes),
      axes_(axes),
      drives_(drives),
      retrace_(config, constants.retrace_bytes, lengths_),
      interpolator_(config, &retrace_.history(), &lengths_),
      loops_(constants) {
  AxisArray<ManualAxis> manual_axes{};
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    path_.axes[k] = constants.start[k];
    manual_axes[k] = constants.axes[k].manual;
  }
  manual_.set_up({manual_axes.begin(), manual_axes.begin() + constants.axis_count},
                 constants.cycle_s);
  stand_in_scheme();
}

std::optional<Fault> AxisMotion::advance(motion::PathQueue& queue,
                                         const motion::FeedControl& control,
                                         std::uint64_t chunk_limit, SoftLimits limits) RT_SAFE {
  interpolator_.advance(queue, control, path_, chunk_limit);
  // Homing names the position of an axis anew: its number steps, and the axis does not.
  const Steps steps = manual_.is_active() ? Steps::of_numbers : Steps::of_axes;
  move_by_hand(control);
  const auto fault = impossible_step(config_, constants_.cycle_s, axes_, path_.axes, steps);
  if (fault) stay_where_commanded(queue);
  axes_.follow(path_.axes);
  if (fault) return fault;
  if (limits == SoftLimits::not_guarded || manual_.is_active()) return std::nullopt;
  return passed_limit(config_, constants_.cycle_s, axes_, path_.axes);
}

void AxisMotion::move_by_hand(const motion::FeedControl& control) RT_SAFE {
  if (retrace_.is_on()) retrace_.lead(control, path_);
  if (retrace_.is_back() && !aside_.is_on()) retrace_.end();
  if (aside_.is_on()) {
    aside_.note_path(path_.axes);
    aside_.place(path_.axes);
  }
  if (manual_.is_active()) {
    manual_.advance(drives_.feedback(), path_.axes);
    if (!aside_.is_on()) return stand();
    aside_.follow(path_.axes);
    if (!manual_.is_active()) aside_.come_to_rest();
  }
  if (!aside_.is_on()) return;
  motion::Point point{};
  kinematics::forward(kinematics::with_changes(frame_, lengths_), axes_M(), point);
  for (std::size_t k = 0; k < point.size(); ++k) path_.point[k] = kinematics::Jet(point[k]);
}

void AxisMotion::leave_path() RT_SAFE {
  if (!aside_.is_on()) aside_.begin(axes_M());
}

void AxisMotion::change_length(const kinematics::LengthChange& change) RT_SAFE {
  const motion::Point held = aside_.is_on() ? aside_.path() : axes_M();
  motion::Point point_W{};
  kinematics::forward(kinematics::with_changes(frame_, lengths_), held, point_W);
  lengths_.note(change);
  motion::Point now{};
  kinematics::inverse(kinematics::with_changes(frame_, lengths_), point_W, now);
  retrace_.history().cut();
  if (!are_apart(held, now, frame_)) return;
  interpolator_.stand_at(now, frame_);
  leave_path();
  aside_.shift(now, config_);
}

PathStart AxisMotion::go_on_in(const kinematics::Transform& frame, const motion::Point& start_W)
    RT_SAFE {
  frame_ = frame;
  stand();
  if (lengths_.is_empty()) return PathStart::at_axes;
  motion::Point start{};
  kinematics::inverse(kinematics::with_changes(frame_, lengths_), start_W, start);
  for (int axis = 0; axis < axes_.count(); ++axis) {
    if (axes_.is_spindle(axis)) start[axis] = path_.axes[axis].value;  // it turns
  }
  if (!are_apart(axes_M(), start, frame_)) return PathStart::at_axes;
  interpolator_.stand_at(start, frame_);
  leave_path();
  aside_.shift(start, config_);
  return PathStart::elsewhere;
}

void AxisMotion::stop_by_hand() RT_SAFE {
  manual_.stop();
  retrace_.stop();
}

std::string_view AxisMotion::retrace(const motion::PathQueue& queue, const RetraceOrder& order)
    RT_SAFE {
  if (!retrace_.is_on()) {
    const std::optional<double> way = interpolator_.way_into_segment(queue);
    retrace_.leave_path(way ? &queue.segments.front() : nullptr, way.value_or(0.0), axes_M());
  }
  const std::string_view refused = retrace_.go(order);
  if (retrace_.is_back()) retrace_.end();
  return refused;
}

bool AxisMotion::go_back(double speed) RT_SAFE {
  if (aside_.is_at_path()) aside_.end();
  if (!aside_.is_on()) {
    retrace_.return_to_path();
    return retrace_.is_on();
  }
  AxisArray<double> to{};
  std::ranges::copy(aside_.turn_back(), to.begin());
  manual_.go(to, path_.axes, speed);
  return true;
}

// The axes stay where they were moved aside.
void AxisMotion::forget_path(motion::PathQueue& queue) RT_SAFE {
  interpolator_.drop_path(queue);
  if (is_off_path()) stand();
}

void AxisMotion::stay_where_commanded(motion::PathQueue& queue) RT_SAFE {
  for (std::size_t k = 0; k < motion::axes_max; ++k)
    path_.axes[k] = axes_.setpoint(static_cast<int>(k)).position;
  interpolator_.drop_path(queue);
  stand();
}

motion::Point AxisMotion::axes_M() const RT_SAFE {
  motion::Point point{};
  for (std::size_t k = 0; k < motion::axes_max; ++k) point[k] = path_.axes[k].value;
  return point;
}

double diameter_at_tool(const AxisMotion& motion) RT_SAFE {
  const int x = motion.config().geometry[0];
  return x < 0 ? 0.0 : 2.0 * std::abs(motion.path().point[x].value);
}

void AxisMotion::select_scheme(int scheme) RT_SAFE {
  schemes_.select(scheme);
  stand_in_scheme();
}

void AxisMotion::rest_in(const kinematics::Transform* frame) RT_SAFE {
  if (frame == nullptr || *frame == frame_) return;
  frame_ = *frame;
  stand();
}

void AxisMotion::stand_in_scheme() RT_SAFE {
  frame_ = {};
  frame_.scheme = schemes_.active();
  stand();
}

void AxisMotion::stand_with(int axis, double position) RT_SAFE {
  path_.axes[axis] = position;
  stand();
}

void AxisMotion::stand() RT_SAFE {
  aside_.end();
  retrace_.end();
  interpolator_.stand_at(axes_M(), frame_);
  frame_is_new_ = true;
}

bool AxisMotion::takes_new_frame() RT_SAFE {
  return std::exchange(frame_is_new_, false);
}

void AxisMotion::drop_path(motion::PathQueue& queue) RT_SAFE {
  interpolator_.drop_path(queue);
  interpolator_.stand_at(axes_M(), frame_);
}

void AxisMotion::break_off(motion::PathQueue& queue) RT_SAFE {
  manual_.break_off();
  stay_where_commanded(queue);
}

// An encoder counts from elsewhere than the control believed, or the axis was moved while its drive
// was off: the drive that is about to take it over holds it where it is. While the machine is off
// the setpoints go with the axes, so that what is shown, kept and touched off is true.
void AxisMotion::adopt_positions(Power machine) RT_SAFE {
  constexpr double increments_apart = 2.0;  // what the drive's own rounding cannot be
  if (drives_.is_ideal() || !is_standing()) return;
  bool adopted = false;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const AxisFeedback& drive = drives_.feedback(axis);
    const bool is_awaited = axes_.drive(axis).enabled && !drive.enabled;
    const bool is_off = machine == Power::off && !drive.enabled;
    if (!is_awaited && !is_off) continue;
    if (!drive.valid || !axes_.owns(axis) || axes_.is_spindle(axis)) continue;
    const double apart = std::abs(drive.position - path_.axes[axis].value);
    if (apart <= increments_apart * axes_.constants(axis).codes.resolution) continue;
    path_.axes[axis] = drive.position;
    axes_.place(axis, drive.position);
    adopted = true;
  }
  if (adopted) stand();
}

void AxisMotion::return_to_parking() RT_SAFE {
  const kinematics::Scheme* const scheme = schemes_.active();
  if (scheme == nullptr) return;
  for (const kinematics::Parking& parking : scheme->config().parking) {
    const int axis = parking.axis;
    if (!axes_.drive(axis).enabled || !axes_.owns(axis) || axes_.is_spindle(axis)) continue;
    manual_.go(axis, path_.axes[axis].value, parking.position);
  }
}

void AxisMotion::show(ChannelOutput& output) const RT_SAFE {
  output.moving = path_.state == motion::PathState::moving || moves_by_hand();
  output.feed_commanded = path_.feed_commanded;
  output.path_speed = path_.s_speed;
  output.aside = is_off_path();
  const bool is_within = path_.state == motion::PathState::moving ||
                         path_.state == motion::PathState::holding ||
                         path_.state == motion::PathState::starved;
  output.retrace = retrace_.state(is_within ? &path_.tag : nullptr);
  output.on_arc = path_.on_arc;
  output.point_W = path_.point;
  output.work_frame = frame_.frame;
  output.point_mode = frame_.mode;
  output.process.law = path_.process.kind;
  output.process.increments = path_.process.increments;
  output.process.stands = path_.state == motion::PathState::standing;
  output.process.interruption = interpolator_.interruption().lengths();
  output.process.interruptions = interpolator_.interruption().count();
  output.process.feed_mm_per_min = seconds_per_minute * path_.feed_commanded;
  for (int axis = 0; axis < axes_.count(); ++axis)
    output.drives[axis].reference = manual_.reference(axis);
}

}  // namespace stanok::channels
