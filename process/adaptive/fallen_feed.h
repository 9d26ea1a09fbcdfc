// FallenFeed: whether the power has answered to a feed that fell to S_min at once.
//
// The power that made the feed fall is larger than that of S_min, by what the feed has lost, h^y: a
// cut that became heavier shows it so, while a sensor that is stuck at too high a value shows no
// difference. A feed that falls slowly may do so with a cut that becomes heavier all the while, and
// is not judged. Part of the process observer of a channel, in the cycle.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/rt_safe.h"

namespace stanok::process {

class FallenFeed {
 public:
  struct Inputs {
    double cycle_s = 0.001;
    double force_n = 0.0;
    double feed = 0.0;  // mm/rev
    double feed_exponent = 0.75;
    double settling_s = 0.1;
    bool is_at_minimum = false;
  };
  // True where it has not answered.
  [[nodiscard]] bool look(const Inputs& inputs) RT_SAFE {
    smooth_n_ += (inputs.force_n - smooth_n_) *
                 (inputs.cycle_s < smoothing_s ? inputs.cycle_s / smoothing_s : 1.0);
    if (inputs.feed >= (1.0 - rests_within) * lowest_) rest_s_ += inputs.cycle_s;
    if (inputs.feed < (1.0 - rests_within) * lowest_) {
      lowest_ = inputs.feed;
      rest_s_ = 0.0;
    }
    fall_s_ += inputs.cycle_s;
    const bool is_over = inputs.feed > top_ || (!inputs.is_at_minimum && rest_s_ > quick_s);
    if (top_ == 0.0 || is_over || fall_s_ > fall_max_s) {
      top_ = lowest_ = inputs.feed;
      largest_n_ = smooth_n_;
      fall_s_ = rest_s_ = 0.0;
    }
    largest_n_ = std::max(largest_n_, smooth_n_);
    const double lost = inputs.feed_exponent * std::log(top_ / inputs.feed);
    if (!inputs.is_at_minimum || lost < judged || rest_s_ < inputs.settling_s + settled_s)
      return false;
    return std::log(std::max(largest_n_, least) / std::max(smooth_n_, least)) < answered * lost;
  }
  void reset() RT_SAFE { *this = {}; }

 private:
  static constexpr double smoothing_s = 0.1;
  static constexpr double settled_s = 0.3;
  static constexpr double rests_within = 0.005;
  static constexpr double quick_s = 0.5;
  static constexpr double fall_max_s = 5.0;
  static constexpr double judged = 0.3;  // ln of the force that the feed has lost
  static constexpr double answered = 0.25;
  static constexpr double least = 1e-9;

  double smooth_n_ = 0.0;
  double top_ = 0.0;        // feed from which it falls; 0: not yet known
  double lowest_ = 0.0;     // since
  double largest_n_ = 0.0;  // smoothed force since
  double fall_s_ = 0.0;
  double rest_s_ = 0.0;  // the feed has not fallen further
};

}  // namespace stanok::process
