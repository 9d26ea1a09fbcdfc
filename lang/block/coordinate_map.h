// From programmed coordinates to the workpiece system W: mirror (G51.1), then scaling (G51).
//
// Axis by axis w = gain * p + shift: the mirror at m takes p to 2m - p, scaling by f about c takes
// that to c + f*(p - c). Rotation, shifts and work offsets come after it, between W and B. Lengths
// and distances (G91, I J K, R) take the gain alone. mm, in the order of the channel's axes.
#pragma once

#include <array>

#include "lang/contract/command.h"

namespace stanok::lang {

class CoordinateMap {
 public:
  CoordinateMap();

  // Some axis is mirrored or scaled; if not, W is as programmed to the bit.
  [[nodiscard]] bool active() const { return active_; }

  [[nodiscard]] double gain(AxisIndex axis) const { return gain_[axis]; }
  [[nodiscard]] const AxisValues& gains() const { return gain_; }
  [[nodiscard]] const AxisValues& shifts() const { return shift_; }
  [[nodiscard]] double to_work(AxisIndex axis, double programmed) const {
    return gain_[axis] * programmed + shift_[axis];
  }
  // As if nothing were scaled.
  [[nodiscard]] double mirrored(AxisIndex axis, double programmed) const {
    const AxisMap& map = axes_[axis];
    return map.mirrored ? 2.0 * map.line - programmed : programmed;
  }
  [[nodiscard]] double to_program(AxisIndex axis, double work) const {
    return (work - shift_[axis]) / gain_[axis];
  }

  // Everything it holds, as finite numbers, and back; false when they are no map.
  using Numbers = std::array<double, 4UL * axes_max>;
  [[nodiscard]] Numbers numbers() const;
  [[nodiscard]] bool take(const Numbers& numbers);

  // `factor` is not 0, a negative one mirrors, too; the programmed coordinate `centre` stays where
  // the mirror has it.
  void scale(AxisIndex axis, double centre, double factor);
  void mirror(AxisIndex axis, double line);
  void cancel_scaling();
  void cancel_mirror(AxisIndex axis);
  [[nodiscard]] bool any_mirror() const;

 private:
  struct AxisMap {
    bool mirrored = false;
    double line = 0.0;
    double centre = 0.0;  // after the mirror
    double factor = 1.0;
  };

  void compute(AxisIndex axis);

  AxisArray<AxisMap> axes_{};
  AxisValues gain_{};
  AxisValues shift_{};
  bool active_ = false;
};

}  // namespace stanok::lang
