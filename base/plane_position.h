// Where the rotary axes stand in a tilted plane of a program, as `check` tells it: of the two
// positions that incline the tool alike, the one that G53.1 or G53.6 takes, and the other one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"

namespace stanok {

// A rotary axis by its word, and its angle in deg as the axis reads it.
struct RotaryAngle {
  std::string word;
  double deg = 0.0;
};

struct PlanePosition {
  struct Other {
    std::string word;                 // beside G53.1 and G53.6, that asks for it: "P1", "P2"
    std::vector<RotaryAngle> axes;    // where they would stand; else the one that cannot
    std::optional<double> limit_deg;  // of the one that cannot; nothing: they would stand there
  };

  Place place;                   // of G53.1 or G53.6
  std::array<double, 3> tool{};  // its direction on the table, from the tip into the spindle
  std::vector<RotaryAngle> axes;
  std::optional<Other> other;  // nothing: there is no other position (pole)
};

using PlanePositions = std::vector<PlanePosition>;

}  // namespace stanok
