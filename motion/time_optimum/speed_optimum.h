// SpeedOptimum: the shortest time over a stretch of path under the limits of all axes.
//
// b(s) = v^2 is a quadratic spline with a knot at each end of an interval of the grid: b' / 2 is
// the acceleration along the path, continuous, and b'' v / 2 the jerk. Limits of acceleration are
// linear in b, b'; those of jerk are after the convex 1 / sqrt(b) was replaced by its tangent,
// which lies below it. The time is convex in b, and Newton's method on it with a logarithmic
// barrier for each limit stays strictly within all of them (Boyd, Vandenberghe, Convex
// Optimization, 11.3; the tangent is renewed in each step). The system is a band of five.
// docs/developer/motion.md#optimum.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "motion/time_optimum/limit_grid.h"

namespace stanok::motion {

// The path's speed squared and its derivatives by s at one place.
struct SquaredSpeed {
  double value = 0.0;   // v^2
  double first = 0.0;   // 2 a
  double second = 0.0;  // 2 j / v
};

// State at an end of the stretch.
struct EndState {
  double v = 0.0;
  double a = 0.0;
};

// A quadratic spline of b over the intervals of a grid. Control point i + 1 belongs to the middle
// of interval i; the first and the last one are the values at the ends.
class SpeedSpline {
 public:
  void reset(const LimitGrid& grid, const EndState& begin, const EndState& end);

  [[nodiscard]] std::size_t intervals() const { return weights_.size(); }
  [[nodiscard]] std::vector<double>& points() { return points_; }
  [[nodiscard]] const std::vector<double>& points() const { return points_; }
  // How the value and the derivatives at one place come from the three points of its interval.
  struct Weights {
    std::array<double, 3> value{};
    std::array<double, 3> first{};
    std::array<double, 3> second{};

    [[nodiscard]] SquaredSpeed of(const double* points) const {
      const auto sum = [points](const std::array<double, 3>& w) {
        return w[0] * points[0] + w[1] * points[1] + w[2] * points[2];
      };
      return {sum(value), sum(first), sum(second)};
    }
  };
  [[nodiscard]] const Weights& weights(std::size_t interval, LimitGrid::Place place) const {
    return weights_[interval][place];
  }
  [[nodiscard]] SquaredSpeed at(std::size_t interval, LimitGrid::Place place) const {
    return weights_[interval][place].of(points_.data() + interval);
  }

 private:
  std::vector<std::array<Weights, LimitGrid::planned_places>> weights_;
  std::vector<double> points_;
};

// What an interval may use: of accelerations and jerks, and of the highest v^2.
struct LimitShare {
  double force = 1.0;
  double speed = 1.0;
};

class SpeedOptimum {
 public:
  // Makes the spline faster, towards the optimum. `shares`: of its limits that each interval may
  // use. Points 2 to n - 1 of n + 2 are free: states at both ends stay. The start may use somewhat
  // more than its share. `start`: how far from the optimum, as a part of the time, the search
  // begins. False: no motion within the limits was found.
  [[nodiscard]] bool improve(const LimitGrid& grid, const std::vector<LimitShare>& shares,
                             SpeedSpline& spline, double start);

  // First and second derivatives by (b, b', b'') at one place; the second ones in the order bb,
  // bb', bb'', b'b', b'b'', b''b''.
  struct Derivatives {
    std::array<double, 3> gradient{};
    std::array<double, 6> second{};
  };

 private:
  // Second derivatives, by rows: diagonal and the two beside it; and first ones.
  struct Band {
    std::array<double, 3> row{};
    double gradient = 0.0;
  };
  struct Pivot {
    double diagonal = 0.0;
    double near = 0.0;
    double far = 0.0;
  };

  [[nodiscard]] double use(const std::vector<double>& points, std::size_t m) const;
  [[nodiscard]] bool relax();
  [[nodiscard]] bool is_within(const std::vector<double>& points) const;
  [[nodiscard]] double top(std::size_t m) const;
  void collect(double weight);
  void spread(const Derivatives& local, const SpeedSpline::Weights& w, std::size_t m);
  [[nodiscard]] bool solve();
  [[nodiscard]] double longest_step() const;
  [[nodiscard]] bool step(double longest);
  [[nodiscard]] double decrement() const;

  const LimitGrid* grid_ = nullptr;
  const std::vector<LimitShare>* shares_ = nullptr;
  SpeedSpline* spline_ = nullptr;
  std::vector<double> relaxed_;  // factors of the limits in each interval, 1 in the end
  std::vector<Band> bands_;
  std::vector<Pivot> pivots_;
  std::vector<double> change_;
  std::vector<double> tried_;
};

}  // namespace stanok::motion
