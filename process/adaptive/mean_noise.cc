#include "process/adaptive/mean_noise.h"

#include <algorithm>
#include <cmath>

namespace stanok::process {
namespace {

// Of the differences that are kept; and the same of a normal distribution of deviation 1.
constexpr double quantile = 0.7;
constexpr double of_normal = 1.036;
// Of few differences the quantile may be too small by chance.
constexpr double doubt = 2.0;
// From one length to twice it the deviation of noise without memory falls by the root of 2.
constexpr double falling = 0.74;
constexpr double fallen = 0.8;  // seen of few differences
// What is slower is not waited for.
constexpr double known_s = 0.65;
constexpr double least = 1e-3;  // that counts as a standard deviation

}  // namespace

void MeanNoise::add(double value, double cycle_s) RT_SAFE {
  sum_ += value;
  time_s_ += cycle_s;
  ++values_;
  if (time_s_ < shortest_s - 0.5 * cycle_s) return;
  put(0, sum_ / values_);
  sum_ = time_s_ = 0.0;
  values_ = 0;
}

void MeanNoise::interrupt() RT_SAFE {
  sum_ = time_s_ = 0.0;
  values_ = 0;
  for (Length& length : lengths_) {
    length.before.reset();
    length.pending.reset();
  }
}

void MeanNoise::put(std::size_t k, double mean) RT_SAFE {
  while (k < lengths) {
    Length& length = lengths_[k];
    if (length.before) note(length, std::abs(mean - *length.before));
    length.before = mean;
    if (!length.pending) {
      length.pending = mean;
      return;
    }
    mean = 0.5 * (*length.pending + mean);
    length.pending.reset();
    ++k;
  }
}

void MeanNoise::note(Length& length, double difference) RT_SAFE {
  length.differences[length.count++ % kept] = difference;
  const std::size_t count = std::min(length.count, kept);
  std::array<double, kept> sorted = length.differences;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count);
  const auto at =
      sorted.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(count));
  std::nth_element(sorted.begin(), at, end);
  length.deviation = *at / of_normal;
  length.shortest_then +=
      (lengths_[0].deviation - length.shortest_then) / static_cast<double>(count);
}

std::optional<double> MeanNoise::difference(std::size_t k) const RT_SAFE {
  std::size_t known = std::min(k, lengths - 1);
  while (known > 0 && lengths_[known].count < known_after) --known;
  const Length& length = lengths_[known];
  if (length.count < known_after) return std::nullopt;
  const double count = static_cast<double>(std::min(length.count, kept));
  double deviation = length.deviation * (1.0 + doubt / count);
  if (known < k) {
    const bool falls = known > 0 && length.deviation <= fallen * lengths_[known - 1].deviation;
    if (!falls && length.deviation > least) return std::nullopt;
    deviation *= std::pow(falling, static_cast<double>(k - known));
  }
  const double then = std::max(length.shortest_then, least);
  return deviation * std::max(1.0, lengths_[0].deviation / then);
}

std::optional<double> MeanNoise::time_within(double most, double apart_s) const RT_SAFE {
  double shorter = 0.0;  // difference at half the length
  for (std::size_t k = 0; k < lengths; ++k) {
    const auto found = difference(k);
    if (!found) return std::nullopt;
    if (*found <= most) {
      const auto last = last_above(k, most, apart_s + length_s(k));
      if (!last) return std::nullopt;
      if (*last == k) return between(k, shorter, *found, most);
      k = *last;
    }
    shorter = difference(k).value_or(shorter);
  }
  return std::nullopt;
}

// Slow noise differs little over short times: the last length from k on, up to that time, over
// which means differ by more; k where there is none.
std::optional<std::size_t> MeanNoise::last_above(std::size_t k, double most, double time_s) const
    RT_SAFE {
  std::size_t last = k;
  for (std::size_t j = k + 1; j < lengths && length_s(j) <= time_s; ++j) {
    const auto found = difference(j);
    if (!found && length_s(j) <= known_s) return std::nullopt;
    if (found && *found > most) last = j;
  }
  return last;
}

// Between two lengths the square goes as a power of the time.
double MeanNoise::between(std::size_t k, double shorter, double found, double most) RT_SAFE {
  if (k == 0 || shorter <= most || shorter <= found) return length_s(k);
  return length_s(k - 1) * std::exp2(std::log(shorter / most) / std::log(shorter / found));
}

}  // namespace stanok::process
