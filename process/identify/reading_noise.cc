#include "process/identify/reading_noise.h"

#include <algorithm>
#include <cmath>

namespace stanok::process {

double ReadingNoise::deviation_w(double cut_w) const {
  return std::hypot(idle_w, part * cut_w, model * cut_w);
}

double ReadingNoise::model_part() const {
  const double all = part * part + model * model;
  return all > 0.0 ? model * model / all : 0.0;
}

ReadingNoise noise_of(const std::vector<double>& rest_w, const std::vector<double>& cut_w) {
  constexpr double of_whole_watts = 0.3;
  constexpr double is_air = 0.001;  // of the greatest cut
  constexpr double is_cut = 0.1;
  const double most = cut_w.empty() ? 0.0 : *std::ranges::max_element(cut_w);
  double air_sum = 0.0;
  double air_count = 0.0;
  double part_sum = 0.0;
  double part_count = 0.0;
  for (std::size_t k = 0; k < rest_w.size(); ++k) {
    if (cut_w[k] < is_air * most) {
      air_sum += rest_w[k] * rest_w[k];
      air_count += 1.0;
    } else if (cut_w[k] > is_cut * most) {
      part_sum += rest_w[k] * rest_w[k] / (cut_w[k] * cut_w[k]);
      part_count += 1.0;
    }
  }
  return {
      .idle_w = std::max(of_whole_watts, air_count > 0.0 ? std::sqrt(air_sum / air_count) : 0.0),
      .part = part_count > 0.0 ? std::sqrt(part_sum / part_count) : 0.0};
}

}  // namespace stanok::process
