// Where the rotary axes have to stand for the tool to point in a direction: what the interpreter
// asks of its channel, whose kinematics it does not know.
//
// Directions are unit vectors in B, from the tip into the spindle; angles in deg as B reads them,
// in the order of the channel's axes.
#pragma once

#include <array>
#include <cstdint>

#include "lang/contract/command.h"

namespace stanok::lang {

using Direction = std::array<double, 3>;

// Which sign the angle of the first rotary axis must have: the one in the head, or the one nearest
// to the slides or to the bed.
enum class FirstRotary : std::uint8_t { nearest, positive, negative };

// How the tool turns in a move at feed that inclines it (#orientation).
enum class TurningWay : std::uint8_t {
  of_code,  // G43.4: the rotary axes move evenly; G43.5: on the great circle
  vector,   // on the great circle
  axis,     // the rotary axes move evenly
};

struct AlignmentWish {
  Direction tool_B{0.0, 0.0, 1.0};
  AxisValues from_B{};  // where the axes stand
  FirstRotary first = FirstRotary::nearest;
};

struct Alignment {
  enum class Outcome : std::uint8_t {
    found,
    no_rotary_axes,  // that incline the tool, in the scheme that is active
    out_of_reach,    // of the geometry
    beyond_limit,
    wrong_sign,
  };
  Outcome outcome = Outcome::no_rotary_axes;
  AxisSet axes = 0;       // the two that turn
  AxisValues angles_B{};  // found: theirs
  // beyond_limit: the axis, the angle it would need and its limit there, as the axis reads them.
  AxisIndex axis;
  double needed_deg = 0.0;
  double limit_deg = 0.0;
  // Not found: the nearest direction within the travel, its angles and how far it is off.
  Direction nearest_B{};
  double off_deg = 0.0;
};

}  // namespace stanok::lang
