// Samples of a vibration sensor: none twice, losses counted, level and frequency of a sine.
#include "drives/vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace stanok::drives {
namespace {

// A sensor whose n-th sample (from 0) is n modulo 1000.
class CountingSensor {
 public:
  explicit CountingSensor(int count) : count_(count) {}

  void take(int samples) { taken_ += samples; }
  [[nodiscard]] std::vector<std::uint16_t> block() const {
    std::vector<std::uint16_t> words = {static_cast<std::uint16_t>(taken_ & 0xFFFF)};
    for (int k = taken_ - count_; k < taken_; ++k)
      words.push_back(static_cast<std::uint16_t>(k < 0 ? 0 : k % 1000));
    return words;
  }
  [[nodiscard]] int taken() const { return taken_; }

 private:
  int count_;
  int taken_ = 0;
};

TEST(VibrationReader, TakesEverySampleOnceInItsOrderWhileBlocksOverlap) {
  const unsigned seed = 4;
  std::mt19937 random(seed);
  CountingSensor sensor(100);
  VibrationReader reader({.count = 100, .scale = 1.0});
  int next = 0;
  for (int poll = 0; poll < 3000; ++poll) {  // the count overflows more than once
    sensor.take(static_cast<int>(random() % 100));
    for (const double sample : reader.take(sensor.block())) ASSERT_EQ(sample, next++ % 1000);
    ASSERT_EQ(next, sensor.taken()) << "seed " << seed << ", poll " << poll;
  }
  EXPECT_EQ(reader.lost(), 0U);
  EXPECT_EQ(reader.samples(), static_cast<std::uint64_t>(next));
}

TEST(VibrationReader, CountsWhatWasOverwritten) {
  CountingSensor sensor(10);
  VibrationReader reader({.count = 10, .scale = 2.0});
  sensor.take(4);
  EXPECT_EQ(reader.take(sensor.block()).size(), 4U);
  sensor.take(25);
  const auto fresh = reader.take(sensor.block());
  ASSERT_EQ(fresh.size(), 10U);
  EXPECT_EQ(fresh[0], 19.0 / 2.0);
  EXPECT_EQ(reader.lost(), 15U);
  EXPECT_TRUE(reader.take(sensor.block()).empty()) << "nothing new";
}

TEST(VibrationReader, SamplesHaveASign) {
  VibrationReader reader({.count = 2, .scale = 10.0});
  const std::vector<std::uint16_t> block = {2, 0xFFFF, 0x8000};
  const auto fresh = reader.take(block);
  EXPECT_EQ(fresh[0], -0.1);
  EXPECT_EQ(fresh[1], -3276.8);
}

// A stretch of whole periods: the amplitude is exact, the frequency but for the straight lines
// between samples.
TEST(VibrationMeter, MeasuresASineOnAMeanValue) {
  const double rate = 4000.0;
  VibrationMeter meter(rate, 0.25);
  EXPECT_EQ(meter.level().amplitude_um, 0.0);
  std::vector<double> samples;
  for (int k = 0; k < 1000; ++k) {
    samples.push_back(5.0 + 12.5 * std::sin(2.0 * std::numbers::pi * 88.0 * k / rate + 0.3));
  }
  meter.add(std::span(samples).first(999));
  EXPECT_EQ(meter.level().amplitude_um, 0.0);
  meter.add(std::span(samples).last(1));
  EXPECT_NEAR(meter.level().amplitude_um, 12.5, 1e-9);
  EXPECT_NEAR(meter.level().frequency_hz, 88.0, 0.01);
}

// Over the range of self-oscillations of machine tools, at any phase.
TEST(VibrationMeter, MeasuresAnyFrequencyFrom20To400Hz) {
  const double rate = 4000.0;
  double amplitude_error = 0.0;
  double frequency_error = 0.0;
  for (int step = 0; step <= 44; ++step) {
    const double frequency = 20.0 * std::pow(1.07, step);  // to 393 Hz
    for (int turn = 0; turn < 9; ++turn) {
      const double phase = 0.7 * turn;
      VibrationMeter meter(rate, 0.25);
      std::vector<double> samples;
      for (int k = 0; k < 1000; ++k) {
        samples.push_back(9.0 * std::sin(2.0 * std::numbers::pi * frequency * k / rate + phase) -
                          3.0);
      }
      meter.add(samples);
      amplitude_error = std::max(amplitude_error, std::abs(meter.level().amplitude_um / 9.0 - 1.0));
      frequency_error =
          std::max(frequency_error, std::abs(meter.level().frequency_hz / frequency - 1.0));
    }
  }
  RecordProperty("amplitude_error_percent", std::to_string(100.0 * amplitude_error));
  RecordProperty("frequency_error_percent", std::to_string(100.0 * frequency_error));
  EXPECT_LE(amplitude_error, 0.05);
  EXPECT_LE(frequency_error, 0.02);
}

}  // namespace
}  // namespace stanok::drives
