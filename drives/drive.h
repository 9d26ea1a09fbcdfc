// One drive as the real-time cycle sees it: a target goes out, feedback comes in, both plain data.
//
// The states are those of the power drive system of CiA 402 (IEC 61800-7-201, finite state
// automaton); drives/cia402.h holds their codes. Targets are cyclic synchronous positions: the
// drive follows `position`, and uses `velocity` as feed-forward and to bridge the time until the
// next target. A drive whose position loop is closed in the cycle works in the mode of cyclic
// synchronous velocities: it follows `velocity`, and `position` serves its supervision. Units: mm
// or deg of the axis, per second; power in W, vibration in um and Hz.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "base/rt_safe.h"

namespace stanok::drives {

enum class DriveState : std::uint8_t {
  not_ready_to_switch_on,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction_active,
  fault,
};

// "operation enabled", as the standard writes it.
[[nodiscard]] std::string_view name_of(DriveState state);

// Modes of operation of CiA 402 that a drive changes between while it is on: an axis, or a spindle.
// In cyclic synchronous velocity the drive follows `velocity` and reports the angle in [0, 360)
// deg.
enum class OperationMode : std::uint8_t {
  cyclic_synchronous_position,
  cyclic_synchronous_velocity
};

// For which a drive that follows positions goes on with the velocity of its last target, s.
inline constexpr double bridged_s = 0.1;

struct DriveTarget {
  double position = 0.0;
  double velocity = 0.0;
  OperationMode mode = OperationMode::cyclic_synchronous_position;
  bool enabled = false;
  bool brake_closed = true;
  bool fault_reset = false;        // a rising edge acknowledges the fault of the drive
  bool position_accepted = false;  // the position the drive reports now is taken for true (homing)
  // Added to the positions that the drive counts, in both directions: what homing has found. A
  // change takes effect with `position_accepted` only.
  double position_offset = 0.0;
};

// What a target is that comes so much later than it should have: the drive went on meanwhile.
[[nodiscard]] inline DriveTarget carried_on(DriveTarget target, double late_s) RT_SAFE {
  const bool goes_on =
      target.enabled && target.mode == OperationMode::cyclic_synchronous_position && late_s > 0.0;
  if (goes_on) target.position += target.velocity * std::min(late_s, bridged_s);
  return target;
}

struct DriveFeedback {
  double position = 0.0;
  double target_position = 0.0;  // what was written in the exchange that brought `position`
  double velocity = 0.0;
  // Demand minus position at one instant: what the drive reports, or what its answer shows against
  // its targets, whichever is worse.
  double following_error = 0.0;
  double power_w = 0.0;
  double vibration_um = 0.0;
  double vibration_hz = 0.0;
  double temperature_c = 0.0;
  double position_offset = 0.0;   // that is added to what the drive counts
  double index_position = 0.0;    // where the measuring system was at the last index pulse
  std::uint32_t index_count = 0;  // index pulses so far, as the drive counts them: 16 bits
  std::uint32_t sequence = 0;     // answers accepted so far
  std::uint32_t age_cycles = 0;   // reads since `sequence` changed
  std::uint32_t losses = 0;       // how often contact was lost so far
  std::uint16_t fault_code = 0;   // CiA 402 error code, 0: none
  DriveState state = DriveState::not_ready_to_switch_on;
  bool valid = false;       // false: no trustworthy answer within the timeout; values are the last
  bool referenced = false;  // the position belongs to the machine; false after a jump out of sight
  bool brake_closed = true;
  bool home_switch = false;     // stands on its home switch
  bool limit_negative = false;  // stands on the limit switch at this end
  bool limit_positive = false;
  bool following_error_exceeded = false;  // over the limit for longer than a disturbance lasts
};

static_assert(std::is_trivially_copyable_v<DriveTarget>);
static_assert(std::is_trivially_copyable_v<DriveFeedback>);

}  // namespace stanok::drives
