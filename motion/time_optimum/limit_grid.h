// LimitGrid: what the machine axes allow along a stretch of path, interval by interval.
//
// An interval lies within one segment. At five places in it, it holds the derivatives of
// every machine axis q_k(s), over the limits of that axis, so that with b = v^2 as a function of s
//   |q'' b + q' b'/2| / a_k <= 1
//   |q''' b + 3/2 q'' b' + 1/2 q' b''| sqrt(b) / j_k <= 1
// are the limits of acceleration and jerk (docs/developer/motion.md#optimum). Axes that do not move
// are left out. Owner: the channel's preparation.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "motion/path/path.h"

namespace stanok::motion {

// Derivatives of one axis by path length at one place, over the limits of the axis.
struct AxisRates {
  double velocity = 0.0;   // q' / v_max
  double tangent = 0.0;    // q' / a_max
  double curvature = 0.0;  // q'' / a_max
  double thrust = 0.0;     // q' / j_max
  double bend = 0.0;       // q'' / j_max
  double aberrancy = 0.0;  // q''' / j_max
};

class LimitGrid {
 public:
  // Start, middle and end are what a plan is made for; the quarters prove it.
  enum Place : std::size_t { start, middle, end, first_quarter, last_quarter, places };

  static constexpr std::size_t planned_places = 3;

  // The polynomial through the values at the places, as weights of them; x: 0 to 1.
  using Weights = std::array<double, places>;
  [[nodiscard]] static Weights weights_at(double x);

  explicit LimitGrid(const MotionConfig& config) : config_(config) {}

  void clear();
  // Appends the intervals of the segment between knots, which count from its start; of its jerk it
  // may use a part.
  void add(const Segment& segment, std::span<const double> knots, double jerk_part = 1.0);
  // By how much the third derivatives of the axes, over their limits of jerk, are missed in the
  // intervals from `first` on where the polynomial through their places is taken for them; before
  // `finish`.
  [[nodiscard]] double largest_miss(std::size_t first) const;
  // The largest third derivative of any axis over its limit of jerk, at the places of the intervals
  // from `first` on; before `finish`.
  [[nodiscard]] double largest_aberrancy(std::size_t first) const;
  // Takes the intervals from `first` on away; before `finish`.
  void cut(std::size_t first);
  // Drops the axes that move nowhere. Behind the last `add`.
  void finish();

  [[nodiscard]] std::size_t size() const { return lengths_.size(); }
  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] double length(std::size_t interval) const { return lengths_[interval]; }
  // Highest v^2 by feed and speeds of the axes.
  [[nodiscard]] double top(std::size_t interval) const { return tops_[interval]; }
  [[nodiscard]] std::span<const AxisRates> rates(std::size_t interval, Place place) const {
    return {rates_.data() + (interval * places + place) * axes_, axes_};
  }

 private:
  using Rates = std::array<AxisRates, axes_max>;
  [[nodiscard]] static double miss(const std::array<const Rates*, places>& known, double x,
                                   const Rates& there);
  [[nodiscard]] Rates rates_at(const Segment& segment, double s, double jerk_part) const;

  MotionConfig config_;
  std::vector<double> lengths_;
  std::vector<double> tops_;
  std::vector<double> misses_;
  std::size_t axes_ = 0;
  std::vector<Rates> all_;
  std::vector<AxisRates> rates_;
};

}  // namespace stanok::motion
