// Swings: corners between two straight segments that are passed on both sides of them.
//
// A blend cuts a corner on its inside alone. A swing leaves the incoming segment outwards first, by
// the tolerance, crosses it, passes the corner inside by the tolerance, and comes back to the
// outgoing segment in the same way. It so has twice the room across the path and several times the
// length, and is passed nearly twice as fast. Derivation: docs/developer/motion.md#swings.
#pragma once

#include <optional>
#include <vector>

#include "motion/path/path.h"
#include "motion/path/shape.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// The deviation from the corner's legs over the path length t, both over the reach L, for a kink
// |t_out - t_in| of 1: an even function with a third derivative of +-slope, the change of sign at
// `turn`,
//   D''(t) = bend - slope t  up to `turn`,  slope (t - 1)  from there to 1.
class SwingForm {
 public:
  // The turn at which the deviation is the same on both sides; greater ones swing out less, and 1
  // does not swing out at all.
  static constexpr double turn_min = 0.81328737049288761;

  explicit SwingForm(double turn);
  // The form that passes the corner within `deviation`: as far out as need be.
  [[nodiscard]] static SwingForm with_deviation(double deviation);

  [[nodiscard]] double turn() const { return turn_; }
  // D(0), the deviation at the corner: from 0.0392 at `turn_min` to 1/6 at 1.
  [[nodiscard]] double at_corner() const { return at_corner_; }

  struct Deviation {
    double value = 0.0;
    double first = 0.0;
    double second = 0.0;
  };
  // At 0 <= t <= 1, the side of the outgoing segment. On the other side the deviation is the same,
  // its slope the opposite.
  [[nodiscard]] Deviation at(double t) const;

 private:
  double turn_;
  double slope_;
  double bend_;
  double at_corner_;
};

// The same for a step of curvature of 1 where the segments meet, for L = 1: an odd function, with a
// third derivative of +-slope that changes its sign at `turn`. It leaves one segment outwards and
// the other one inwards.
class StepForm {
 public:
  static constexpr double turn = 0.79370052598409974;    // 2^(-1/3): as steep on both sides of it
  static constexpr double largest = 0.0145204;           // deviation
  static constexpr double slope = 0.5 / (2 * turn - 1);  // D''(1) = 0
  // At 0 <= t <= 1; on the other side value and second derivative have the opposite sign.
  [[nodiscard]] static SwingForm::Deviation at(double t);
};

struct Swing {
  std::vector<Shape> parts;  // in path order
  double reach = 0.0;        // where it leaves and enters the segments, from the corner
};

[[nodiscard]] bool is_between_lines(const Segment& incoming, const Segment& outgoing);

// The swing with the greatest reach, up to `reach_max`, within `tolerance`, that is passed at an
// even speed; none where a blend as long as `reach_max` keeps the tolerance by itself.
[[nodiscard]] std::optional<Swing> fit_swing(const Segment& incoming, const Segment& outgoing,
                                             double reach_max, const Tolerance& tolerance,
                                             const MotionConfig& config);

// The reach of a swing to the full tolerance between two straight segments.
[[nodiscard]] double full_swing_reach(const Segment& incoming, const Segment& outgoing,
                                      const Tolerance& tolerance, const MotionConfig& config);

}  // namespace stanok::motion
