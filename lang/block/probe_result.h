// What the last probing of a channel (G38) found; kept from program to program, until power-off.
#pragma once

#include <array>

#include "lang/contract/command.h"

namespace stanok::lang {

// In programmed coordinates of the system in which it was done, mm and deg.
struct ProbeResult {
  bool found = false;
  AxisValues position{};
  bool rehearsed = false;                  // no probe was there
  std::array<double, 3> tool_length_mm{};  // in force then, along X, Y, Z
};

}  // namespace stanok::lang
