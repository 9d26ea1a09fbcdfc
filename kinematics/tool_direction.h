// Which positions of the rotary axes let the tool point in a wanted direction.
//
// The direction is that from the tool tip into the spindle, a unit vector in the base B of the
// scheme, which turns with the table. Two rotary axes reach it in two ways, the branches; in one
// where both meet, and at a pole the angle of one axis does not matter: it is free. Angles in deg
// as B reads them, in (-180, 180]; travel and whole turns are the matter of direction_choice.h.
#pragma once

#include <array>
#include <cstddef>

#include "base/axis_index.h"
#include "base/rt_safe.h"
#include "base/vector3.h"

namespace stanok::kinematics {

struct DirectionBranch {
  std::array<double, 2> angles_deg{};
  std::array<bool, 2> is_free{};  // the angle does not matter; 0 stands for it
};

struct DirectionSolution {
  enum class Kind : unsigned char {
    no_rotary_axes,  // the scheme has no pair of rotary axes that inclines the tool
    reached,
    out_of_reach,  // the geometry of the axes, whatever their travel
  };
  Kind kind = Kind::no_rotary_axes;
  // The axis nearest to the bed or to the slides first; of head and table the head.
  std::array<AxisIndex, 2> axes{};
  std::array<DirectionBranch, 2> branches{};
  std::size_t count = 0;
  // out_of_reach: the nearest direction that the axes reach, and how far it is off the wanted one.
  Vector3<double> nearest_B{};
  double off_deg = 0.0;
};

// Turns about two unit vectors, one after the other: R(outer, a) R(inner, b) from = to.
struct TwoTurns {
  enum class Wanted : unsigned char { from, to };  // which of both is the direction of the tool
  Vector3<double> outer{};
  Vector3<double> inner{};
  Vector3<double> from{};
  Vector3<double> to{};
  Wanted wanted = Wanted::to;
};

// a and b in this order; `axes` stays empty. Parallel axes are no pair. `nearest_B` takes the place
// of the wanted vector.
[[nodiscard]] DirectionSolution solve(const TwoTurns& turns) RT_SAFE;

}  // namespace stanok::kinematics
