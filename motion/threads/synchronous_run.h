// SynchronousRun: the motion along a chain that a spindle leads.
//
// The path coordinate s counts turns of the spindle: the law of the thread is
//   s = +-(turns of the spindle - turns at the start),
// the start being at the start angle of every pass, so that all passes cut one helix at any speed.
// Run-in: from rest the path comes into the law by a ramp that is played by the angle of the
// spindle, not by time, and ends half its turns after s = 0. In the law a controller of third order
// gives the jerk of each cycle from the predicted angle and its derivatives; what the axes allow
// bounds it, and there is always a way to rest within the chain. Run-out: such a way, to the very
// end. A tap stops the spindle for the bottom, turns it back and follows it to where it began
// (docs/developer/motion.md#threads). Real-time.
#pragma once

#include <array>
#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"
#include "motion/threads/spindle_observer.h"

namespace stanok::motion {

// What a tap asks of the spindle, from this cycle on.
struct SpindleOrder {
  enum class Kind : std::uint8_t {
    none,
    stop_within,  // comes to rest after `turns`
    turn_back,    // against its direction, `factor` times as fast, no sooner than `acceleration`
    go_on,        // as it did before
  };
  Kind kind = Kind::none;
  std::int32_t spindle = 0;
  double turns = 0.0;
  double factor = 1.0;
  double acceleration = 0.0;  // turns/s^2
};

// Jerk along the chain, in turns/s^3, that the path needs to follow a spindle through the steps of
// its encoder; with less it comes off the law.
[[nodiscard]] double jerk_to_follow(int encoder_pulses, double cycle_s);

class SynchronousRun {
 public:
  explicit SynchronousRun(double cycle_s);

  // The chain begins, at rest at s = 0.
  void begin(const SpindleCoupling& coupling, double length) RT_SAFE;

  // The state at the next setpoint; `spindle` is predicted for its instant. Before the run-in a
  // hold keeps the path at rest; later only `leaves_thread` brings it to rest within the chain: a
  // thread at once, a tap together with its spindle.
  PathMotion advance(const SpindleMotion& spindle, const FeedControl& control) RT_SAFE;

  // At rest at the end; of a tap, where it began.
  [[nodiscard]] bool is_over() const RT_SAFE { return stage_ == Stage::over; }
  // The axes could not follow the spindle: the path comes to rest, the chain is never over.
  [[nodiscard]] bool is_lost() const RT_SAFE { return is_lost_; }
  // Asked for in the latest cycle.
  [[nodiscard]] const SpindleOrder& order() const RT_SAFE { return order_; }

 private:
  enum class Stage : std::uint8_t { waits, goes_in, dwells, returns, comes_to_rest, stands, over };

  [[nodiscard]] bool is_too_fast(const SpindleMotion& spindle) RT_SAFE;
  [[nodiscard]] bool is_due(const SpindleMotion& spindle) RT_SAFE;
  void watch_speed(const SpindleMotion& spindle) RT_SAFE;
  [[nodiscard]] bool is_clear_of_corner(double speed) const RT_SAFE;
  void choose_limits(double speed) RT_SAFE;
  [[nodiscard]] bool keeps_speed(const SpindleMotion& spindle) const RT_SAFE;
  [[nodiscard]] kinematics::Jet course(const SpindleMotion& spindle) RT_SAFE;
  void follow(const kinematics::Jet& course) RT_SAFE;
  [[nodiscard]] PathMotion before(const kinematics::Jet& course) const RT_SAFE;
  [[nodiscard]] double jerk_towards(const kinematics::Jet& course, const RampLimits& limits) const
      RT_SAFE;
  [[nodiscard]] double jerk_allowed(double wanted) const RT_SAFE;
  void leave(const SpindleMotion& spindle) RT_SAFE;
  void turn_spindle(const SpindleMotion& spindle) RT_SAFE;
  void stop_spindle(double turns) RT_SAFE;
  [[nodiscard]] bool stands_with(const SpindleMotion& spindle) const RT_SAFE;
  void lose() RT_SAFE;
  [[nodiscard]] bool changes_limits(const kinematics::Jet& course) RT_SAFE;
  [[nodiscard]] bool joins_chain(const kinematics::Jet& course) RT_SAFE;
  [[nodiscard]] bool is_settled(const kinematics::Jet& course, const RampLimits& limits) const
      RT_SAFE;
  [[nodiscard]] bool brakes_before_corner(const RampLimits& limits) const RT_SAFE;
  // Phases to rest, and whether they end where the chain does.
  struct WayToRest {
    std::array<Phase, 2 + PhaseRun::capacity> phases{};
    std::size_t size = 0;
    bool ends_chain = false;
  };
  // The last ways to rest before an end; s counts from there in the direction of travel.
  struct Approach {
    double forward = 1.0;
    Phase ease;               // takes the acceleration away
    bool fits = false;        // what follows is known
    double ramp_begin = 0.0;  // of the ramp to rest, with these limits
    RampLimits limits;
  };
  [[nodiscard]] Approach approach(const PathMotion& from, double end) const RT_SAFE;
  [[nodiscard]] bool comes_to_rest_before(double end, const PathMotion& from) const RT_SAFE;
  [[nodiscard]] WayToRest way_to(double end) const RT_SAFE;
  [[nodiscard]] WayToRest brake() const RT_SAFE;
  [[nodiscard]] WayToRest shortest_way() const RT_SAFE;
  void take(const WayToRest& way) RT_SAFE;
  void run_brake() RT_SAFE;

  double cycle_s_;
  double gain_s_;  // of the controller: jerk by s, v, a
  double gain_v_;
  double gain_a_;

  SpindleCoupling coupling_;
  RampLimits limits_;  // the current ones
  double length_ = 0.0;
  Stage stage_ = Stage::over;
  PathMotion motion_;
  SpindleOrder order_;
  bool is_lost_ = false;
  bool leaves_ = false;  // the chain will not be over

  // The law.
  double direction_ = 1.0;
  double origin_ = 0.0;  // direction * turns at s = 0
  double whole_turns_before_ = 0.0;
  bool has_watched_ = false;
  bool runs_in_by_chain_ = false;  // with its limits, not those of the entry
  double mean_speed_ = 0.0;        // over about the duration of the run-in, in turns/s
  // The ramp of the run-in over time, if the spindle kept the speed it had when the ramp began.
  PhaseRun ramp_;
  double ramp_speed_ = 1.0;
  bool is_in_law_ = false;
  bool has_joined_ = false;  // the law, with the limits of the chain

  std::int64_t dwell_cycles_ = 0;
  bool spindle_stops_ = false;  // by order
  // The current way to rest.
  WayToRest brake_;
  double brake_time_ = 0.0;
  Stage stage_before_ = Stage::over;  // goes on when the brake does not end the chain
};

}  // namespace stanok::motion
