// AxisMove: one axis by itself from rest to rest, outside of any path: jogging, homing.
//
// The travel is planned whole when it begins: up to the speed, on with it, and down, so that the
// end is exact; it may be stopped anywhere, and then ends before. Real-time.
#pragma once

#include <array>
#include <cstddef>

#include "base/rt_safe.h"
#include "kinematics/jet.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

// Limits of one axis, in mm or deg per s, s^2, s^3; all > 0.
struct AxisMoveLimits {
  double speed = 0.0;
  RampLimits ramp;
};

class AxisMove {
 public:
  // From rest. A travel of no length is at its end at once.
  void begin(double from, double to, const AxisMoveLimits& limits) RT_SAFE;
  // To rest as soon as the limits allow.
  void stop() RT_SAFE;
  // Farther in its direction than it goes, without a rest between; `speed` is the highest from here
  // on, a higher one that it has already is left as soon as the limits allow. Not at rest.
  void extend(double to, double speed) RT_SAFE;

  void advance(double time_s) RT_SAFE;
  [[nodiscard]] bool is_at_rest() const RT_SAFE { return at_ >= size_; }
  [[nodiscard]] bool goes_up() const RT_SAFE { return sign_ > 0.0; }
  [[nodiscard]] double end() const RT_SAFE { return end_; }
  // Position with its derivatives by time.
  [[nodiscard]] kinematics::Jet position() const RT_SAFE;

 private:
  void add(const PhaseRun& run) RT_SAFE;

  void end_with(const PhaseRun& change, double top, double length) RT_SAFE;

  static constexpr std::size_t phases_max = 2 * PhaseRun::capacity + 1;
  std::array<Phase, phases_max> phases_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
  double t_ = 0.0;  // within the current phase
  double from_ = 0.0;
  double sign_ = 1.0;
  double end_ = 0.0;   // where it comes to rest
  PathMotion motion_;  // along the way
  RampLimits ramp_;
};

}  // namespace stanok::motion
