// Counts of a bus for operators: exchanges, errors by kind, percentiles of the round-trip time.
//
// Times are kept in a histogram of eight buckets per octave, so a percentile is exact to 9 %.
// Not synchronised: the bus that owns it does that.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "drives/bus.h"

namespace stanok::drives {

class RoundTripHistogram {
 public:
  void add(std::chrono::nanoseconds time);

  // Upper edge of the bucket that holds the given share (0..1) of all times, never above the
  // maximum; 0 when empty.
  [[nodiscard]] double percentile_us(double share) const;
  [[nodiscard]] RoundTrip summary() const;

 private:
  static constexpr std::size_t buckets_per_octave = 8;
  static constexpr std::size_t octaves = 25;  // 1 us to 33 s
  std::array<std::uint64_t, buckets_per_octave * octaves> counts_{};
  std::uint64_t total_ = 0;
  double max_us_ = 0.0;
};

}  // namespace stanok::drives
