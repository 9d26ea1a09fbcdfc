// The life of a simulated drive between two exchanges.
#include "plant/drive/simulated_drive.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "drives/cia402.h"
#include "plant/mechanics/axis_plant.h"
#include "plant/mechanics/servo_axis.h"
#include "plant/mechanics/spindle_plant.h"

namespace stanok::plant {
namespace {

using drives::DriveState;

// How far a drive is off that comes back elsewhere, in mm or deg.
constexpr double shift_elsewhere = 10.0;

constexpr unsigned one_lost_in = 5;

std::unique_ptr<Motor> motor_of(const SimulatedDriveConfig& config) {
  if (config.kind == PlantKind::spindle) {
    return std::make_unique<SpindlePlant>(config.spindle);
  }
  if (config.kind == PlantKind::velocity_axis) {
    return std::make_unique<ServoAxis>(config.velocity_loop, config.axis, config.start);
  }
  return std::make_unique<AxisPlant>(config.axis, config.start);
}

bool has_same_target(const drives::CommandBlock& a, const drives::CommandBlock& b) RT_SAFE {
  return a.target_position == b.target_position && a.target_velocity == b.target_velocity;
}

}  // namespace

SimulatedDrive::SimulatedDrive(const SimulatedDriveConfig& config)
    : config_(config),
      motor_(motor_of(config)),
      measuring_(config.reference, motor_->motion().position),
      temperature_c_(config.thermal.ambient_c),
      random_(static_cast<std::uint32_t>(config.registers.unit)) {}

// A target that is merely repeated is no news: its time runs on.
void SimulatedDrive::command(const drives::CommandBlock& block) RT_SAFE {
  const bool was_following = power_.state() == DriveState::operation_enabled;
  const bool followed_velocity = follows_velocity();
  take_word(block.control_word);
  if (!was_following || !has_same_target(block, command_)) {
    target_age_s_ = 0.0;
  }
  command_ = block;
  if (!was_following || !followed_velocity) turned_ = motor_->motion().position;
  silence_s_ = 0.0;
}

void SimulatedDrive::take_word(std::uint16_t word) RT_SAFE {
  const auto& words = config_.registers.words;
  words ? take_run_word(*words, word) : power_.take_control_word(word);
}

// An inverter behind the same power state: it runs, or stops on its ramp.
void SimulatedDrive::take_run_word(const drives::RunWords& words, std::uint16_t word) RT_SAFE {
  namespace control = drives::control;
  constexpr std::uint16_t shutdown = control::enable_voltage | control::no_quick_stop;
  constexpr std::uint16_t run = shutdown | control::switch_on | control::enable_operation;
  if (word == words.fault_reset) {
    power_.take_control_word(control::fault_reset);
  } else if (!drives::is_run_word(words, word)) {
    power_.take_control_word(control::enable_voltage);
  } else {
    power_.take_control_word(shutdown);
    power_.take_control_word(run);
  }
}

void SimulatedDrive::advance(double dt_s) RT_SAFE {
  if (dt_s <= 0.0) {
    return;
  }
  target_age_s_ += dt_s;
  silence_s_ += dt_s;
  if (follows_velocity()) turn(dt_s);
  move(dt_s);
  measuring_.take(motor_->motion().position);
  watch(dt_s);
  warm_up(dt_s);
}

void SimulatedDrive::warm_up(double dt_s) RT_SAFE {
  const ThermalConfig& thermal = config_.thermal;
  const double end_c = thermal.ambient_c + thermal.heating_k_per_w * std::fabs(power_w());
  temperature_c_ -= (end_c - temperature_c_) * std::expm1(-dt_s / thermal.time_constant_s);
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
  const int watchdog_ms = config_.registers.watchdog_ms;
  if (silence_s_ > (watchdog_ms > 0 ? watchdog_ms * 1e-3 : config_.watch.watchdog_s)) {
    power_.trip(drives::fault_code::communication_lost);
  }
}

bool SimulatedDrive::follows_velocity() const RT_SAFE {
  return config_.kind != PlantKind::spindle &&
         (command_.control_word & config_.registers.map.bits.follow_velocity) != 0;
}

// The demand goes on with the velocity; demand and motor are counted within one turn.
void SimulatedDrive::turn(double dt_s) RT_SAFE {
  if (power_.state() != DriveState::operation_enabled) {
    turned_ = motor_->motion().position;
    return;
  }
  turned_ += commanded_velocity() * dt_s;
  const double turns = full_turn_deg * std::floor(turned_ / full_turn_deg);
  if (turns == 0.0) return;
  turned_ -= turns;
  motor_->shift_position(-turns);
  measuring_.place(motor_->motion().position);
}

// A contactor knows one speed only.
double SimulatedDrive::commanded_velocity() const RT_SAFE {
  const drives::AxisDriveConfig& registers = config_.registers;
  const bool has_speed = registers.map.target_velocity.exists();
  const double velocity = has_speed ? registers.map.target_velocity.value(command_.target_velocity)
                                    : config_.spindle.speed_max;
  const bool is_reverse = registers.words && command_.control_word == registers.words->run_reverse;
  return is_reverse ? -velocity : velocity;
}

Demand SimulatedDrive::demand() const RT_SAFE {
  const drives::RegisterMap& map = config_.registers.map;
  const double velocity = commanded_velocity();
  if (follows_velocity()) {
    return {.position = turned_, .velocity = velocity};
  }
  const double position = map.target_position.value(command_.target_position) + measuring_.zero();
  const bool is_bridged = target_age_s_ <= drives::bridged_s;
  return {.position = position + velocity * std::min(target_age_s_, drives::bridged_s),
          .velocity = is_bridged || config_.kind == PlantKind::spindle ? velocity : 0.0};
}

bool SimulatedDrive::has_supply() const RT_SAFE {
  return fault_ != FaultKind::off && fault_ != FaultKind::elsewhere;
}

// The brake needs power to open; a drive in fault lets it fall.
bool SimulatedDrive::is_braked() const RT_SAFE {
  if (fault_ == FaultKind::jammed) return true;
  const bool is_commanded = (command_.control_word & config_.registers.map.bits.close_brake) != 0;
  return is_commanded || !has_supply() || power_.state() == DriveState::fault;
}

drives::StatusBlock SimulatedDrive::status() RT_SAFE {
  if (fault_ == FaultKind::stuck) {
    return stuck_status_;
  }
  if (fault_ == FaultKind::garbage) {
    return arbitrary_status();
  }
  drives::StatusBlock status = measured_status();
  if (fault_ == FaultKind::frozen) {
    status.position = stuck_status_.position;
    status.following_error = 0;
  }
  return status;
}

drives::StatusBlock SimulatedDrive::measured_status() const RT_SAFE {
  const Motion& motion = motor_->motion();
  const bool is_following = power_.state() == DriveState::operation_enabled;
  const double following_error =
      is_following && !follows_velocity() ? motor_->following_error(demand()) : 0.0;
  const drives::RegisterMap& map = config_.registers.map;
  const bool is_magnitude = config_.registers.words && config_.registers.words->run_reverse;
  return {
      .status_word = status_word(),
      .position = map.position.saturated_increments(motion.position - measuring_.zero()),
      .velocity = map.velocity.saturated_increments(is_magnitude ? std::fabs(motion.velocity)
                                                                 : motion.velocity),
      .following_error = map.following_error.saturated_increments(following_error),
      .power = map.power.saturated_increments(power_w()),
      .vibration = map.vibration.saturated_increments(load_.vibration_um),
      .vibration_frequency = map.vibration_frequency.saturated_increments(load_.vibration_hz),
      .fault_code = power_.fault_code(),
      .heartbeat_echo = command_.heartbeat,
      .inputs = inputs(),
      .index_position = map.index_position.saturated_increments(measuring_.index_position()),
      .index_count = measuring_.index_count(),
      .temperature = map.temperature.saturated_increments(temperature_c_),
  };
}

drives::StatusBlock SimulatedDrive::arbitrary_status() RT_SAFE {
  const auto word = [this]() RT_SAFE { return static_cast<std::uint16_t>(random_() & 0xFFFFU); };
  const auto value = [this]() RT_SAFE { return static_cast<std::int32_t>(random_()); };
  return {.status_word = word(),
          .position = value(),
          .velocity = value(),
          .following_error = value(),
          .power = word(),
          .vibration = word(),
          .vibration_frequency = word(),
          .fault_code = word(),
          .heartbeat_echo = word(),
          .inputs = word(),
          .index_position = value(),
          .index_count = word(),
          .temperature = word()};
}

double SimulatedDrive::power_w() const RT_SAFE {
  return (power_.is_powered() ? motor_->power_w() : 0.0) + load_.power_w;
}

std::uint16_t SimulatedDrive::inputs() const RT_SAFE {
  const drives::DriveBits& bits = config_.registers.map.bits;
  std::uint16_t word = 0;
  if (measuring_.on_limit_negative()) word |= bits.limit_negative;
  if (measuring_.on_limit_positive()) word |= bits.limit_positive;
  if (measuring_.on_home_switch()) word |= bits.home_switch;
  return word;
}

std::uint16_t SimulatedDrive::own_status_word() const RT_SAFE {
  const drives::RunWords& words = *config_.registers.words;
  if (power_.state() == DriveState::fault) return words.fault.value;
  return power_.is_powered() ? words.running.value : std::uint16_t{0};
}

std::uint16_t SimulatedDrive::status_word() const RT_SAFE {
  if (config_.registers.words) return own_status_word();
  namespace status = drives::status;
  std::uint16_t word = drives::state_bits(power_.state());
  const drives::DriveBits& bits = config_.registers.map.bits;
  word |= status::remote | status::voltage_enabled;
  if (measuring_.is_absolute()) {
    word |= bits.referenced;
  }
  if (power_.state() == DriveState::operation_enabled) {
    word |= status::follows_target;
  }
  if (following_error_s_ > 0.0) {
    word |= status::following_error;
  }
  if (is_braked()) {
    word |= bits.brake_closed;
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
  if ((kind == FaultKind::stuck || kind == FaultKind::frozen) && fault_ != kind) {
    stuck_status_ = measured_status();
  }
  const bool had_supply = has_supply();
  fault_ = kind;
  if (had_supply && !has_supply()) {
    power_.restart();
  }
  if (!had_supply && has_supply()) {
    measuring_.restart();
  }
  if (had_supply && kind == FaultKind::elsewhere) {
    motor_->shift_position(shift_elsewhere);
    measuring_.place(motor_->motion().position);
  }
}

}  // namespace stanok::plant
