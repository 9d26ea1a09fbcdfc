// The tip led through head and table (G43.4) near the pole of the tool axis: B through 0 while C
// turns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::IsEmpty;
using testing::MachineBench;

struct TipPosition {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

// p = Rz(C)^T (X + Ry(B) t) with t = (0, 0, -200): the table's centre is the zero of M, the tool
// has no length.
TipPosition tip_of(const ChannelOutput& channel) {
  const double b = channel.axes[3].position * std::numbers::pi / 180.0;
  const double c = channel.axes[4].position * std::numbers::pi / 180.0;
  const double x = channel.axes[0].position - 200.0 * std::sin(b);
  const double y = channel.axes[1].position;
  const double z = channel.axes[2].position - 200.0 * std::cos(b);
  return {std::cos(c) * x + std::sin(c) * y, -std::sin(c) * x + std::cos(c) * y, z};
}

double share_of_limits(const ChannelOutput& channel) {
  double share = 0.0;
  for (std::size_t k = 0; k < 5; ++k) {
    const bool rotary = k > 2;
    const AxisSetpoint& axis = channel.axes[k];
    share = std::max({share, std::abs(axis.velocity) / (rotary ? 120.0 : 250.0),
                      std::abs(axis.acceleration) / (rotary ? 1200.0 : 2500.0),
                      std::abs(axis.jerk) / (rotary ? 24000.0 : 50000.0)});
  }
  return share;
}

TEST(TipControl, ALineStaysALineWhileTheToolTurnsThroughThePole) {
  MachineBench bench;
  bench.program("p.nc",
                "#kinematics (2, 1)\nG0 X50 Y20 Z50 B0 C0\nG43.4 H0\nG0 X40 Y10 Z0 B5 C0\n"
                "G1 X-40 Y10 B-5 C270 F6000\nG1 X40 Y10 B5 C-90\nM0\nM30\n");
  bench.run(1, "p.nc");
  double off = 0.0;
  double share = 0.0;
  int cycles = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    share = std::max(share, share_of_limits(channel));
    if (channel.tag.line < 5 || channel.tag.line > 6) return;
    const TipPosition tip = tip_of(channel);
    off = std::max(off, std::hypot(tip.y - 10.0, tip.z));
    ++cycles;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(off, 1e-9);
  EXPECT_LE(share, 1.0 + 1e-9);
  // C turns by 270 and 360 deg at no more than 120 deg/s.
  EXPECT_GT(cycles, 5200);
  EXPECT_LT(cycles, 8000);
}

TEST(TipControl, PosesRoundThePoleKeepTheLimitsAndTheTolerance) {
  std::mt19937 engine(435);
  std::uniform_real_distribution<double> lean(-3.0, 3.0);
  std::uniform_real_distribution<double> turn(-40.0, 40.0);
  std::string text = "#kinematics (2, 1)\nG43.4 H0\nG64 P0.01\nG0 X-30 Y5 Z0 B2 C0\nF6000\n";
  double c = 0.0;
  for (int k = -29; k <= 30; ++k) {
    c += turn(engine);
    text += "G1 X" + std::to_string(k) + " B" + std::to_string(lean(engine)) + " C" +
            std::to_string(c) + "\n";
  }
  MachineBench bench;
  bench.program("p.nc", text + "M0\nM30\n");
  bench.run(1, "p.nc");
  double off = 0.0;
  double share = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    share = std::max(share, share_of_limits(channel));
    if (channel.tag.line < 6) return;
    const TipPosition tip = tip_of(channel);
    off = std::max(off, std::hypot(tip.y - 5.0, tip.z));
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LE(off, 0.01);
  EXPECT_LE(share, 1.0 + 1e-9);
}

}  // namespace
}  // namespace stanok::channels
