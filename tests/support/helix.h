// A spindle as a formula of time, what its encoder shows of it, and the helix that a thread must
// be.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace stanok::testing {

// Turns of a spindle at a time in s.
using Turning = std::function<double(double)>;

inline Turning steady(double turns_per_s) {
  return [=](double t) { return turns_per_s * t; };
}

// 20 % of ripple at 2 Hz.
inline Turning with_ripple(double turns_per_s, double phase) {
  return [=](double t) {
    const double w = 2.0 * std::numbers::pi * 2.0;
    return turns_per_s * (t - 0.2 / w * (std::cos(w * t + phase) - std::cos(phase)));
  };
}

// What an encoder of `lines` shows, four counts to a line: an angle in [0, 360).
inline double encoder_deg(double turns, int lines) {
  const double counts = 4.0 * lines;
  const double seen = std::floor(turns * counts) / counts;
  return 360.0 * (seen - std::floor(seen));
}

// How far `way` mm from the start of a thread lie from the helix, along the thread. `turns` are
// those since the start angle; `lead` has the sign of the way.
inline double off_helix(double turns, double way, double lead) {
  const double off = turns - way / lead;
  return std::abs(off - std::round(off)) * std::abs(lead);
}

// How deep a tool was each time that it came past a place of Z on its way down: the passes of a
// thread.
class PassDepths {
 public:
  explicit PassDepths(double place) : place_(place), z_(place) {}

  void see(double z, double depth) {
    if (z_ > place_ && z <= place_) depths_.push_back(depth);
    z_ = z;
  }
  [[nodiscard]] const std::vector<double>& all() const { return depths_; }

 private:
  double place_;
  double z_;  // seen last
  std::vector<double> depths_;
};

}  // namespace stanok::testing
