// FeedModifier: what the cycle asks for the feed of a cut while the process is controlled.
//
// The channel tells the modifier once a cycle what path, spindle and sensors do; it answers with
// the feed of the setpoints to come. It acts on working feeds of linear axes only: rapid moves,
// threads and blocks of rotary axes alone run as they are programmed. The limits of the axes,
// override, hold and the laws of blocks act on what it asks for
// (docs/programmer/adaptive-control.md, "Order"). Owner: whoever assembles the machine; called in
// the real-time cycle.
#pragma once

#include <cstdint>
#include <limits>

#include "base/rt_safe.h"

namespace stanok::motion {

// What program or operator command; values that are not given are 0: those of the machine file.
struct ForceCommand {
  // adjust: changes what is given, on or off.
  enum class Kind : std::uint8_t {
    off,
    force,
    oscillate,
    vibration_on,
    vibration_off,
    adjust,
    depth
  };
  Kind kind = Kind::off;
  // force
  double force_n = 0.0;   // P_z; 0: as commanded before
  double feed_min = 0.0;  // mm/min, or mm per revolution
  double feed_max = 0.0;
  bool per_revolution = false;  // the clamps
  // oscillate, vibration_on
  double oscillation_n = 0.0;    // P_osc, amplitude; 0: no oscillation
  double oscillation_hz = 0.0;   // f
  double level_um = 0.0;         // permissible vibration
  double reduced_mass_kg = 0.0;  // m_d
  // depth
  double depth_mm = 0.0;  // of the cut, to which its force is proportional; 0: not known
};

// One cycle of the cut, as it was; what the sensors told last.
struct CutState {
  double cycle_s = 0.001;
  double rev_per_min = 0.0;          // of the master spindle, commanded; > 0
  bool at_speed = false;             // its ramp is over
  std::uint32_t spindle_starts = 0;  // times that it began to turn, or to turn back

  std::int64_t transverse_code = 0;  // position of the transverse axis, increments
  double transverse_mm = 0.0;        // the same, not rounded
  double increment_mm = 0.001;       // of that axis
  double radius_mm = 0.0;            // at which the tool stands in the frame of the program
  bool frame_is_new = false;         // the frame was set, with the axes at rest

  double feed_programmed = 0.0;  // mm/s; 0: rapid, or no path
  double path_speed = 0.0;       // mm/s
  double feed_override = 1.0;
  bool is_rapid = false;
  bool is_controllable = false;  // a working feed of linear axes
  bool has_law = false;          // a feed law of the block rules

  double power_w = std::numeric_limits<double>::quiet_NaN();
  double vibration_um = std::numeric_limits<double>::quiet_NaN();  // amplitude
  double vibration_hz = std::numeric_limits<double>::quiet_NaN();
};

struct FeedDemand {
  double feed_per_s = 0.0;      // mm/s before override; 0: the programmed feed
  double feed_max_per_s = 0.0;  // that it may become
};

// What happened, to be told to people.
enum class ForceEvent : std::uint8_t {
  none,
  sensor_lost,          // the feed is to be held
  sensor_lost_slow,     // the feed is S_min
  no_answer,            // of the power to the feed; the feed is to be held
  no_answer_slow,       // the feed is S_min
  stays_high,           // the power, although the feed fell; the feed is to be held
  stays_high_slow,      // the feed is S_min
  below_idle,           // the power; the feed is to be held
  below_idle_slow,      // the feed is S_min
  vibration_lost,       // nothing is formed from it
  frequency_shifted,    // of the oscillation, away from a multiple of the spindle's
  oscillation_limited,  // the force cannot swing as far as asked
  overload_at_feed_min,
  force_missing,   // in the air, or too low at S_max, for longer than an air cut lasts
  cut_is_lighter,  // than the reference by more than it may be: the feed rises no further
};

enum class ForceState : std::uint8_t {
  off,
  idle_power,  // waits until the idle power is known
  holding,     // rapid, air, or what cannot be controlled: the controller is held
  regulating,
  fault,  // a sensor gives no trustworthy value
};

// Why the power is not trusted.
enum class PowerDoubt : std::uint8_t {
  none,
  lost,        // not a number
  below_idle,  // for longer than a spindle at speed may draw so little
  no_answer,   // three times to more, or less, feed
  stays_high,  // although the feed has fallen to S_min
};

// Against which the cut may be lighter by `lighter_max`.
enum class CutReference : std::uint8_t {
  none,        // no cut yet
  programmed,  // the setpoint at the programmed feed
  cut,         // what the cut took before
  depth,       // the same, in proportion to the depth that the program gives
};

// Values of the control for displays and logs.
struct ForceStatus {
  ForceState state = ForceState::off;
  double force_set_n = 0.0;  // mean setpoint
  double force_now_n = 0.0;  // setpoint with its oscillation
  double force_n = 0.0;      // estimated from the power
  double power_w = 0.0;
  double power_idle_w = 0.0;  // N_x at the current speed
  double radius_mm = 0.0;     // of the counter
  double feed_per_s = 0.0;    // asked for
  double feed_min_per_s = 0.0;
  double feed_max_per_s = 0.0;
  double vibration_um = 0.0;  // a_0; 0: within the dead zone
  double vibration_hz = 0.0;
  double oscillation_n = 0.0;  // amplitude formed
  double oscillation_hz = 0.0;
  std::uint32_t captures = 0;  // of the idle power so far
  double level_um = 0.0;
  double reduced_mass_kg = 0.0;
  PowerDoubt doubt = PowerDoubt::none;
  CutReference reference = CutReference::none;
  double force_worst_n = 0.0;  // of an unchanged cut, whatever the sensor shows; 0: without a bound
};

class FeedModifier {
 public:
  FeedModifier() = default;
  FeedModifier(const FeedModifier&) = delete;
  FeedModifier& operator=(const FeedModifier&) = delete;
  virtual ~FeedModifier() = default;

  // False: there is no such control, as an oscillation while no force is commanded.
  [[nodiscard]] virtual bool command(const ForceCommand& command) RT_SAFE = 0;
  // Once a cycle, also while it is off.
  [[nodiscard]] virtual FeedDemand advance(const CutState& cut) RT_SAFE = 0;
  // The path may go on behind a command or a start of the spindle.
  [[nodiscard]] virtual bool is_ready() const RT_SAFE = 0;
  // What happened in the cycle.
  [[nodiscard]] virtual ForceEvent event() const RT_SAFE = 0;
  [[nodiscard]] virtual ForceStatus status() const RT_SAFE = 0;
};

}  // namespace stanok::motion
