// The position of the rotary axes that a machine takes for a direction of the tool: one of the
// branches of tool_direction.h, within the travel of the axes.
//
// Of the branches that the travel allows, the nearest one is taken, by the sum of the ways of both
// axes; of two equally near the one whose first axis stands at a positive angle. Whole turns are
// added where they shorten the way. A free axis stays where it is. Angles in deg as B reads them;
// directions are unit vectors in B, from the tip into the spindle.
#pragma once

#include <limits>

#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

struct AngleTravel {
  double min_deg = -std::numeric_limits<double>::infinity();
  double max_deg = std::numeric_limits<double>::infinity();
};

// Which sign the angle of the first axis must have; 0 has both.
enum class FirstAngle : unsigned char { any, positive, negative };

struct DirectionWish {
  Vector3<double> tool_B{0.0, 0.0, 1.0};
  AxisVector<AngleTravel> travel{};
  AxisVector<double> from_B{};  // where the axes stand
  FirstAngle first = FirstAngle::any;
};

struct DirectionChoice {
  enum class Outcome : unsigned char {
    found,
    no_rotary_axes,
    out_of_reach,  // of the geometry
    beyond_limit,  // every branch that is wanted needs an angle outside of the travel
    wrong_sign,    // no branch within the travel has the sign that is wanted
  };
  Outcome outcome = Outcome::no_rotary_axes;
  std::array<AxisIndex, 2> axes{};
  std::array<double, 2> angles_deg{};  // found; else of the nearest direction within the travel
  // beyond_limit: the axis that comes least far beyond, the angle it needs and the limit there.
  AxisIndex axis;
  double needed_deg = 0.0;
  double limit_deg = 0.0;
  // Not found: the nearest direction that the axes reach within their travel, whatever the sign,
  // and how far it is off the wanted one.
  Vector3<double> nearest_B{};
  double off_deg = 0.0;
};

[[nodiscard]] DirectionChoice choose_direction(const Scheme& scheme, const DirectionWish& wish);

}  // namespace stanok::kinematics
