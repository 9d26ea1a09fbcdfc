// The life of a simulated drive between two exchanges.
#include "plant/simulated_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drives/cia402.h"
#include "plant/axis_plant.h"
#include "plant/servo_axis.h"
#include "plant/spindle_plant.h"

namespace stanok::plant {
namespace {

using drives::DriveState;

constexpr double full_turn_deg = 360.0;

// A demand without news stops to move after this time.
constexpr double bridged_s = 0.1;

// How far a drive is off that comes back elsewhere, in mm or deg.
constexpr double shift_elsewhere = 10.0;

constexpr unsigned one_lost_in = 5;

std::unique_ptr<Motor> motor_of(const SimulatedDriveConfig& config) {
  if (config.kind == DriveKind::spindle) {
    return std::make_unique<SpindlePlant>(config.spindle);
  }
  if (config.kind == DriveKind::velocity_axis) {
    return std::make_unique<ServoAxis>(config.velocity_loop, config.axis, config.start);
  }
  return std::make_unique<AxisPlant>(config.axis, config.start);
}

std::int32_t saturated_increments(double value, double scale) RT_SAFE {
  constexpr std::int32_t limit = std::numeric_limits<std::int32_t>::max();
  return drives::increments(value, scale).value_or(value < 0.0 ? -limit : limit);
}

template <class Register>
Register saturated(double value) RT_SAFE {
  constexpr double low = std::numeric_limits<Register>::min();
  constexpr double high = std::numeric_limits<Register>::max();
  return static_cast<Register>(std::clamp(std::round(value), low, high));
}

bool has_same_target(const drives::CommandBlock& a, const drives::CommandBlock& b) RT_SAFE {
  return a.target_position == b.target_position && a.target_velocity == b.target_velocity;
}

}  // namespace

SimulatedDrive::SimulatedDrive(const SimulatedDriveConfig& config)
    : config_(config),
      motor_(motor_of(config)),
      random_(static_cast<std::uint32_t>(config.registers.unit)) {}

// A target that is merely repeated is no news: its time runs on.
void SimulatedDrive::command(const drives::CommandBlock& block) RT_SAFE {
  const bool was_following = power_.state() == DriveState::operation_enabled;
  const bool followed_velocity = follows_velocity();
  power_.take_control_word(block.control_word);
  if (!was_following || !has_same_target(block, command_)) {
    target_age_s_ = 0.0;
  }
  command_ = block;
  if (!was_following || !followed_velocity) turned_ = motor_->motion().position;
  silence_s_ = 0.0;
}

void SimulatedDrive::advance(double dt_s) RT_SAFE {
  if (dt_s <= 0.0) {
    return;
  }
  target_age_s_ += dt_s;
  silence_s_ += dt_s;
  if (follows_velocity()) turn(dt_s);
  move(dt_s);
  watch(dt_s);
}

void SimulatedDrive::move(double dt_s) RT_SAFE {
  if (is_braked()) {
    motor_->hold_by_brake(dt_s);
  } else if (power_.state() == DriveState::operation_enabled) {
    motor_->follow(demand(), dt_s);
  } else if (power_.is_powered()) {
    motor_->ramp_down(dt_s);
  } else {
    motor_->coast(dt_s);
  }
}

void SimulatedDrive::watch(double dt_s) RT_SAFE {
  if (motor_->motion().velocity == 0.0) {
    power_.notice_standstill();
  }
  if (power_.state() != DriveState::operation_enabled) {
    following_error_s_ = 0.0;
    return;
  }
  const double error = follows_velocity() ? 0.0 : std::fabs(motor_->following_error(demand()));
  following_error_s_ = error > config_.watch.following_error_max ? following_error_s_ + dt_s : 0.0;
  if (following_error_s_ > config_.watch.following_error_time_s) {
    power_.trip(drives::fault_code::following_error);
  }
  if (silence_s_ > config_.watch.watchdog_s) {
    power_.trip(drives::fault_code::communication_lost);
  }
}

bool SimulatedDrive::follows_velocity() const RT_SAFE {
  return config_.kind != DriveKind::spindle &&
         (command_.control_word & drives::control::follow_velocity) != 0;
}

// The demand goes on with the velocity; demand and motor are counted within one turn.
void SimulatedDrive::turn(double dt_s) RT_SAFE {
  if (power_.state() != DriveState::operation_enabled) {
    turned_ = motor_->motion().position;
    return;
  }
  turned_ += command_.target_velocity / config_.registers.velocity_scale * dt_s;
  const double turns = full_turn_deg * std::floor(turned_ / full_turn_deg);
  if (turns == 0.0) return;
  turned_ -= turns;
  motor_->shift_position(-turns);
}

Demand SimulatedDrive::demand() const RT_SAFE {
  if (follows_velocity()) {
    return {.position = turned_,
            .velocity = command_.target_velocity / config_.registers.velocity_scale};
  }
  const double velocity = command_.target_velocity / config_.registers.velocity_scale;
  const double position = command_.target_position / config_.registers.position_scale;
  const bool is_bridged = target_age_s_ <= bridged_s;
  return {.position = position + velocity * std::min(target_age_s_, bridged_s),
          .velocity = is_bridged || config_.kind == DriveKind::spindle ? velocity : 0.0};
}

bool SimulatedDrive::has_supply() const RT_SAFE {
  return fault_ != FaultKind::off && fault_ != FaultKind::elsewhere;
}

// The brake needs power to open; a drive in fault lets it fall.
bool SimulatedDrive::is_braked() const RT_SAFE {
  const bool is_commanded = (command_.control_word & drives::control::close_brake) != 0;
  return is_commanded || !has_supply() || power_.state() == DriveState::fault;
}

drives::StatusBlock SimulatedDrive::status() RT_SAFE {
  if (fault_ == FaultKind::stuck) {
    return stuck_status_;
  }
  if (fault_ == FaultKind::garbage) {
    drives::StatusRegisters registers{};
    for (std::uint16_t& value : registers) {
      value = static_cast<std::uint16_t>(random_() & 0xFFFFU);
    }
    return drives::status_block(registers);
  }
  return measured_status();
}

drives::StatusBlock SimulatedDrive::measured_status() const RT_SAFE {
  const Motion& motion = motor_->motion();
  const bool is_following = power_.state() == DriveState::operation_enabled;
  const double following_error =
      is_following && !follows_velocity() ? motor_->following_error(demand()) : 0.0;
  const double power_w = (power_.is_powered() ? motor_->power_w() : 0.0) + load_.power_w;
  const double position_scale = config_.registers.position_scale;
  return {
      .status_word = status_word(),
      .position = saturated_increments(motion.position, position_scale),
      .velocity = saturated_increments(motion.velocity, config_.registers.velocity_scale),
      .following_error = saturated_increments(following_error, position_scale),
      .power_w = saturated<std::int16_t>(power_w),
      .vibration = saturated<std::uint16_t>(load_.vibration_um * 10.0),
      .vibration_frequency = saturated<std::uint16_t>(load_.vibration_hz * 10.0),
      .fault_code = power_.fault_code(),
      .heartbeat_echo = command_.heartbeat,
  };
}

std::uint16_t SimulatedDrive::status_word() const RT_SAFE {
  namespace status = drives::status;
  std::uint16_t word = drives::state_bits(power_.state());
  word |= status::remote | status::voltage_enabled | status::referenced;
  if (power_.state() == DriveState::operation_enabled) {
    word |= status::follows_target;
  }
  if (following_error_s_ > 0.0) {
    word |= status::following_error;
  }
  if (is_braked()) {
    word |= status::brake_closed;
  }
  return word;
}

AnswerKind SimulatedDrive::answer_kind() RT_SAFE {
  switch (fault_) {
    case FaultKind::off:
    case FaultKind::elsewhere:
      return AnswerKind::none;
    case FaultKind::slow:
      return AnswerKind::late;
    case FaultKind::mangled:
      return AnswerKind::mangled;
    case FaultKind::hang_up:
      return AnswerKind::hang_up;
    case FaultKind::intermittent:
      return random_() % one_lost_in == 0 ? AnswerKind::none : AnswerKind::normal;
    default:
      return AnswerKind::normal;
  }
}

void SimulatedDrive::inject(FaultKind kind) RT_SAFE {
  if (kind == FaultKind::trip) {
    power_.trip(drives::fault_code::over_current);
    kind = FaultKind::none;
  }
  if (kind == FaultKind::stuck && fault_ != FaultKind::stuck) {
    stuck_status_ = measured_status();
  }
  const bool had_supply = has_supply();
  fault_ = kind;
  if (had_supply && !has_supply()) {
    power_.restart();
  }
  if (had_supply && kind == FaultKind::elsewhere) {
    motor_->shift_position(shift_elsewhere);
  }
}

}  // namespace stanok::plant
