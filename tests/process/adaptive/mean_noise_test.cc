// By how much means differ by chance: against the formula of white noise, that of noise with a
// memory, and against steps, which are none.
#include "process/adaptive/mean_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stanok::process {
namespace {

constexpr double value_s = 0.001;

// Values that stand for `sample_s`, white or with a memory.
class Signal {
 public:
  Signal(unsigned seed, double deviation, double sample_s, double memory_s = 0.0)
      : random_(seed),
        deviation_(deviation),
        sample_s_(sample_s),
        kept_(memory_s > 0.0 ? std::exp(-sample_s / memory_s) : 0.0) {}

  double next() {
    since_s_ += value_s;
    if (since_s_ >= sample_s_ - 0.5 * value_s) {
      since_s_ = 0.0;
      value_ = kept_ * value_ + std::sqrt(1.0 - kept_ * kept_) * deviation_ * gauss_(random_);
    }
    return value_;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> gauss_{0.0, 1.0};
  double deviation_;
  double sample_s_;
  double kept_;
  double since_s_ = 0.0;
  double value_ = 0.0;
};

void listen(MeanNoise& noise, Signal& signal, double seconds) {
  for (int k = 0; k < static_cast<int>(seconds / value_s); ++k) noise.add(signal.next(), value_s);
}

// Two means of n independent values differ by deviation sqrt (2 / n).
TEST(MeanNoise, OfWhiteNoiseFallsWithTheRootOfTheTime) {
  constexpr unsigned seeds = 40;
  for (std::size_t k = 0; k <= 5; ++k) {
    const double expected = 0.05 * std::sqrt(2.0 * 0.01 / MeanNoise::length_s(k));
    double sum = 0.0;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      MeanNoise noise;
      Signal signal(seed, 0.05, 0.01);
      listen(noise, signal, 40.0);
      const double found = noise.difference(k).value_or(0.0);
      EXPECT_GT(found, 0.35 * expected) << "seed " << seed;
      EXPECT_LT(found, 2.8 * expected) << "seed " << seed;
      sum += found;
    }
    EXPECT_GT(sum / seeds, 0.9 * expected) << MeanNoise::length_s(k);
    EXPECT_LT(sum / seeds, 1.6 * expected) << MeanNoise::length_s(k);
  }
}

// From the formula of white noise: 2 sample_s (deviation / most)^2.
TEST(MeanNoise, TheTimeGoesWithTheSquareOfTheNoise) {
  constexpr unsigned seeds = 40;
  double log_sum = 0.0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    MeanNoise noise;
    Signal signal(seed, 0.05, 0.01);
    listen(noise, signal, 40.0);
    const double most = 0.05 * std::sqrt(2.0 * 0.01 / 0.5);
    log_sum += std::log(noise.time_within(most, 0.1).value_or(1e3) / 0.5);
  }
  EXPECT_GT(log_sum / seeds, std::log(0.7));
  EXPECT_LT(log_sum / seeds, std::log(2.5));
}

// Over times that are short against its memory noise hardly changes: means of 40 ms differ by less
// than those of 0.6 s, and the time of short ones is not taken for enough.
TEST(MeanNoise, OfNoiseWithAMemoryIsNotTakenForSmallOverShortTimes) {
  MeanNoise noise;
  Signal signal(3, 0.05, 0.001, 0.2);
  listen(noise, signal, 120.0);
  EXPECT_LT(*noise.difference(0), *noise.difference(4));
  EXPECT_GT(noise.time_within(1.1 * *noise.difference(0), 0.5).value_or(99.0), 0.6);
}

TEST(MeanNoise, KnowsNothingAtFirstAndNothingOfASignalThatStands) {
  MeanNoise noise;
  EXPECT_FALSE(noise.difference(0));
  EXPECT_FALSE(noise.time_within(0.01, 0.0));
  for (int k = 0; k < 2000; ++k) noise.add(1.0, value_s);
  EXPECT_EQ(noise.difference(0), 0.0);
  EXPECT_EQ(noise.time_within(0.01, 0.0), MeanNoise::shortest_s);
}

TEST(MeanNoise, PassesOverStepsOfTheCut) {
  MeanNoise steady;
  MeanNoise stepped;
  Signal signal(7, 0.02, 0.01);
  for (int k = 0; k < 40'000; ++k) {
    const double value = signal.next();
    steady.add(value, value_s);
    stepped.add(value + 0.5 * static_cast<double>((k / 5000) % 2), value_s);
  }
  for (std::size_t k = 0; k <= 3; ++k)
    EXPECT_LT(*stepped.difference(k), 2.0 * *steady.difference(k));
}

TEST(MeanNoise, RisesAtOnceWithWhatTheShortestMeansShow) {
  MeanNoise noise;
  Signal quiet(1, 0.01, 0.01);
  listen(noise, quiet, 60.0);
  const double before = *noise.difference(5);
  Signal loud(2, 0.1, 0.01);
  listen(noise, loud, 0.7);
  EXPECT_GT(*noise.difference(5), 3.0 * before);
}

TEST(MeanNoise, AnInterruptionIsNoDifference) {
  MeanNoise noise;
  for (int k = 0; k < 20; ++k) {
    noise.interrupt();
    for (int n = 0; n < 100; ++n) noise.add(static_cast<double>(k), value_s);
  }
  EXPECT_EQ(noise.difference(0), 0.0);
}

}  // namespace
}  // namespace stanok::process
