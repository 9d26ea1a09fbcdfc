// Along a segment V = V_0 + g (X - X_0) and dX/dt = -V, so that V falls as exp(-g t).
#include "process/grinding/infeed_law.h"

#include <cmath>

namespace stanok::process {
namespace {

// (e^z - 1) / z, also where z is 0.
double relative_growth(double z) {
  return z == 0.0 ? 1.0 : std::expm1(z) / z;
}

// Time of a travel along which the feed goes linearly from `first` to `last`: the distance divided
// by their logarithmic mean, s.
double linear_feed_time_s(double travel_mm, double first, double last) {
  const double change = (last - first) / first;
  return travel_mm / first * (change == 0.0 ? 1.0 : std::log1p(change) / change);
}

}  // namespace

InfeedLaw constant_law(double begin_mm, double end_mm, double feed_mm_per_s) {
  return {{begin_mm, feed_mm_per_s}, {end_mm, feed_mm_per_s}};
}

double law_time_s(const InfeedLaw& law) {
  double time_s = 0.0;
  for (std::size_t k = 0; k + 1 < law.size(); ++k) {
    time_s += linear_feed_time_s(law[k].x_mm - law[k + 1].x_mm, law[k].feed_mm_per_s,
                                 law[k + 1].feed_mm_per_s);
  }
  return time_s;
}

InfeedTravel::InfeedTravel(const InfeedLaw& law, AtEnd at_end)
    : law_(law), at_end_(at_end), x_mm_(law.front().x_mm) {}

double InfeedTravel::slope_per_s() const {
  const InfeedRow& first = law_[segment_];
  const InfeedRow& last = law_[segment_ + 1];
  const double travel_mm = first.x_mm - last.x_mm;
  return travel_mm > 0.0 ? (first.feed_mm_per_s - last.feed_mm_per_s) / travel_mm : 0.0;
}

double InfeedTravel::feed_mm_per_s() const {
  if (is_at_end()) return at_end_ == AtEnd::goes_on ? law_.back().feed_mm_per_s : 0.0;
  const InfeedRow& first = law_[segment_];
  return first.feed_mm_per_s + slope_per_s() * (x_mm_ - first.x_mm);
}

double InfeedTravel::rest_s() const {
  const InfeedRow& last = law_[segment_ + 1];
  if (x_mm_ <= last.x_mm) return 0.0;
  return linear_feed_time_s(x_mm_ - last.x_mm, feed_mm_per_s(), last.feed_mm_per_s);
}

void InfeedTravel::advance(double time_s) {
  while (!is_at_end()) {
    const double rest = rest_s();
    if (time_s < rest) {
      x_mm_ -= feed_mm_per_s() * time_s * relative_growth(-slope_per_s() * time_s);
      return;
    }
    time_s -= rest;
    ++segment_;
    x_mm_ = law_[segment_].x_mm;
  }
  x_mm_ -= feed_mm_per_s() * time_s;
}

}  // namespace stanok::process
