// TurningPlant: the power that a sensor shows of a turning cut, as a shop has it and no model says:
// with the force of the edge, an exponent of its own, wear, run-out, two lags, noise that is
// coloured, values that come now and then and in counts, and sensors that die or lose their gain.
//
// Worked out from its own formulas; knows nothing of what judges the power. Lengths in mm, forces
// in N, powers in W, times in s.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace stanok::testing {

struct TurningScene {
  double rev_per_min = 600.0;
  double radius_mm = 30.0;
  double efficiency = 0.85;
  double idle_w = 250.0;
  double coefficient = 1600.0;  // C of F = C t h^y
  double exponent = 0.75;       // y
  double edge_part = 0.0;       // of the force at h = 0.3 mm that does not depend on h
  double wear_per_s = 0.0;      // by which the force grows
  double run_out = 0.0;         // amplitude, part of the power of the cut
  double lag_s = 0.02;          // of the drive
  double second_lag_s = 0.0;    // of the sensor
  double sample_s = 0.01;
  double count_w = 1.0;
  double noise = 0.0;          // standard deviation, part of the power of the cut
  double correlation_s = 0.0;  // of the noise
};

class TurningPlant {
 public:
  TurningPlant(const TurningScene& scene, unsigned seed) : scene_(scene), random_(seed) {}

  // A period at this feed; the power as the sensor shows it then.
  double advance(double feed_per_s, double cycle_s) {
    time_s_ += cycle_s;
    const double turns_per_s = scene_.rev_per_min / 60.0;
    chip(feed_per_s, turns_per_s, cycle_s);
    force_n_ = force(thickness_mm_);
    const double omega = 2.0 * std::numbers::pi * turns_per_s;
    const double cut_w = force_n_ * omega * scene_.radius_mm * 1e-3 / scene_.efficiency;
    first_w_ += (cut_w - first_w_) * std::min(1.0, cycle_s / scene_.lag_s);
    second_w_ += (first_w_ - second_w_) *
                 (scene_.second_lag_s > cycle_s ? cycle_s / scene_.second_lag_s : 1.0);
    follow_noise(cycle_s);
    since_sample_s_ += cycle_s;
    if (since_sample_s_ < scene_.sample_s - 0.5 * cycle_s) return shown_w_;
    since_sample_s_ = 0.0;
    const double ripple = scene_.run_out * std::sin(omega * time_s_);
    const double sound_w = second_w_ * (1.0 + ripple + noise_);
    const double sensed_w = sensor ? sensor(sound_w, second_w_ * noise_) : sound_w;
    shown_w_ = scene_.count_w * std::round((scene_.idle_w + sensed_w) / scene_.count_w);
    return shown_w_;
  }

  [[nodiscard]] double force_n() const { return force_n_; }
  [[nodiscard]] double time_s() const { return time_s_; }
  // Mean power of the cut, without noise.
  [[nodiscard]] double cut_w() const { return second_w_; }
  // Force at a feed per revolution that lasts.
  [[nodiscard]] double force(double thickness_mm) const {
    constexpr double usual_mm = 0.3;
    if (depth_mm <= 0.0 || thickness_mm <= 0.0) return 0.0;
    const double at_usual = std::pow(usual_mm, scene_.exponent);
    const double shear = (1.0 - scene_.edge_part) * std::pow(thickness_mm, scene_.exponent);
    return scene_.coefficient * depth_mm * hardness * (1.0 + scene_.wear_per_s * time_s_) *
           (scene_.edge_part * at_usual + shear);
  }

  double depth_mm = 0.0;
  double hardness = 1.0;
  // What it shows of the power of the cut, and of its noise.
  std::function<double(double power_w, double noise_w)> sensor;

 private:
  // The mean way over the last revolution, by twenty parts of it.
  void chip(double feed_per_s, double turns_per_s, double cycle_s) {
    angle_ += turns_per_s * cycle_s;
    way_ += feed_per_s * cycle_s;
    while (angle_ >= 1.0 / parts) {
      angle_ -= 1.0 / parts;
      thickness_mm_ += way_ - ways_[next_];
      ways_[next_] = way_;
      way_ = 0.0;
      next_ = (next_ + 1) % parts;
    }
  }
  void follow_noise(double cycle_s) {
    if (scene_.noise <= 0.0) return;
    if (scene_.correlation_s <= 0.0) {
      if (since_sample_s_ == 0.0) noise_ = scene_.noise * gauss_(random_);
      return;
    }
    const double kept = std::exp(-cycle_s / scene_.correlation_s);
    noise_ = kept * noise_ + std::sqrt(1.0 - kept * kept) * scene_.noise * gauss_(random_);
  }

  static constexpr int parts = 20;
  TurningScene scene_;
  std::mt19937 random_;
  std::normal_distribution<double> gauss_{0.0, 1.0};
  double ways_[parts] = {};
  int next_ = 0;
  double angle_ = 0.0;
  double way_ = 0.0;
  double thickness_mm_ = 0.0;
  double force_n_ = 0.0;
  double first_w_ = 0.0;
  double second_w_ = 0.0;
  double noise_ = 0.0;
  double since_sample_s_ = 0.0;
  double shown_w_ = 0.0;
  double time_s_ = 0.0;
};

}  // namespace stanok::testing
