// Power, position regulators and the watch over the drives of one channel.
#include <algorithm>
#include <cmath>

#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

// "the drive of axis X", "the drives of axes X, Y"
struct AxisNames {
  FixedText<64> list;
  int count = 0;

  void add(std::string_view name) RT_SAFE { list.append(count++ == 0 ? "" : ", ").append(name); }
  [[nodiscard]] FixedText<128> sentence(std::string_view of_one, std::string_view of_many) const
      RT_SAFE {
    FixedText<128> text(count == 1 ? "the drive of axis " : "the drives of axes ");
    text.append(list.view()).append(count == 1 ? of_one : of_many);
    return text;
  }
};

}  // namespace

void Channel::power(bool on) RT_SAFE {
  powered_ = on;
  const kinematics::Scheme* scheme = find_scheme(scheme_);
  for (int k = 0; k < figures_.axis_count; ++k) {
    if (!owns(k)) continue;
    const bool free = on && (scheme == nullptr || scheme->takes_part(k));
    drives_[static_cast<std::size_t>(k)] = {.enabled = free, .brake_closed = !free};
  }
}

void Channel::set_axes(lang::AxisSet axes, bool free) RT_SAFE {
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if ((axes & owned_) >> k & 1U) drives_[k] = {.enabled = free, .brake_closed = !free};
  }
}

void Channel::fault(std::string_view code, std::string_view text) RT_SAFE {
  if (alarm_stays_) return;
  raise_alarm(code, text, path_.tag);
  begin_reset();
  alarm_stays_ = true;
  power_off_wanted_ = true;
}

void Channel::stop_in_emergency() RT_SAFE {
  constexpr std::string_view text = "emergency stop by an operator";
  if (!alarm_stays_) return fault("A1001", text);
  ++generation_;
  record_alarm("A1001", text, path_.tag);
  power_off_wanted_ = true;
}

void Channel::watch_drives(std::span<const AxisFeedback> feedback) RT_SAFE {
  drives_are_ideal_ = feedback.empty();
  if (drives_are_ideal_) return;
  drives_answer_ = true;
  drives_ready_ = true;
  AxisNames silent;
  AxisNames faulty;
  AxisNames stray;
  AxisNames released;
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    AxisFeedback drive = feedback[static_cast<std::size_t>(figures_.machine_axis[i])];
    drive.valid = drive.valid && std::isfinite(drive.position) && std::isfinite(drive.velocity);
    drives_answer_ = drives_answer_ && drive.valid;
    feedback_[i] = drive;
    feedback_[i].referenced = drive.valid && drive.referenced;
    feedback_[i].enabled = drive.valid && drive.enabled;
    if (!drives_[i].enabled || !owns(k)) {
      drive_was_ready_[i] = false;
      continue;
    }
    drives_ready_ = drives_ready_ && drive.valid && drive.enabled;
    if (drive_was_ready_[i] && !drive.valid) silent.add(figures_.axes[i].name.view());
    if (drive_was_ready_[i] && drive.fault) faulty.add(figures_.axes[i].name.view());
    if (drive_was_ready_[i] && drive.strays) stray.add(figures_.axes[i].name.view());
    if (drive_was_ready_[i] && drive.valid && !drive.enabled && !drive.fault)
      released.add(figures_.axes[i].name.view());
    drive_was_ready_[i] = drive_was_ready_[i] || (drive.valid && drive.enabled);
  }
  watch_limit_switches();
  adopt_positions();
  if (silent.count > 0)
    fault("A3001", silent.sentence(" does not answer", " do not answer").view());
  if (faulty.count > 0)
    fault("A3002", faulty.sentence(" reports a fault", " report faults").view());
  if (stray.count > 0)
    fault("A3003", stray
                       .sentence(" does not follow its set-points, or does not tell where it is",
                                 " do not follow their set-points, or do not tell where they are")
                       .view());
  if (released.count > 0)
    fault("A3004",
          released.sentence(" has switched itself off", " have switched themselves off").view());
}

// A drive that is about to take its axis over shall hold it where it is: an encoder counts from
// elsewhere than the control believed, or the axis was moved while it was off. While the machine is
// off the set-points go with the axes, so that what is shown, kept and touched off is true.
void Channel::adopt_positions() RT_SAFE {
  constexpr double discretes_apart = 2.0;  // what the drive's own rounding cannot be
  if (running_ || !is_standing()) return;
  bool adopted = false;
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const AxisFeedback& drive = feedback_[i];
    const bool is_free = (drives_[i].enabled || !powered_) && owns(k) && !drive.enabled;
    const double apart = std::abs(drive.position - path_.axes[i].value);
    if (!is_free || !drive.valid || is_spindle_now(k)) continue;
    if (apart <= discretes_apart * figures_.axes[i].codes.resolution) continue;
    path_.axes[i] = drive.position;
    setpoints_[i].position = drive.position;
    setpoints_[i].position_code = motion::position_code(drive.position, figures_.axes[i].codes);
    adopted = true;
  }
  if (adopted) stand_in_frame();
}

void Channel::make_regulators() {
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const AxisFigures& axis = figures_.axes[i];
    if (axis.regulator.feedback == FeedbackPlace::cycle)
      regulators_[i] = motion::PositionRegulator(axis.regulator.gains, axis.demand_max);
  }
}

// An axis that its drive does not hold moves as it likes: its regulator begins anew when the drive
// takes it over.
void Channel::demand_velocities() RT_SAFE {
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    AxisSetpoint& setpoint = setpoints_[i];
    if (figures_.axes[i].regulator.feedback == FeedbackPlace::drive) {
      setpoint.velocity_demand = setpoint.velocity;
    } else if (drives_[i].enabled && feedback_[i].enabled) {
      const double held_s = std::max(figures_.axes[i].regulator.demand_held_s, figures_.cycle_s);
      const motion::SetpointRates coming = motion::coming_rates(path_.axes[i], held_s);
      setpoint.velocity_demand =
          regulators_[i].demand(feedback_[i].setpoint - feedback_[i].position, coming);
    } else {
      regulators_[i].reset();
      setpoint.velocity_demand = 0.0;
    }
  }
}

}  // namespace stanok::channels
