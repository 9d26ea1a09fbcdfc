#include "motion/time_optimum/limit_grid.h"

#include <algorithm>
#include <cmath>

#include "motion/path/geometry.h"
#include "motion/path/sampling.h"

namespace stanok::motion {
namespace {

constexpr double slowest_min = 1e-6;  // s/mm; speeds stay finite where no axis has a limit

}  // namespace

void LimitGrid::clear() {
  lengths_.clear();
  tops_.clear();
  misses_.clear();
  axes_ = 0;
  all_.clear();
  rates_.clear();
}

LimitGrid::Rates LimitGrid::rates_at(const Segment& segment, double s, double jerk_part) const {
  JetPoint point_s;
  JetPoint axes_M;
  evaluate(segment, s, point_s);
  to_machine(segment, point_s, axes_M);
  Rates rates;
  for (std::size_t k = 0; k < static_cast<std::size_t>(config_.axis_count); ++k) {
    const AxisLimits& limits = config_.axes[k];
    const double jerk_max = jerk_part * limits.jerk_max;
    const double speed_max = segment.rapid ? limits.rapid_speed_max() : limits.velocity_max;
    rates[k] = {.velocity = axes_M[k].first / speed_max,
                .tangent = axes_M[k].first / limits.acceleration_max,
                .curvature = axes_M[k].second / limits.acceleration_max,
                .thrust = axes_M[k].first / jerk_max,
                .bend = axes_M[k].second / jerk_max,
                .aberrancy = axes_M[k].third / jerk_max};
  }
  return rates;
}

void LimitGrid::add(const Segment& segment, std::span<const double> knots, double jerk_part) {
  // The stored ends of a segment have no derivatives of their own: just beside them.
  const auto rates = [&](double s) {
    constexpr double beside = 1e-12;
    return rates_at(segment,
                    std::clamp(s, beside * segment.length, (1.0 - beside) * segment.length),
                    jerk_part);
  };
  Rates at_start = rates(knots.front());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double length = knots[i + 1] - knots[i];
    const Rates at_middle = rates(knots[i] + 0.5 * length);
    const Rates at_end = rates(knots[i + 1]);
    const Rates at_first_quarter = rates(knots[i] + 0.25 * length);
    const Rates at_last_quarter = rates(knots[i] + 0.75 * length);
    double slowest = std::max({1.0 / segment.feed_per_s, segment.bounds.chords, slowest_min});
    for (std::size_t k = 0; k < axes_max; ++k) {
      const double inside = std::abs(at_middle[k].velocity);
      const double sides = std::max(std::abs(at_start[k].velocity), std::abs(at_end[k].velocity));
      const double bulge =
          std::abs(at_start[k].velocity - 2.0 * at_middle[k].velocity + at_end[k].velocity);
      slowest = std::max(slowest, std::max(inside, sides) + between_samples * bulge);
    }
    lengths_.push_back(length);
    tops_.push_back(1.0 / (slowest * slowest));
    const std::array<const Rates*, places> known{&at_start, &at_middle, &at_end, &at_first_quarter,
                                                 &at_last_quarter};
    constexpr double eighth = 0.125;
    misses_.push_back(
        std::max(miss(known, eighth, rates(knots[i] + eighth * length)),
                 miss(known, 1.0 - eighth, rates(knots[i] + (1.0 - eighth) * length))));
    all_.insert(all_.end(), {at_start, at_middle, at_end, at_first_quarter, at_last_quarter});
    at_start = at_end;
  }
}

LimitGrid::Weights LimitGrid::weights_at(double x) {
  constexpr Weights at{0.0, 0.5, 1.0, 0.25, 0.75};
  Weights weights;
  for (std::size_t i = 0; i < at.size(); ++i) {
    weights[i] = 1.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (k != i) weights[i] *= (x - at[k]) / (at[i] - at[k]);
    }
  }
  return weights;
}

double LimitGrid::miss(const std::array<const Rates*, places>& known, double x,
                       const Rates& there) {
  const Weights weights = weights_at(x);
  double largest = 0.0;
  for (std::size_t k = 0; k < axes_max; ++k) {
    double sum = -there[k].aberrancy;
    for (std::size_t i = 0; i < places; ++i) sum += weights[i] * (*known[i])[k].aberrancy;
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

double LimitGrid::largest_miss(std::size_t first) const {
  return first < misses_.size()
             ? *std::max_element(misses_.begin() + static_cast<std::ptrdiff_t>(first),
                                 misses_.end())
             : 0.0;
}

double LimitGrid::largest_aberrancy(std::size_t first) const {
  double largest = 0.0;
  for (std::size_t i = first * places; i < all_.size(); ++i) {
    for (const AxisRates& r : all_[i]) largest = std::max(largest, std::abs(r.aberrancy));
  }
  return largest;
}

void LimitGrid::cut(std::size_t first) {
  lengths_.resize(first);
  tops_.resize(first);
  misses_.resize(first);
  all_.resize(first * places);
}

void LimitGrid::finish() {
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < static_cast<std::size_t>(config_.axis_count); ++k) {
    const auto moves = [k](const Rates& rates) {
      return rates[k].thrust != 0.0 || rates[k].tangent != 0.0 || rates[k].bend != 0.0;
    };
    if (std::ranges::any_of(all_, moves)) moving.push_back(k);
  }
  axes_ = moving.size();
  rates_.reserve(all_.size() * axes_);
  for (const Rates& rates : all_) {
    for (const std::size_t k : moving) rates_.push_back(rates[k]);
  }
  all_.clear();
}

}  // namespace stanok::motion
