// What readings tell of their sensor.
#include "process/identify/sensor_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace stanok::process {
namespace {

// Two seconds of air at 200 W, two at 1000 W, two at 2000 W, with noise of 3 %; a reading each
// `period` cycles, in steps of 1 W.
DriveRecord sensed_record(std::size_t period) {
  std::mt19937 random(11);
  std::normal_distribution<double> gauss(0.0, 1.0);
  DriveRecord record;
  for (std::size_t row = 0; row < 6000; ++row) {
    const double cut_w = row < 2000 ? 0.0 : row < 4000 ? 800.0 : 1800.0;
    record.rev_per_min.push_back(1000.0);
    record.cuts.push_back(cut_w > 0.0);
    record.power_w.push_back(
        row % period == period - 1
            ? std::round(200.0 + cut_w * (1.0 + 0.03 * gauss(random)) + gauss(random))
            : std::numeric_limits<double>::quiet_NaN());
  }
  return record;
}

std::vector<double> cut_of_sensed() {
  std::vector<double> cut_w;
  for (std::size_t row = 0; row < 6000; ++row)
    cut_w.push_back(row < 2000 ? 0.0 : row < 4000 ? 700.0 : 1500.0);
  return cut_w;
}

FitVerdict verdict_of(const DriveRecord& record) {
  return check_sensor(record, sensor_traits(record), cut_of_sensed());
}

TEST(SensorCheck, FindsSamplingAndSteps) {
  const SensorTraits traits = sensor_traits(sensed_record(20));
  EXPECT_DOUBLE_EQ(traits.sampling_s, 0.02);
  EXPECT_DOUBLE_EQ(traits.step_w, 1.0);
  // Between the noise of both levels, 24 and 54 W.
  EXPECT_GT(traits.noise_w, 20.0);
  EXPECT_LT(traits.noise_w, 60.0);
  EXPECT_EQ(verdict_of(sensed_record(20)).state, FitState::fits);
}

// Each value stands for five readings: four of them tell nothing new.
TEST(SensorCheck, RepetitionsOfAValueAreNotReadings) {
  DriveRecord record = sensed_record(10);
  double shown = 0.0;
  for (std::size_t row = 0; row < record.power_w.size(); ++row) {
    if (!std::isfinite(record.power_w[row])) continue;
    if (row / 10 % 5 == 0) shown = record.power_w[row];
    record.power_w[row] = shown;
  }
  EXPECT_DOUBLE_EQ(sensor_traits(record).sampling_s, 0.05);
  EXPECT_EQ(reading_rows(without_repetitions(record)).size(), 120u);
}

TEST(SensorCheck, ReportsADeadSensor) {
  DriveRecord record = sensed_record(10);
  for (std::size_t row = 0; row < 1000; ++row)
    if (std::isfinite(record.power_w[row])) record.power_w[row] = 0.0;
  EXPECT_EQ(verdict_of(record).kind, Misfit::dead_sensor);
  record = sensed_record(10);
  for (std::size_t row = 3500; row < 4500; ++row)
    if (std::isfinite(record.power_w[row])) record.power_w[row] = 950.0;
  const FitVerdict stands = verdict_of(record);
  EXPECT_EQ(stands.kind, Misfit::dead_sensor);
  EXPECT_NE(stands.reason.find("950 W for 1.0 s from 3.5 s on"), std::string::npos)
      << stands.reason;
}

TEST(SensorCheck, ReportsTheEndOfItsRange) {
  DriveRecord record = sensed_record(10);
  for (double& power : record.power_w)
    if (power > 1900.0) power = 1900.0;
  EXPECT_EQ(verdict_of(record).kind, Misfit::saturated);
}

TEST(SensorCheck, ReportsCoarseSteps) {
  DriveRecord record = sensed_record(10);
  for (double& power : record.power_w) power = 250.0 * std::round(power / 250.0);
  EXPECT_EQ(verdict_of(record).kind, Misfit::coarse);
}

// A simulated cut has no noise: the power stands as long as the cut does.
TEST(SensorCheck, AQuietSensorIsNotDead) {
  DriveRecord record = sensed_record(10);
  const std::vector<double> cut_w = cut_of_sensed();
  for (std::size_t row = 0; row < record.power_w.size(); ++row)
    if (std::isfinite(record.power_w[row])) record.power_w[row] = 200.0 + std::round(cut_w[row]);
  EXPECT_EQ(verdict_of(record).state, FitState::fits) << verdict_of(record).reason;
}

}  // namespace
}  // namespace stanok::process
