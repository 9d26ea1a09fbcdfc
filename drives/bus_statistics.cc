// Names of the errors of an exchange, and the histogram of round-trip times.
#include "drives/bus_statistics.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"

namespace stanok::drives {

std::string_view name_of(ExchangeError error) {
  constexpr EnumArray<ExchangeError, std::string_view> names = {
      "not_connected", "timeout", "disconnected", "mangled",
      "exception",     "stuck",   "implausible",  "own_fault"};
  return names[error];
}

void RoundTripHistogram::add(std::chrono::nanoseconds time) {
  const double time_us = static_cast<double>(time.count()) * 1e-3;
  const double position = std::log2(std::max(time_us, 1.0)) * buckets_per_octave;
  const auto bucket = std::min(checked_size(position), counts_.size() - 1);
  ++counts_[bucket];
  ++total_;
  max_us_ = std::max(max_us_, time_us);
}

double RoundTripHistogram::percentile_us(double share) const {
  const double wanted = share * static_cast<double>(total_);
  std::uint64_t seen = 0;
  for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
    seen += counts_[bucket];
    if (seen > 0 && static_cast<double>(seen) >= wanted) {
      const double edge_us = std::exp2(static_cast<double>(bucket + 1) / buckets_per_octave);
      return std::min(edge_us, max_us_);
    }
  }
  return max_us_;
}

RoundTrip RoundTripHistogram::summary() const {
  return {.p50_us = percentile_us(0.5),
          .p90_us = percentile_us(0.9),
          .p99_us = percentile_us(0.99),
          .p999_us = percentile_us(0.999),
          .max_us = max_us_};
}

}  // namespace stanok::drives
