#include "base/angle.h"

#include <cmath>
#include <numbers>

namespace stanok {

// Folded into the first quadrant, where the exact values are.
double sine_of_degrees(double angle_deg) {
  const double turn = std::fmod(angle_deg, 360.0);
  const double positive = turn < 0.0 ? turn + 360.0 : turn;
  const double sign = positive >= 180.0 ? -1.0 : 1.0;
  double folded = positive >= 180.0 ? positive - 180.0 : positive;
  if (folded > 90.0) folded = 180.0 - folded;
  if (folded == 0.0) return 0.0;
  if (folded == 30.0) return sign * 0.5;
  if (folded == 90.0) return sign;
  return sign * std::sin(folded * std::numbers::pi / 180.0);
}

double cosine_of_degrees(double angle_deg) {
  return sine_of_degrees(std::fmod(angle_deg, 360.0) + 90.0);
}

}  // namespace stanok
