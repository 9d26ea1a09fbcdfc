// An autoregression of first order, made here.
#include "process/identify/coloured_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace stanok::process {
namespace {

constexpr std::size_t readings_of_series = 4000;

std::vector<double> remembering_noise(double memory, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  std::vector<double> noise{gauss(random)};
  while (noise.size() < readings_of_series)
    noise.push_back(memory * noise.back() + std::sqrt(1.0 - memory * memory) * gauss(random));
  return noise;
}

ColouredNoise noise_of_series(const std::vector<double>& rest) {
  DriveRecord record;
  std::vector<std::size_t> readings;
  for (std::size_t row = 0; row < rest.size(); ++row) {
    record.rev_per_min.push_back(1000.0);
    record.power_w.push_back(1000.0 + rest[row]);
    record.cuts.push_back(true);
    readings.push_back(row);
  }
  return {record, readings, std::vector<double>(rest.size(), 1.0), rest};
}

double lag_one(const std::vector<double>& values) {
  double product = 0.0;
  double square = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    product += values[k] * values[k - 1];
    square += values[k] * values[k];
  }
  return product / square;
}

// Four thousand readings tell a memory to about 0.02, differences of them to twice that; of a
// memory of 0.9 that is a third of the variance that is new in each reading.
TEST(ColouredNoise, FindsWhatReadingsRemember) {
  for (const double memory : {0.0, 0.5, 0.9}) {
    const std::vector<double> noise = remembering_noise(memory, 21);
    const ColouredNoise found = noise_of_series(noise);
    EXPECT_NEAR(found.memory(), memory, 0.1);
    EXPECT_NEAR(lag_one(found.whitened(noise)), 0.0, 0.1);
    EXPECT_NEAR(found.variance_of_changes(found.whitened(noise)), 1.0, 0.35);
  }
}

// A step of ten times the noise is none of it.
TEST(ColouredNoise, TakesNoStepForMemory) {
  std::vector<double> noise = remembering_noise(0.0, 22);
  for (std::size_t k = noise.size() / 2; k < noise.size(); ++k) noise[k] += 10.0;
  EXPECT_LT(noise_of_series(noise).memory(), 0.1);
}

}  // namespace
}  // namespace stanok::process
