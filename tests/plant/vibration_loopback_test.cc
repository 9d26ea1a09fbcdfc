// A vibration sensor over a real connection: the samples are those of the process.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/plant/loopback.h"

namespace stanok::plant {
namespace {

TEST(VibrationLoopback, SamplesArriveWithoutAGapAndShowLevelAndFrequency) {
  drives::BusConfig bus = bus_of(1);
  bus.vibration_sensors = {{.spindle = 1, .unit = 60, .first_register = 8, .count = 120}};
  std::vector<SimulatedDriveConfig> drives = drives_of(bus_of(1), {});
  drives.push_back(spindle_drive(1, {}));
  ModbusServer server({.modules = {.signals = {}, .vibration = bus.vibration_sensors}}, drives);
  server.start();
  server.load(1, {.vibration_um = 20.0, .vibration_hz = 200.0});
  CycleSide cycle(bus, server.port());

  std::vector<double> samples;
  const auto status = [&] { return cycle.bus.status().vibration.at(0); };
  ASSERT_TRUE(cycle.until([&] {
    std::array<double, 256> fresh{};
    const std::size_t count = cycle.bus.read_vibration(0, fresh);
    samples.insert(samples.end(), fresh.begin(), fresh.begin() + static_cast<int>(count));
    return samples.size() > 6000 && status().level.amplitude_um > 19.0;
  }));
  EXPECT_EQ(status().sensor, "S1");
  EXPECT_NEAR(status().level.amplitude_um, 20.0, 0.1);
  EXPECT_NEAR(status().level.frequency_hz, 200.0, 3.0);
  EXPECT_EQ(status().errors, 0U);
  // Samples of a sine obey y[n+1] + y[n-1] = 2 cos(w T) y[n]; each is rounded to 0.1 um. Where
  // samples were lost, because the machine stood still for longer than a block, the two triples
  // across the gap do not; no other may be wrong.
  const double twice_cos = 2.0 * std::cos(2.0 * std::numbers::pi * 200.0 / 4000.0);
  std::uint64_t wrong = 0;
  for (std::size_t n = 3000; n + 1 < samples.size(); ++n)
    wrong += std::abs(samples[n + 1] + samples[n - 1] - twice_cos * samples[n]) > 0.21 ? 1U : 0U;
  EXPECT_LE(wrong, 2U * status().lost);
}

}  // namespace
}  // namespace stanok::plant
