// Histogram of durations with fixed memory: counts in buckets of constant relative width,
// percentiles out. Real-time safe to add to.
#pragma once

#include <array>
#include <cstdint>

#include "base/rt_safe.h"

namespace stanok {

// Durations in ns, from 1 ns to about 70 s; buckets 1/16 of an octave wide (4.4 %).
class Histogram {
 public:
  void add(std::int64_t nanoseconds) RT_SAFE {
    const std::uint64_t value = nanoseconds < 1 ? 1 : static_cast<std::uint64_t>(nanoseconds);
    ++counts_[bucket_of(value)];
    ++total_;
    if (nanoseconds > max_) max_ = nanoseconds;
  }
  [[nodiscard]] std::uint64_t count() const RT_SAFE { return total_; }
  [[nodiscard]] std::int64_t max() const RT_SAFE { return max_; }
  // Upper edge of the bucket below which `share` (0..1) of all values lie, in ns; 0 when empty.
  [[nodiscard]] std::int64_t percentile(double share) const RT_SAFE {
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(total_));
    std::uint64_t seen = 0;
    for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
      seen += counts_[bucket];
      if (counts_[bucket] > 0 && seen >= wanted)
        return upper_edge(bucket) < max_ ? upper_edge(bucket) : max_;
    }
    return max_;
  }

 private:
  static constexpr unsigned steps_log2 = 4;
  static constexpr std::uint64_t steps = 1U << steps_log2;
  static constexpr std::size_t octaves = 36;

  static std::size_t bucket_of(std::uint64_t value) RT_SAFE {
    if (value < steps) return value;
    unsigned shift = 0;
    while (value >> shift >= 2 * steps) ++shift;
    const std::size_t bucket = (shift + 1) * steps + ((value >> shift) - steps);
    return bucket < octaves * steps ? bucket : octaves * steps - 1;
  }
  static std::int64_t upper_edge(std::size_t bucket) RT_SAFE {
    if (bucket < steps) return static_cast<std::int64_t>(bucket);
    const std::size_t shift = bucket / steps - 1;
    return static_cast<std::int64_t>(((bucket % steps + steps + 1) << shift) - 1);
  }

  std::array<std::uint64_t, octaves * steps> counts_{};
  std::uint64_t total_ = 0;
  std::int64_t max_ = 0;
};

}  // namespace stanok
