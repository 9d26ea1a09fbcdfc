// Parameters of the simulated drives and spindles, with defaults of a medium-sized machine tool.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/units.h"
#include "drives/bus_config.h"

namespace stanok::plant {

// A feed axis: x'' = w^2 (p - x) + 2 d w (k v - x'), with demand p, v
// (docs/integrator/drives.md#plant).
struct AxisPlantConfig {
  double bandwidth_hz = 40.0;            // w = 2 pi bandwidth
  double damping = 0.8;                  // d
  double velocity_feed_forward = 1.0;    // k; 1: no following error at constant velocity
  double velocity_max = 0.0;             // mm/s or deg/s; 0: unlimited
  double quick_stop_deceleration = 4e3;  // mm/s2 or deg/s2
  double brake_deceleration = 2e4;       // mm/s2 or deg/s2
  double coasting_time_s = 0.3;          // velocity falls by e in this time without power
  double power_idle_w = 20.0;            // of the electronics, when switched on
  double friction_w_per_unit = 0.2;      // W per mm/s or deg/s
  double dry_friction = 0.0;             // mm/s2 or deg/s2 by which it brakes
  double inertia_w_per_unit = 5e-5;      // W per (mm/s)(mm/s2): mass in t, or its rotary like
};

// A feed axis whose position loop is closed in the cycle: v'' = w^2 (U - v) - 2 d w v' for the
// motor, and a load on a spring that swings at the resonance (docs/integrator/drives.md#plant).
struct VelocityLoopConfig {
  double bandwidth_hz = 150.0;  // w = 2 pi bandwidth
  double damping = 0.7;         // d
  double resonance_hz = 80.0;   // 0: the load sits on the motor
  double resonance_damping = 0.1;
};

struct SpindlePlantConfig {
  double speed_max = 18000.0;      // rev/min
  double acceleration = 9000.0;    // rev/min/s; 0: at once
  double coasting_time_s = 4.0;    // speed falls by e in this time without power
  double power_idle_w = 600.0;     // at speed_max; half Coulomb, half viscous friction
  double acceleration_w = 5000.0;  // at speed_max and full acceleration
};

// Encoder, index pulses and switches of a feed axis, in positions of the machine, mm or deg.
struct ReferenceConfig {
  static constexpr double none = std::numeric_limits<double>::infinity();

  bool absolute_encoder = true;    // else it counts from where it is switched on
  double home_switch_from = none;  // active from here to there
  double home_switch_to = -none;
  double limit_negative = -none;  // active at and below
  double limit_positive = none;   // active at and above
  double index_position = 0.0;    // of one of the pulses
  double index_pitch = 0.0;       // from one to the next; 0: there are none
  double backlash = 0.0;  // play between motor, with the encoder, and load, with the switches
};

// Body of the motor: T' = (T0 + heating |P| - T) / time constant.
struct ThermalConfig {
  double ambient_c = 22.0;        // T0, and the temperature at power-on
  double heating_k_per_w = 0.03;  // steady rise by electrical power
  double time_constant_s = 900.0;
};

// What the drive itself watches over; its watchdog is that of the machine file where it says one.
struct WatchConfig {
  double watchdog_s = 0.5;              // quick stop and fault when enabled and nothing is written
  double following_error_max = 0.5;     // mm or deg
  double following_error_time_s = 0.1;  // over the limit for this long: fault
};

// A velocity_axis is an axis that follows the target velocity.
enum class PlantKind : std::uint8_t { axis, velocity_axis, spindle };

// One simulated drive: its registers, what moves, and what it watches over.
struct SimulatedDriveConfig {
  drives::AxisDriveConfig registers{};
  PlantKind kind = PlantKind::axis;
  double start = 0.0;  // position at power-on
  AxisPlantConfig axis{};
  VelocityLoopConfig velocity_loop{};  // velocity_axis
  SpindlePlantConfig spindle{};
  ReferenceConfig reference{};
  ThermalConfig thermal{};
  WatchConfig watch{};
};

// Unit ids of spindle drives: this plus the spindle's number.
inline constexpr int spindle_unit_base = 200;
// Unit id of the panel for fault injection, unless a drive has it.
inline constexpr int fault_panel_unit = 247;

// Seconds of silence after which a drive trips whose watchdog the machine file does not say: twice
// the time-out of its bus, which must end first (docs/integrator/drives.md), and never less than
// half a second.
[[nodiscard]] double watchdog_of(const drives::BusConfig& bus);

// Simulated drives of all axes of a bus, starting at `start` (empty: all at 0).
[[nodiscard]] std::vector<SimulatedDriveConfig> drives_of(const drives::BusConfig& bus,
                                                          std::span<const double> start);

// A spindle drive of its own making: velocity scale 1 (increments/s are rev/min), position scale
// 100 per degree of the turn.
[[nodiscard]] SimulatedDriveConfig spindle_drive(int id, const SpindlePlantConfig& config);

}  // namespace stanok::plant
