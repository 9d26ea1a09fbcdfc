// How a workpiece lies otherwise than the program takes it to lie (G54.4): a shift and turns of the
// work offset, which the control adds to points and to directions of the tool.
#pragma once

#include <array>

#include "base/rotation.h"

namespace stanok::lang {

// A value, part of the modal state. The shift is in mm along the axes of the work offset; the turns
// are about its X, Y and Z, which stay where they are, that about X first, deg.
struct SetUpError {
  bool is_on = false;
  std::array<double, 3> shift{};
  std::array<double, 3> angles_deg{};
  Rotation rotation;  // of the angles

  void set(const std::array<double, 3>& by, const std::array<double, 3>& angles);
  [[nodiscard]] bool turns() const { return is_on && !rotation.is_identity(); }
};

}  // namespace stanok::lang
