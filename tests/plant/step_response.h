// The step response of a second-order system, for the axes that must have it.
#pragma once

#include <cmath>

namespace stanok::plant {

// Unit step response of w^2 / (s^2 + 2 d w s + w^2) at time t. Source: any textbook of control,
// for the three cases of damping.
inline double step_response(double w, double d, double t) {
  if (d < 1.0) {
    const double wd = w * std::sqrt(1.0 - d * d);
    const double phase = std::acos(d);
    return 1.0 - std::exp(-d * w * t) / std::sqrt(1.0 - d * d) * std::sin(wd * t + phase);
  }
  if (d == 1.0) {
    return 1.0 - (1.0 + w * t) * std::exp(-w * t);
  }
  const double root = std::sqrt(d * d - 1.0);
  const double slow = w * (d - root);
  const double fast = w * (d + root);
  return 1.0 - (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
}

}  // namespace stanok::plant
