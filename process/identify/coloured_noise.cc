#include "process/identify/coloured_noise.h"

#include <algorithm>
#include <cmath>

namespace stanok::process {
namespace {

constexpr double memory_max = 0.98;

// Which readings of the cut come as soon after another of the cut as most do.
std::vector<bool> following(const DriveRecord& record, const std::vector<std::size_t>& readings) {
  std::vector<bool> follows(readings.size(), false);
  std::size_t gap = 0;
  for (std::size_t k = 1; k < readings.size(); ++k) {
    const std::size_t now = readings[k] - readings[k - 1];
    follows[k] = record.cuts[readings[k]] && record.cuts[readings[k - 1]] &&
                 (gap == 0 || now <= gap + gap / 2);
    if (follows[k] && gap == 0) gap = now;
  }
  return follows;
}

// Of a noise with memory m, the variance of differences over two readings is 1 + m times that over
// one.
double memory_of(const std::vector<bool>& follows, const std::vector<double>& rest,
                 double model_part) {
  constexpr double pairs_least = 30.0;
  double one = 0.0;
  double two = 0.0;
  double count = 0.0;
  for (std::size_t k = 2; k < rest.size(); ++k) {
    if (!follows[k] || !follows[k - 1]) continue;
    one += 0.5 * (std::pow(rest[k] - rest[k - 1], 2) + std::pow(rest[k - 1] - rest[k - 2], 2));
    two += std::pow(rest[k] - rest[k - 2], 2);
    count += 1.0;
  }
  if (count < pairs_least || !(one > 0.0)) return 0.0;
  const double of_model = 2.0 * model_part * count;
  return std::clamp((two + of_model) / (one + of_model) - 1.0, 0.0, memory_max);
}

}  // namespace

ColouredNoise::ColouredNoise(const DriveRecord& record, const std::vector<std::size_t>& readings,
                             const std::vector<double>& deviation, const std::vector<double>& rest,
                             double model_part)
    : deviation_(deviation), follows_(following(record, readings)), model_part_(model_part) {
  std::vector<double> of_noise = rest;
  for (std::size_t k = 0; k < of_noise.size(); ++k) of_noise[k] /= deviation_[k];
  memory_ = memory_of(follows_, of_noise, model_part_);
}

std::vector<double> ColouredNoise::whitened(const std::vector<double>& values) const {
  const double is_new = std::sqrt(1.0 - memory_ * memory_);
  std::vector<double> white = values;
  for (std::size_t k = 0; k < white.size(); ++k) {
    white[k] = values[k] / deviation_[k];
    if (follows_[k]) white[k] = (white[k] - memory_ * values[k - 1] / deviation_[k - 1]) / is_new;
  }
  return white;
}

double ColouredNoise::variance_of_changes(const std::vector<double>& white) const {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 2; k < white.size(); ++k) {
    if (!follows_[k] || !follows_[k - 1]) continue;
    sum += 0.5 * std::pow(white[k] - white[k - 1], 2);
    count += 1.0;
  }
  return count > 0.0 && sum > 0.0 ? std::max(sum / count, model_part_) : 1.0;
}

}  // namespace stanok::process
