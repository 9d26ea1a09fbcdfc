// A lathe whose figures the fit has to find: a bar of three depths cut angle by angle at two speeds
// with feeds that change, and a power sensor with all that sensors have. It knows nothing of the
// fit.
//
//   power = idle + L2[ L1[ (C t h^y + K_e t) w R ] ] (1 + n)
// L1, L2: lags of first order. n: noise that forgets itself within `noise_memory_s`. The sensor
// adds white noise, clips, rounds to its step, and shows a value each sampling period, which is up
// to one period old.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace stanok::testing {

struct BarLathe {
  double coefficient_n = 2000.0;  // C / eta
  double exponent = 0.75;
  double lag_s = 0.03;
  double second_lag_s = 0.0;
  double idle_linear = 0.2;
  double idle_square = 1e-4;
  double edge_n_per_mm = 0.0;  // K_e / eta
  // Of the cutting power, standard deviation.
  double noise = 0.05;
  double noise_memory_s = 0.0;
  // The sensor.
  double sensor_noise_w = 1.0;
  double step_w = 1.0;
  double power_max_w = 1e9;
  int sampling_cycles = 10;
  double age_s = 0.0;         // of what it shows
  double dead_until_s = 0.0;  // before, it shows 0
  // What the stock does not say: force over that of the bar, from this z on to smaller z.
  struct Section {
    double z_mm = 0.0;
    double force = 1.0;
  };
  std::vector<Section> sections{};
  double wear = 0.0;  // growth of the force until the end of the record
  std::vector<double> feeds_mm{0.12, 0.3, 0.2, 0.4};

  [[nodiscard]] double idle_w(double rev_per_min) const {
    return rev_per_min * (idle_linear + idle_square * rev_per_min);
  }
};

inline constexpr double cycle_of_lathe_s = 0.001;

// One cycle: what the log knows, and what the sensor showed at its end (not a number: nothing new).
struct LatheRow {
  double rev_per_min = 0.0;
  double radius_mm = 0.0;
  double depth_mm = 0.0;
  double travel_mm = 0.0;
  double z_mm = 0.0;
  double power_w = 0.0;
};

inline constexpr double radius_of_bar_mm = 30.0;
inline constexpr double length_of_bar_mm = 21.0;
inline constexpr double lathe_air_s = 1.0;
inline constexpr double feed_lasts_s = 0.6;
inline constexpr std::size_t lathe_angles = 180;
inline constexpr int steps_of_cycle = 5;
inline constexpr double step_of_lathe_s = cycle_of_lathe_s / steps_of_cycle;

inline double depth_of_bar(double z_mm) {
  if (z_mm >= 0.0) return 0.0;
  return z_mm > -7.0 ? 1.5 : z_mm > -14.0 ? 3.0 : 2.0;
}

// Force per mm of depth behind the tool, the surface of the turn before kept by angle.
class BarTurning {
 public:
  explicit BarTurning(const BarLathe& lathe) : lathe_(lathe) {}

  void next_pass() {
    cut_at_.fill(0.0);
    z_mm_ = 2.0;
    force_n_ = 0.0;
  }
  [[nodiscard]] double z_mm() const { return z_mm_; }

  // The power after a step of time, behind both lags.
  double advance(double feed_mm_per_s, double rev_per_min, double worn) {
    z_mm_ -= feed_mm_per_s * step_of_lathe_s;
    const double before = angle_;
    angle_ += rev_per_min / 60.0 * step_of_lathe_s;
    for (auto a = index(before); a < index(angle_); ++a) {
      double& at = cut_at_[a % lathe_angles];
      const double h = std::max(0.0, std::min(at, 0.0) - z_mm_);
      at = z_mm_;
      force_n_ =
          h > 0.0 ? depth_of_bar(z_mm_) * worn * hardness() *
                        (lathe_.coefficient_n * std::pow(h, lathe_.exponent) + lathe_.edge_n_per_mm)
                  : 0.0;
    }
    if (angle_ >= 1.0) angle_ -= 1.0;
    const double wanted =
        force_n_ * 2.0 * std::numbers::pi * rev_per_min / 60.0 * radius_of_bar_mm * 1e-3;
    first_w_ += (wanted - first_w_) * part(lathe_.lag_s);
    second_w_ += (first_w_ - second_w_) * part(lathe_.second_lag_s);
    return second_w_;
  }

 private:
  static std::size_t index(double angle) { return static_cast<std::size_t>(angle * lathe_angles); }
  static double part(double lag_s) {
    return lag_s > 0.0 ? 1.0 - std::exp(-step_of_lathe_s / lag_s) : 1.0;
  }
  [[nodiscard]] double hardness() const {
    double force = 1.0;
    for (const BarLathe::Section& section : lathe_.sections)
      if (z_mm_ <= section.z_mm) force = section.force;
    return force;
  }

  const BarLathe& lathe_;
  std::array<double, lathe_angles> cut_at_{};
  double angle_ = 0.0;
  double z_mm_ = 2.0;
  double force_n_ = 0.0;
  double first_w_ = 0.0;
  double second_w_ = 0.0;
};

// The rows without readings, and the power of the cut at each step of time.
struct BarCut {
  std::vector<LatheRow> rows;
  std::vector<double> cut_w;
};

inline BarCut cut_of_lathe(const BarLathe& lathe) {
  constexpr double usual_duration_s = 14.0;  // over which the wear is told
  BarCut cut;
  BarTurning turning(lathe);
  for (const double rev_per_min : {700.0, 1100.0}) {
    turning.next_pass();
    for (double t = 0.0; turning.z_mm() > -length_of_bar_mm; t += cycle_of_lathe_s) {
      const auto place = static_cast<std::size_t>(std::max(0.0, t - lathe_air_s) / feed_lasts_s);
      const double feed = t < lathe_air_s
                              ? 0.0
                              : lathe.feeds_mm[place % lathe.feeds_mm.size()] * rev_per_min / 60.0;
      const double worn = 1.0 + lathe.wear * static_cast<double>(cut.rows.size()) *
                                    cycle_of_lathe_s / usual_duration_s;
      for (int k = 0; k < steps_of_cycle; ++k)
        cut.cut_w.push_back(turning.advance(feed, rev_per_min, worn));
      cut.rows.push_back({.rev_per_min = rev_per_min,
                          .radius_mm = radius_of_bar_mm,
                          .depth_mm = depth_of_bar(turning.z_mm()),
                          .travel_mm = feed * cycle_of_lathe_s,
                          .z_mm = turning.z_mm(),
                          .power_w = std::numeric_limits<double>::quiet_NaN()});
    }
  }
  return cut;
}

inline bool lathe_shows(const BarLathe& lathe, std::size_t row) {
  const auto period = static_cast<std::size_t>(lathe.sampling_cycles);
  return row % period == period - 1;
}

// Of the cut, as old as the sensor shows it at the end of a cycle.
inline double sampled_w(const BarLathe& lathe, const BarCut& cut, std::size_t row) {
  const auto end = static_cast<double>((row + 1) * steps_of_cycle - 1);
  return cut.cut_w[static_cast<std::size_t>(std::max(0.0, end - lathe.age_s / step_of_lathe_s))];
}

using LatheFigures = Eigen::Matrix<double, 5, 1>;  // ln C, y, lag, a and b

// What the sensor would show of them without noise.
inline std::vector<double> lathe_shown(BarLathe lathe, const LatheFigures& figures) {
  lathe.coefficient_n = std::exp(figures[0]);
  lathe.exponent = figures[1];
  lathe.lag_s = figures[2];
  lathe.idle_linear = figures[3];
  lathe.idle_square = figures[4];
  const BarCut cut = cut_of_lathe(lathe);
  std::vector<double> all;
  for (std::size_t row = 0; row < cut.rows.size(); ++row)
    if (lathe_shows(lathe, row))
      all.push_back(lathe.idle_w(cut.rows[row].rev_per_min) + sampled_w(lathe, cut, row));
  return all;
}

// What the readings tell of the figures: the slopes are divided by the noise of the lathe, whose
// state is what the noise remembers (R. Kalman, J. Basic Eng. 82 (1960) 35).
inline Eigen::Matrix<double, 5, 5> lathe_information(const BarLathe& lathe,
                                                     const std::vector<double>& cut_w,
                                                     const std::vector<LatheFigures>& slopes) {
  const double period_s = lathe.sampling_cycles * cycle_of_lathe_s;
  const double memory =
      lathe.noise_memory_s > 0.0 ? std::exp(-period_s / lathe.noise_memory_s) : 0.0;
  const double white =
      lathe.sensor_noise_w * lathe.sensor_noise_w + lathe.step_w * lathe.step_w / 12.0;
  Eigen::Matrix<double, 5, 5> sum = Eigen::Matrix<double, 5, 5>::Zero();
  LatheFigures state = LatheFigures::Zero();
  double variance = lathe.noise * lathe.noise;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const double of_reading = cut_w[k] * cut_w[k] * variance + white;
    const LatheFigures rest = slopes[k] - cut_w[k] * state;
    sum += rest * rest.transpose() / of_reading;
    const double gain = variance * cut_w[k] / of_reading;
    state = memory * (state + gain * rest);
    variance = memory * memory * variance * (1.0 - gain * cut_w[k]) +
               (1.0 - memory * memory) * lathe.noise * lathe.noise;
  }
  return sum;
}

[[nodiscard]] inline std::vector<LatheRow> cut_bar(const BarLathe& lathe, std::mt19937& random) {
  std::normal_distribution<double> gauss(0.0, 1.0);
  BarCut cut = cut_of_lathe(lathe);
  const double period_s = lathe.sampling_cycles * cycle_of_lathe_s;
  const double memory =
      lathe.noise_memory_s > 0.0 ? std::exp(-period_s / lathe.noise_memory_s) : 0.0;
  double noise = gauss(random);
  for (std::size_t row = 0; row < cut.rows.size(); ++row) {
    if (!lathe_shows(lathe, row)) continue;
    noise = memory * noise + std::sqrt(1.0 - memory * memory) * gauss(random);
    const double power_w = lathe.idle_w(cut.rows[row].rev_per_min) +
                           sampled_w(lathe, cut, row) * (1.0 + lathe.noise * noise) +
                           lathe.sensor_noise_w * gauss(random);
    const double clipped = std::min(power_w, lathe.power_max_w);
    const bool is_dead = static_cast<double>(row) * cycle_of_lathe_s < lathe.dead_until_s;
    cut.rows[row].power_w = is_dead ? 0.0 : std::round(clipped / lathe.step_w) * lathe.step_w;
  }
  return cut.rows;
}

// Standard deviations that no unbiased estimate from this record can fall below (Cramer, Rao): of
// ln C, y, lag, idle_linear, idle_square; from the slopes of the lathe itself and the covariance of
// its noise. In the lag, that it is not known how old a reading is.
struct LeastDeviations {
  double ln_coefficient = 0.0;
  double exponent = 0.0;
  double lag_s = 0.0;
  double idle_linear = 0.0;
  double idle_square = 0.0;
};

[[nodiscard]] inline LeastDeviations least_deviations(const BarLathe& lathe) {
  const LatheFigures truth{std::log(lathe.coefficient_n), lathe.exponent, lathe.lag_s,
                           lathe.idle_linear, lathe.idle_square};
  const LatheFigures change{1e-3, 1e-3, 1e-3 * lathe.lag_s, 1e-3, 1e-6};
  std::vector<double> cut_w = lathe_shown(lathe, truth);
  LatheFigures without = truth;
  without[0] = -50.0;
  const std::vector<double> idle_w = lathe_shown(lathe, without);
  for (std::size_t n = 0; n < cut_w.size(); ++n) cut_w[n] -= idle_w[n];
  std::vector<LatheFigures> slopes(cut_w.size());
  for (Eigen::Index k = 0; k < truth.size(); ++k) {
    LatheFigures above = truth;
    LatheFigures below = truth;
    above[k] += change[k];
    below[k] -= change[k];
    const std::vector<double> high = lathe_shown(lathe, above);
    const std::vector<double> low = lathe_shown(lathe, below);
    for (std::size_t n = 0; n < slopes.size(); ++n)
      slopes[n][k] = (high[n] - low[n]) / (2.0 * change[k]);
  }
  const Eigen::Matrix<double, 5, 5> told = lathe_information(lathe, cut_w, slopes);
  const LatheFigures scale = told.diagonal().cwiseSqrt();
  const Eigen::Matrix<double, 5, 5> scaled = told.cwiseQuotient(scale * scale.transpose());
  const LatheFigures least = scaled.inverse().diagonal().cwiseSqrt().cwiseQuotient(scale);
  const double period_s = lathe.sampling_cycles * cycle_of_lathe_s;
  return {.ln_coefficient = least[0],
          .exponent = least[1],
          .lag_s = std::hypot(least[2], period_s / std::sqrt(12.0)),
          .idle_linear = least[3],
          .idle_square = least[4]};
}

}  // namespace stanok::testing
