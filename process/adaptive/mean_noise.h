// MeanNoise: by how much the means of a noisy signal over two stretches of equal length differ by
// chance, for lengths from 40 ms to 20 s.
//
// It is measured and not worked out from single values, since noise may be coloured: a quantile of
// the last differences between neighbouring means, as of a normal distribution (so measured, the
// mean square is twice the Allan variance). A cut that changes makes some great differences, which
// a quantile passes over. Where the shortest means begin to differ more than they did, all others
// are taken to do so. Part of the process observer of a channel, in the cycle; allocates nothing.
// Invariant: a length is known after `known_after` differences.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/rt_safe.h"

namespace stanok::process {

class MeanNoise {
 public:
  static constexpr std::size_t lengths = 10;
  static constexpr double shortest_s = 0.04;

  [[nodiscard]] static constexpr double length_s(std::size_t k) RT_SAFE {
    return shortest_s * static_cast<double>(std::size_t{1} << k);
  }

  // The next value, once a cycle, in parts of what it is usually.
  void add(double value, double cycle_s) RT_SAFE;
  // What was not added up to a whole stretch counts no more; what is known stays.
  void interrupt() RT_SAFE;

  // Standard deviation of the difference of two means over stretches of length k.
  [[nodiscard]] std::optional<double> difference(std::size_t k) const RT_SAFE;
  // The shortest time over which two means differ by no more than that although their stretches
  // are so far apart, s; none: not known yet, or longer than the longest.
  [[nodiscard]] std::optional<double> time_within(double difference, double apart_s) const RT_SAFE;

 private:
  static constexpr std::size_t known_after = 4;
  static constexpr std::size_t kept = 15;
  struct Length {
    std::optional<double> before;   // mean of the stretch before
    std::optional<double> pending;  // first half of one twice as long
    std::array<double, kept> differences{};
    std::size_t count = 0;       // so far
    double deviation = 0.0;      // of the differences that are kept
    double shortest_then = 0.0;  // the deviation of the shortest at the same times
  };
  void put(std::size_t k, double mean) RT_SAFE;
  void note(Length& length, double difference) RT_SAFE;
  [[nodiscard]] std::optional<std::size_t> last_above(std::size_t k, double most,
                                                      double time_s) const RT_SAFE;
  [[nodiscard]] static double between(std::size_t k, double shorter, double found, double most)
      RT_SAFE;

  std::array<Length, lengths> lengths_{};
  double sum_ = 0.0;
  double time_s_ = 0.0;
  int values_ = 0;
};

}  // namespace stanok::process
