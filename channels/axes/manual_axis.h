// What moves by hand must know of an axis.
#pragma once

#include "base/fixed_text.h"
#include "channels/contract/machine_config.h"

namespace stanok::channels {

// Figures of one axis as far as it is moved by hand.
struct ManualAxis {
  FixedText<16> name;
  motion::AxisLimits limits;
  HomingConfig homing;
  double following_error_max = 0.5;
};

}  // namespace stanok::channels
