// Samples of a vibration sensor: none twice, losses counted.
#include "drives/vibration.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stanok::drives
