#include "lang/planes/set_up_error.h"

namespace stanok::lang {

void SetUpError::set(const std::array<double, 3>& by, const std::array<double, 3>& angles) {
  is_on = true;
  shift = by;
  angles_deg = angles;
  rotation = Rotation::about({0.0, 0.0, 1.0}, angles[2]) *
             Rotation::about({0.0, 1.0, 0.0}, angles[1]) *
             Rotation::about({1.0, 0.0, 0.0}, angles[0]);
}

}  // namespace stanok::lang
