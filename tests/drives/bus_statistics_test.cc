// Percentiles of the round-trip histogram against sorted samples.
#include "drives/bus_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace stanok::drives {
namespace {

TEST(RoundTripHistogram, IsZeroWhenEmpty) {
  const RoundTrip summary = RoundTripHistogram{}.summary();
  EXPECT_EQ(summary.p50_us, 0.0);
  EXPECT_EQ(summary.max_us, 0.0);
}

TEST(RoundTripHistogram, PercentilesAreExactToABucket) {
  const unsigned seed = 8;
  std::mt19937 random(seed);
  std::lognormal_distribution<double> times_us(std::log(50.0), 1.0);
  RoundTripHistogram histogram;
  std::vector<double> samples;
  for (int i = 0; i < 20001; ++i) {
    const auto time =
        std::chrono::nanoseconds{static_cast<std::int64_t>(1e3 * (1.0 + times_us(random)))};
    histogram.add(time);
    samples.push_back(static_cast<double>(time.count()) * 1e-3);
  }
  std::sort(samples.begin(), samples.end());
  const double bucket = std::exp2(1.0 / 8.0);  // eight buckets per octave
  for (const double share : {0.5, 0.9, 0.99}) {
    const double exact = samples[static_cast<std::size_t>(share * 20000.0)];
    EXPECT_GE(histogram.percentile_us(share), exact) << share << ", seed " << seed;
    EXPECT_LE(histogram.percentile_us(share), exact * bucket) << share << ", seed " << seed;
  }
  EXPECT_EQ(histogram.summary().max_us, samples.back());
}

TEST(ExchangeErrorNames, AreDistinct) {
  EXPECT_EQ(name_of(ExchangeError::not_connected), "not_connected");
  EXPECT_EQ(name_of(ExchangeError::stuck), "stuck");
  EXPECT_EQ(name_of(ExchangeError::implausible), "implausible");
}

}  // namespace
}  // namespace stanok::drives
