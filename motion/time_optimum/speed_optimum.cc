#include "motion/time_optimum/speed_optimum.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
namespace {

using Derivatives = SpeedOptimum::Derivatives;

// The path of the barrier: its part of the time at first and in the end, and how it falls.
constexpr double part_at_last = 0.0024;
constexpr double part_falls = 0.2;
constexpr double part_while_relaxed = 0.3;  // at first
constexpr double part_rises = 2.0;
constexpr double part_relaxed_max = 300.0;
constexpr int steps_max = 150;

// What intervals that are relaxed may use more than they do, as parts of what is too much and of
// their limits.
constexpr double room = 0.1;
constexpr double least_room = 0.03;
constexpr double settled = 1.0 - 1e-6;  // use of a share with which an interval is no more relaxed
constexpr double relaxed_max = 1000.0;

// Limits that one interval holds for one axis, as functions of (b, b', b'').
double acceleration_use(const AxisRates& r, const SquaredSpeed& b) {
  return r.curvature * b.value + 0.5 * r.tangent * b.first;
}
double jerk_use_over_speed(const AxisRates& r, const SquaredSpeed& b) {
  return r.aberrancy * b.value + 1.5 * r.bend * b.first + 0.5 * r.thrust * b.second;
}

// The tangent of limit / sqrt(b) at the present b.
struct JerkLimit {
  double value = 0.0;
  double slope = 0.0;
};

JerkLimit jerk_limit(double share, double b) {
  const double value = share / std::sqrt(b);
  return {value, -0.5 * value / b};
}

// A barrier -log(slack) whose slack falls by `slope` with (b, b', b'').
void add(Derivatives& local, double slack, const std::array<double, 3>& slope) {
  const double f = 1.0 / slack;
  const double ff = f * f;
  for (std::size_t i = 0; i < 3; ++i) local.gradient[i] += f * slope[i];
  local.second[0] += ff * slope[0] * slope[0];
  local.second[1] += ff * slope[0] * slope[1];
  local.second[2] += ff * slope[0] * slope[2];
  local.second[3] += ff * slope[1] * slope[1];
  local.second[4] += ff * slope[1] * slope[2];
  local.second[5] += ff * slope[2] * slope[2];
}

void add_acceleration(const AxisRates& r, const SquaredSpeed& b, double share, Derivatives& local) {
  const double use = acceleration_use(r, b);
  const double tangent = 0.5 * r.tangent;
  add(local, share - use, {r.curvature, tangent, 0.0});
  add(local, share + use, {-r.curvature, -tangent, 0.0});
}

void add_jerk(const AxisRates& r, const SquaredSpeed& b, double share, Derivatives& local) {
  const double use = jerk_use_over_speed(r, b);
  const JerkLimit limit = jerk_limit(share, b.value);
  const double bend = 1.5 * r.bend;
  const double thrust = 0.5 * r.thrust;
  add(local, limit.value - use, {r.aberrancy - limit.slope, bend, thrust});
  add(local, limit.value + use, {-r.aberrancy - limit.slope, -bend, -thrust});
}

// Of its limit at a place, the largest part that an axis uses.
double acceleration_used(std::span<const AxisRates> rates, const SquaredSpeed& b) {
  double use = 0.0;
  for (const AxisRates& r : rates) use = std::max(use, std::abs(acceleration_use(r, b)));
  return use;
}
double jerk_used(std::span<const AxisRates> rates, const SquaredSpeed& b) {
  double use = 0.0;
  for (const AxisRates& r : rates) use = std::max(use, std::abs(jerk_use_over_speed(r, b)));
  return use * std::sqrt(b.value);
}

}  // namespace

void SpeedSpline::reset(const LimitGrid& grid, const EndState& begin, const EndState& end) {
  const std::size_t n = grid.size();
  points_.assign(n + 2, 0.0);
  points_[0] = begin.v * begin.v;
  points_[1] = points_[0] + begin.a * grid.length(0);
  points_[n + 1] = end.v * end.v;
  points_[n] = points_[n + 1] - end.a * grid.length(n - 1);
  weights_.resize(n);
  for (std::size_t m = 0; m < n; ++m) {
    const double h = grid.length(m);
    // The values at both ends of the interval, by its three points.
    std::array<double, 3> left{1.0, 0.0, 0.0};
    std::array<double, 3> right{0.0, 0.0, 1.0};
    if (m > 0) {
      const double sum = grid.length(m - 1) + h;
      left = {h / sum, grid.length(m - 1) / sum, 0.0};
    }
    if (m + 1 < n) {
      const double sum = h + grid.length(m + 1);
      right = {0.0, grid.length(m + 1) / sum, h / sum};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double own = i == 1 ? 1.0 : 0.0;
      const double second = 2.0 * (left[i] - 2.0 * own + right[i]) / (h * h);
      Weights& at_start = weights_[m][LimitGrid::start];
      Weights& at_middle = weights_[m][LimitGrid::middle];
      Weights& at_end = weights_[m][LimitGrid::end];
      at_start.value[i] = left[i];
      at_start.first[i] = 2.0 * (own - left[i]) / h;
      at_middle.value[i] = 0.25 * left[i] + 0.5 * own + 0.25 * right[i];
      at_middle.first[i] = (right[i] - left[i]) / h;
      at_end.value[i] = right[i];
      at_end.first[i] = 2.0 * (right[i] - own) / h;
      at_start.second[i] = at_middle.second[i] = at_end.second[i] = second;
    }
  }
}

bool SpeedOptimum::improve(const LimitGrid& grid, const std::vector<LimitShare>& shares,
                           SpeedSpline& spline, double start) {
  grid_ = &grid;
  shares_ = &shares;
  spline_ = &spline;
  const std::size_t n = grid.size();
  bands_.resize(n + 2);
  pivots_.resize(n + 2);
  change_.assign(n + 2, 0.0);
  relaxed_.assign(n, relaxed_max);
  bool is_relaxed = relax();
  if (!is_within(spline.points())) return false;
  double time = 0.0;
  for (std::size_t m = 0; m < n; ++m)
    time += grid.length(m) / std::sqrt(spline.at(m, LimitGrid::middle).value);
  const double barriers = static_cast<double>(n * (6 * grid.axes() + 1));
  double part = start;
  double part_relaxed = part_while_relaxed;
  for (int k = 0; k < steps_max; ++k) {
    collect(barriers / ((is_relaxed ? part_relaxed : part) * time));
    if (!solve()) return !is_relaxed;
    const double off = decrement();
    const double longest = longest_step();
    constexpr double kept = 0.95;
    const bool is_whole = kept * longest >= 1.0;
    if (!step(std::min(1.0, kept * longest))) return !is_relaxed;
    constexpr double near = 1.5;
    constexpr double there = 0.1;
    if (is_relaxed) {
      // At rest with intervals that use too much, the time holds them there.
      if (off < there) part_relaxed *= part_rises;
      if (part_relaxed > part_relaxed_max) return false;
      is_relaxed = relax();
      continue;
    }
    if (!is_whole && off > near) continue;
    if (part <= part_at_last) return true;
    part = std::max(part_at_last, part_falls * part);
  }
  return !is_relaxed;
}

// Of the share of an interval; infinite where a speed is not positive.
double SpeedOptimum::use(const std::vector<double>& points, std::size_t m) const {
  const auto b = [&](LimitGrid::Place place) {
    return spline_->weights(m, place).of(points.data() + m);
  };
  const SquaredSpeed at_start = b(LimitGrid::start);
  const SquaredSpeed at_middle = b(LimitGrid::middle);
  const SquaredSpeed at_end = b(LimitGrid::end);
  if (!(std::min({at_start.value, at_middle.value, at_end.value}) > 0.0)) return unlimited;
  const double used = std::max({acceleration_used(grid_->rates(m, LimitGrid::middle), at_middle),
                                jerk_used(grid_->rates(m, LimitGrid::start), at_start),
                                jerk_used(grid_->rates(m, LimitGrid::end), at_end)});
  const bool is_free = m > 0 && m + 1 < grid_->size();
  return std::max(used / (*shares_)[m].force, is_free ? points[m + 1] / top(m) : 0.0);
}

bool SpeedOptimum::is_within(const std::vector<double>& points) const {
  for (std::size_t m = 0; m < grid_->size(); ++m) {
    if (!(use(points, m) < relaxed_[m])) return false;
  }
  return true;
}

// Lets each interval use so much more than it does; false: none uses more than its share.
bool SpeedOptimum::relax() {
  bool is_any = false;
  for (std::size_t m = 0; m < grid_->size(); ++m) {
    const double used = use(spline_->points(), m);
    relaxed_[m] = used < settled ? 1.0
                                 : std::min(relaxed_[m],
                                            used + room * (std::max(used - 1.0, 0.0) + least_room));
    is_any = is_any || relaxed_[m] > 1.0;
  }
  return is_any;
}

// Of a control point; its neighbours' because the speed between them is a mean of theirs.
double SpeedOptimum::top(std::size_t m) const {
  return (*shares_)[m].speed * std::min({grid_->top(m - 1), grid_->top(m), grid_->top(m + 1)});
}

void SpeedOptimum::spread(const Derivatives& local, const SpeedSpline::Weights& w, std::size_t m) {
  const auto& [bb, b1, b2, d11, d12, d22] = local.second;
  for (std::size_t i = 0; i < 3; ++i) {
    bands_[m + i].gradient += local.gradient[0] * w.value[i] + local.gradient[1] * w.first[i] +
                              local.gradient[2] * w.second[i];
    const double by_value = bb * w.value[i] + b1 * w.first[i] + b2 * w.second[i];
    const double by_first = b1 * w.value[i] + d11 * w.first[i] + d12 * w.second[i];
    const double by_second = b2 * w.value[i] + d12 * w.first[i] + d22 * w.second[i];
    for (std::size_t j = i; j < 3; ++j) {
      bands_[m + i].row[j - i] +=
          by_value * w.value[j] + by_first * w.first[j] + by_second * w.second[j];
    }
  }
}

// Derivatives of weight * time - sum of log(slack).
void SpeedOptimum::collect(double weight) {
  std::ranges::fill(bands_, Band{});
  const std::size_t n = grid_->size();
  for (std::size_t m = 0; m < n; ++m) {
    const double share = relaxed_[m] * (*shares_)[m].force;
    const SquaredSpeed b = spline_->at(m, LimitGrid::middle);
    const double time = weight * grid_->length(m) / std::sqrt(b.value);
    Derivatives local;
    local.gradient[0] = -0.5 * time / b.value;
    local.second[0] = 0.75 * time / (b.value * b.value);
    for (const AxisRates& r : grid_->rates(m, LimitGrid::middle))
      add_acceleration(r, b, share, local);
    spread(local, spline_->weights(m, LimitGrid::middle), m);
    for (const LimitGrid::Place place : {LimitGrid::start, LimitGrid::end}) {
      Derivatives jerk;
      const SquaredSpeed side = spline_->at(m, place);
      for (const AxisRates& r : grid_->rates(m, place)) add_jerk(r, side, share, jerk);
      spread(jerk, spline_->weights(m, place), m);
    }
    if (m == 0 || m + 1 == n) continue;
    const double slack = 1.0 / (relaxed_[m] * top(m) - spline_->points()[m + 1]);
    bands_[m + 1].gradient += slack;
    bands_[m + 1].row[0] += slack * slack;
  }
}

// Newton's step: the band of five as L D L^T. False: not positive, for rounding.
bool SpeedOptimum::solve() {
  const std::size_t first = 2;
  const std::size_t last = grid_->size();
  for (std::size_t i = first; i < last; ++i) {
    Pivot& p = pivots_[i];
    p = {.diagonal = bands_[i].row[0]};
    double right = -bands_[i].gradient;
    if (i >= first + 2) {
      p.far = bands_[i - 2].row[2] / pivots_[i - 2].diagonal;
      p.diagonal -= p.far * p.far * pivots_[i - 2].diagonal;
      right -= p.far * change_[i - 2];
    }
    if (i >= first + 1) {
      double near = bands_[i - 1].row[1];
      if (i >= first + 2) near -= p.far * pivots_[i - 2].diagonal * pivots_[i - 1].near;
      p.near = near / pivots_[i - 1].diagonal;
      p.diagonal -= p.near * p.near * pivots_[i - 1].diagonal;
      right -= p.near * change_[i - 1];
    }
    if (!(p.diagonal > 0.0)) return false;
    change_[i] = right;
  }
  for (std::size_t i = first; i < last; ++i) change_[i] /= pivots_[i].diagonal;
  for (std::size_t i = last; i-- > first;) {
    if (i + 1 < last) change_[i] -= pivots_[i + 1].near * change_[i + 1];
    if (i + 2 < last) change_[i] -= pivots_[i + 2].far * change_[i + 2];
  }
  return true;
}

double SpeedOptimum::decrement() const {
  double sum = 0.0;
  for (std::size_t i = 2; i < grid_->size(); ++i) sum -= bands_[i].gradient * change_[i];
  return std::sqrt(std::max(sum, 0.0));
}

// How often the change fits before a slack is gone.
double SpeedOptimum::longest_step() const {
  double quickest = 0.0;  // largest share of a slack that the change takes
  const std::size_t n = grid_->size();
  const auto takes = [&quickest](double slack, double falls) {
    if (falls > quickest * slack) quickest = falls / slack;
  };
  for (std::size_t m = 0; m < n; ++m) {
    const double share = relaxed_[m] * (*shares_)[m].force;
    const auto change = [&](LimitGrid::Place place) {
      return spline_->weights(m, place).of(change_.data() + m);
    };
    const SquaredSpeed b = spline_->at(m, LimitGrid::middle);
    const SquaredSpeed d = change(LimitGrid::middle);
    takes(b.value, -d.value);
    for (const AxisRates& r : grid_->rates(m, LimitGrid::middle)) {
      const double use = acceleration_use(r, b);
      const double more = acceleration_use(r, d);
      takes(share - use, more);
      takes(share + use, -more);
    }
    for (const LimitGrid::Place place : {LimitGrid::start, LimitGrid::end}) {
      const SquaredSpeed side = spline_->at(m, place);
      const SquaredSpeed differs = change(place);
      const JerkLimit limit = jerk_limit(share, side.value);
      const double falls = -limit.slope * differs.value;
      takes(side.value, -differs.value);
      for (const AxisRates& r : grid_->rates(m, place)) {
        const double use = jerk_use_over_speed(r, side);
        const double more = jerk_use_over_speed(r, differs);
        takes(limit.value - use, falls + more);
        takes(limit.value + use, falls - more);
      }
    }
    if (m > 0 && m + 1 < n) takes(relaxed_[m] * top(m) - spline_->points()[m + 1], change_[m + 1]);
  }
  return quickest > 0.0 ? 1.0 / quickest : unlimited;
}

// Within the limits by the tangents is within the true ones; what rounding leaves is caught here.
bool SpeedOptimum::step(double length) {
  constexpr int halvings = 20;
  std::vector<double>& points = spline_->points();
  for (int k = 0; k < halvings; ++k, length *= 0.5) {
    tried_ = points;
    for (std::size_t i = 2; i < grid_->size(); ++i) tried_[i] += length * change_[i];
    if (!is_within(tried_)) continue;
    points.swap(tried_);
    return true;
  }
  return false;
}

}  // namespace stanok::motion
