#include "channels/axes/spindle_group.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/units.h"
#include "channels/axes/spindle_motion.h"

namespace stanok::channels {
namespace {

constexpr double standstill_deg_per_s = 0.5;  // below, a drive that follows velocity 0 stands

// A position that a bus brings more seldom than once a cycle stays the same between. It counts as
// told again when the spindle does not turn so far in a cycle, or after so long.
constexpr double unseen_turns = 1.0 / 2000;
constexpr double unseen_s = 0.05;

}  // namespace

SpindleGroup::SpindleGroup(const ChannelConstants& constants, AxisGroup& axes,
                           const DriveGuard& drives, AxisMotion& motion)
    : constants_(constants), axes_(axes), drives_(drives), motion_(motion) {
  for (int s = 0; s < constants.spindle_count; ++s) spindles_[s] = Spindle(constants.spindles[s]);
}

std::span<Spindle> SpindleGroup::spindles() RT_SAFE {
  return {spindles_.begin(), spindles_.begin() + constants_.spindle_count};
}

int SpindleGroup::index_of(int id) const RT_SAFE {
  for (int s = 0; s < constants_.spindle_count; ++s) {
    if (id == 0 || constants_.spindles[s].id == id) return s;
  }
  return -1;
}

Spindle& SpindleGroup::spindle(int id) RT_SAFE {
  return spindles_[index_of(id)];
}

bool SpindleGroup::means(int id, const Spindle& spindle) const RT_SAFE {
  return id == spindle.id() || (id == 0 && &spindle == spindles_.data());
}

void SpindleGroup::command(const lang::SpindleCommand& command) RT_SAFE {
  for (Spindle& spindle : spindles_) {
    if (command.spindle < 0 || means(command.spindle, spindle)) spindle.command(command);
  }
  follow_process();
}

void SpindleGroup::command(const lang::CuttingSpeedMode& mode) RT_SAFE {
  for (Spindle& spindle : spindles_) {
    if (means(mode.spindle, spindle)) spindle.command(mode);
  }
  follow_process();
}

void SpindleGroup::stop() RT_SAFE {
  for (Spindle& spindle : spindles_) spindle.stop();
}

void SpindleGroup::rest() RT_SAFE {
  for (Spindle& spindle : spindles_) spindle.rest();
}

void SpindleGroup::turn_again() RT_SAFE {
  for (Spindle& spindle : spindles_) spindle.turn_again();
}

void SpindleGroup::set_override(double factor) RT_SAFE {
  for (Spindle& spindle : spindles_) spindle.set_override(factor);
}

bool SpindleGroup::any_turns() const RT_SAFE {
  return std::any_of(spindles_.begin(), spindles_.end(),
                     [](const Spindle& spindle) RT_SAFE { return spindle.speed() != 0.0; });
}

bool SpindleGroup::are_settled() const RT_SAFE {
  return std::all_of(spindles_.begin(), spindles_.end(),
                     [](const Spindle& spindle) RT_SAFE { return spindle.is_settled(); });
}

// The master spindle takes over what the present segment of the path asks for, and behind a law
// what its last increment asked for, which may have no path any more; it keeps that until it is
// told another speed. All spindles that hold a cutting speed follow the diameter.
void SpindleGroup::follow_process() RT_SAFE {
  const motion::InterpolatorOutput& path = motion_.path();
  const AskedSpeed behind{path.process.speed, path.process.spindle_speed_behind};
  if (path.state == motion::PathState::moving) {
    if (path.process.spindle_speed <= 0.0) ask_speed(speed_behind_law_);
    ask_speed({path.process.speed, path.process.spindle_speed});
    speed_behind_law_ = behind;
  } else if (path.chain_ended) {
    ask_speed(behind);
    speed_behind_law_ = {};
  }
  const double diameter = diameter_at_tool(motion_);
  for (Spindle& spindle : spindles_) spindle.follow_diameter(diameter);
}

void SpindleGroup::ask_speed(const AskedSpeed& speed) RT_SAFE {
  if (speed.value <= 0.0) return;
  if (speed.unit == motion::LawSpeed::rev_per_min) spindles_[0].run_at(speed.value);
  if (speed.unit == motion::LawSpeed::m_per_min) spindles_[0].cut_at(speed.value);
}

// The measured angle belongs to the instant at which the cycle begins; the setpoints, to its end.
void SpindleGroup::observe() RT_SAFE {
  const bool angles_are_old = std::exchange(angles_are_old_, false);
  for (std::size_t s = 0; s < spindles().size(); ++s) {
    motion::SpindleObserver& observer = observers_[s];
    observer.advance(constants_.cycle_s, command_of(spindles_[s]));
    const auto angle_deg = measured_angle(s);
    if (angle_deg && !(angles_are_old && is_told_by_drive(s))) observer.observe(*angle_deg);
    motion_.see_spindle(s, coming_motion(spindles_[s], observer, constants_.cycle_s));
  }
}

bool SpindleGroup::is_told_by_drive(std::size_t spindle) const RT_SAFE {
  return constants_.spindle_axis[spindle] >= 0 && !drives_.is_ideal();
}

// That of the drive where the spindle is an axis with a drive that answers; else that of the
// commanded spindle, in whole counts of its encoder. Nothing: no news in this cycle.
std::optional<double> SpindleGroup::measured_angle(std::size_t spindle) RT_SAFE {
  const SpindleConfig& config = constants_.spindles[spindle];
  const int axis = constants_.spindle_axis[spindle];
  if (!is_told_by_drive(spindle)) {
    const double angle = axis < 0 ? spindles_[spindle].angle_deg() : axes_.setpoint(axis).position;
    return in_counts(angle, config.encoder_pulses);
  }
  const AxisFeedback& drive = drives_.feedback(axis);
  if (!drive.valid) return std::nullopt;
  EncoderNews& news = encoder_news_[spindle];
  const bool is_same = drive.position == news.angle_deg;
  const double turns = std::abs(observers_[spindle].now().speed) * constants_.cycle_s;
  if (is_same && turns > unseen_turns && news.age_s < unseen_s) {
    news.age_s += constants_.cycle_s;
    return std::nullopt;
  }
  news = {drive.position, 0.0};
  return news.angle_deg;
}

void SpindleGroup::turn() RT_SAFE {
  for (std::size_t s = 0; s < spindles().size(); ++s) {
    const double speed_before = spindles_[s].speed();
    spindles_[s].advance(constants_.cycle_s);
    const int axis = constants_.spindle_axis[s];
    if (axes_.is_spindle(axis)) axes_.turn(axis, spindles_[s], speed_before);
  }
}

std::optional<double> SpindleGroup::speed(int id) const RT_SAFE {
  const int s = index_of(id);
  if (s < 0) return std::nullopt;
  return spindles_[s].speed();
}

int SpindleGroup::axis_of(int id) const RT_SAFE {
  const int s = index_of(id);
  return s < 0 ? -1 : constants_.spindle_axis[s];
}

void SpindleGroup::stop(int id) RT_SAFE {
  spindle(id).stop();
}

bool SpindleGroup::stands(int id) const RT_SAFE {
  return speed(id) == 0.0 &&
         std::fabs(drives_.feedback(axis_of(id)).velocity) < standstill_deg_per_s;
}

void SpindleGroup::close_position_loop(int id) RT_SAFE {
  const int axis = axis_of(id);
  if (!axes_.is_spindle(axis)) return;
  const double angle =
      drives_.is_ideal() ? spindle(id).angle_deg() : drives_.feedback(axis).position;
  axes_.become_axis(axis, angle);
  motion_.stand_with(axis, angle);
}

bool SpindleGroup::position_loop_is_closed(int id) const RT_SAFE {
  const int axis = axis_of(id);
  if (axis < 0 || axes_.is_spindle(axis)) return false;
  return axes_.drive(axis).enabled && drives_.feedback(axis).enabled;
}

void SpindleGroup::open_position_loop(int id) RT_SAFE {
  const int axis = axis_of(id);
  if (axis < 0 || axes_.is_spindle(axis)) return;
  Spindle& opened = spindle(id);
  opened.stop();
  opened.set_angle(motion_.path().axes[axis].value);
  axes_.become_spindle(axis, opened.angle_deg());
}

void SpindleGroup::open_position_loops() RT_SAFE {
  for (const Spindle& spindle : spindles()) open_position_loop(spindle.id());
}

void SpindleGroup::show(ProcessOutput& output) const RT_SAFE {
  constexpr double mm_per_m = 1000.0;
  output.spindle_rev_per_min = master().speed();
  const double speed = std::abs(output.spindle_rev_per_min);
  output.feed_mm_per_rev = speed > 0.0 ? output.feed_mm_per_min / speed : 0.0;
  output.cutting_speed_m_per_min = std::numbers::pi * diameter_at_tool(motion_) * speed / mm_per_m;
  for (int s = 0; s < constants_.spindle_count; ++s)
    output.spindles[s] = {.id = spindles_[s].id(),
                          .rev_per_min = spindles_[s].speed(),
                          .target_rev_per_min = spindles_[s].target()};
}

}  // namespace stanok::channels
