#include "drives/spindle_orders.h"

#include <algorithm>
#include <cmath>

namespace stanok::drives {

SpindleOrders::SpindleOrders() : values_(angles), sums_(angles), weights_(angles) {}

void SpindleOrders::clear() RT_SAFE {
  std::fill(values_.begin(), values_.end(), 0.0);
}

SpindleOrders::Place SpindleOrders::place_of(double turn) RT_SAFE {
  const double angle = (turn - std::floor(turn)) * static_cast<double>(angles);
  const double below = std::floor(angle);
  const auto place = static_cast<std::size_t>(below) % angles;
  return {.below = place, .above = (place + 1) % angles, .part = angle - below};
}

void SpindleOrders::learn(std::span<const double> block, std::span<const double> turns) RT_SAFE {
  std::fill(sums_.begin(), sums_.end(), 0.0);
  std::fill(weights_.begin(), weights_.end(), 0.0);
  for (std::size_t k = 0; k < block.size(); ++k) {
    const Place place = place_of(turns[k]);
    sums_[place.below] += (1.0 - place.part) * block[k];
    weights_[place.below] += 1.0 - place.part;
    sums_[place.above] += place.part * block[k];
    weights_[place.above] += place.part;
  }
  for (std::size_t k = 0; k < angles; ++k)
    if (weights_[k] > 0.0) values_[k] += sums_[k] / weights_[k];
}

double SpindleOrders::at(double turn) const RT_SAFE {
  const Place place = place_of(turn);
  return values_[place.below] + place.part * (values_[place.above] - values_[place.below]);
}

}  // namespace stanok::drives
