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

  [[nodiscard]] double gain(std::size_t axis) const { return gain_[axis]; }
  [[nodiscard]] double to_work(std::size_t axis, double programmed) const {
    return gain_[axis] * programmed + shift_[axis];
  }
  [[nodiscard]] double to_program(std::size_t axis, double work) const {
    return (work - shift_[axis]) / gain_[axis];
  }

  // Everything it holds, as finite numbers, and back; false when they are no map.
  using Numbers = std::array<double, std::size_t{4} * axes_max>;
  [[nodiscard]] Numbers numbers() const;
  [[nodiscard]] bool take(const Numbers& numbers);

  // `factor` above zero; the programmed coordinate `centre` stays where the mirror has it.
  void scale(std::size_t axis, double centre, double factor);
  void mirror(std::size_t axis, double line);
  void cancel_scaling();
  void cancel_mirror(std::size_t axis);
  [[nodiscard]] bool any_mirror() const;

 private:
  struct AxisMap {
    bool mirrored = false;
    double line = 0.0;
    double centre = 0.0;  // after the mirror
    double factor = 1.0;
  };

  void compute(std::size_t axis);

  std::array<AxisMap, axes_max> axes_{};
  AxisValues gain_{};
  AxisValues shift_{};
  bool active_ = false;
};

}  // namespace stanok::lang
