// One simulated drive: power state, motor, watchdogs and injected faults behind its register
// blocks.
//
// Between targets the demand goes on with the target velocity, so a late target costs nothing at
// constant velocity. Knows no sockets: the Modbus server and the direct bus of the virtual clock
// use it alike. Deterministic; its random numbers come from a generator seeded with the unit id.
#pragma once

#include <cstdint>
#include <memory>
#include <random>

#include "base/rt_safe.h"
#include "drives/modbus/drive_registers.h"
#include "plant/drive/fault.h"
#include "plant/drive/power_state.h"
#include "plant/mechanics/measuring_system.h"
#include "plant/mechanics/motor.h"
#include "plant/mechanics/plant_config.h"

namespace stanok::plant {

// What the cutting process does to the drive.
struct ProcessLoad {
  double power_w = 0.0;
  double vibration_um = 0.0;
  double vibration_hz = 0.0;
};

// How the next request is answered.
enum class AnswerKind : std::uint8_t { normal, none, late, mangled, hang_up };

class SimulatedDrive {
 public:
  explicit SimulatedDrive(const SimulatedDriveConfig& config);

  void command(const drives::CommandBlock& block) RT_SAFE;
  void advance(double dt_s) RT_SAFE;
  [[nodiscard]] drives::StatusBlock status() RT_SAFE;

  // Decided anew for every request.
  [[nodiscard]] AnswerKind answer_kind() RT_SAFE;

  void inject(FaultKind kind) RT_SAFE;
  // `trip` is over when it has happened.
  [[nodiscard]] FaultKind fault() const RT_SAFE { return fault_; }

  void load(const ProcessLoad& load) RT_SAFE { load_ = load; }
  [[nodiscard]] const ProcessLoad& process_load() const RT_SAFE { return load_; }

  [[nodiscard]] const SimulatedDriveConfig& config() const RT_SAFE { return config_; }
  [[nodiscard]] const Motion& motion() const RT_SAFE { return motor_->motion(); }
  [[nodiscard]] drives::DriveState state() const RT_SAFE { return power_.state(); }

 private:
  [[nodiscard]] bool has_supply() const RT_SAFE;
  [[nodiscard]] bool is_braked() const RT_SAFE;
  [[nodiscard]] drives::StatusBlock measured_status() const RT_SAFE;
  [[nodiscard]] drives::StatusBlock arbitrary_status() RT_SAFE;
  [[nodiscard]] std::uint16_t inputs() const RT_SAFE;
  [[nodiscard]] double power_w() const RT_SAFE;
  [[nodiscard]] std::uint16_t status_word() const RT_SAFE;
  [[nodiscard]] std::uint16_t own_status_word() const RT_SAFE;
  void take_word(std::uint16_t word) RT_SAFE;
  void take_run_word(const drives::RunWords& words, std::uint16_t word) RT_SAFE;
  [[nodiscard]] double commanded_velocity() const RT_SAFE;
  [[nodiscard]] Demand demand() const RT_SAFE;
  [[nodiscard]] bool follows_velocity() const RT_SAFE;
  void turn(double dt_s) RT_SAFE;
  void move(double dt_s) RT_SAFE;
  void watch(double dt_s) RT_SAFE;
  void warm_up(double dt_s) RT_SAFE;

  SimulatedDriveConfig config_;
  std::unique_ptr<Motor> motor_;
  MeasuringSystem measuring_;
  PowerState power_;
  drives::CommandBlock command_;
  double temperature_c_;
  double turned_ = 0.0;  // following a velocity: where the demand is, deg
  double target_age_s_ = 0.0;
  double silence_s_ = 0.0;
  double following_error_s_ = 0.0;
  ProcessLoad load_;
  FaultKind fault_ = FaultKind::none;
  drives::StatusBlock stuck_status_;
  std::minstd_rand random_;
};

}  // namespace stanok::plant
