// SpindleOrders: what of a vibration comes back with every turn of the spindle: run-out, teeth,
// out-of-balance.
//
// All orders at once are the mean over the turns at each angle of the spindle. They are tied to
// the angle and not to time: a spindle whose speed drifts takes them along. Between angles the
// values go on a straight line. Allocates in its constructor only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/rt_safe.h"

namespace stanok::drives {

class SpindleOrders {
 public:
  SpindleOrders();

  void clear() RT_SAFE;
  // Adds what the block still has of them. `turns`: of the spindle at each sample. Once more with
  // what is left brings what straight lines between angles left out.
  void learn(std::span<const double> block, std::span<const double> turns) RT_SAFE;
  [[nodiscard]] double at(double turn) const RT_SAFE;

 private:
  static constexpr std::size_t angles = 512;

  struct Place {
    std::size_t below = 0;
    std::size_t above = 0;
    double part = 0.0;  // of the one above
  };
  [[nodiscard]] static Place place_of(double turn) RT_SAFE;

  std::vector<double> values_;
  std::vector<double> sums_;
  std::vector<double> weights_;
};

}  // namespace stanok::drives
