// Splines on the machine: the programmed curve at the programmed feed, in G94 and G93.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::MachineBench;

// Share of the cycles in motion in which the path runs at `feed` to rounding; the others are ramps.
double steady_share(MachineBench& bench, const std::string& text, double feed) {
  bench.program("p.nc", text);
  bench.run(1, "p.nc");
  int moving = 0;
  int steady = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    const auto& point = output.channels[0].point_W;
    const double speed = std::hypot(point[0].first, point[1].first, point[2].first);
    moving += output.channels[0].moving ? 1 : 0;
    steady += std::abs(speed / feed - 1.0) < 1e-9 ? 1 : 0;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  return static_cast<double>(steady) / moving;
}

TEST(Spline, CubicFollowsItsBezierCurveAtTheFeed) {
  MachineBench bench;
  double worst = 0.0;
  bench.program("p.nc", "G1 F3000\nG5 X60 Y0 I0 J40 P0 Q40\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) {
    const double x = output.channels[0].axes[0].position;
    const double y = output.channels[0].axes[1].position;
    // x = 60 (3u^2 - 2u^3), y = 120 u (1 - u): from y, u, and from u, x.
    const double u = 0.5 * (1.0 - std::sqrt(std::max(0.0, 1.0 - y / 30.0)));
    const double left = 60.0 * u * u * (3.0 - 2.0 * u);
    worst = std::max(worst, std::min(std::abs(x - left), std::abs(x - (60.0 - left))));
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(worst, 1e-6);
  EXPECT_EQ(bench.channel(1).axes[0].position, 60.0);
  EXPECT_EQ(bench.channel(1).axes[1].position, 0.0);
}

// The same cubic, with Z and X, and with Y and Z for X and Y.
TEST(Spline, LiesInThePlaneThatIsActive) {
  const std::array<std::string, 2> programs{"G18 G1 F3000\nG5 Z-60 X0 K0 I40 P0 Q40\nM30\n",
                                            "G19 G1 F3000\nG5 Y60 Z0 J0 K-40 P0 Q-40\nM30\n"};
  const std::array<std::array<std::size_t, 3>, 2> axes{{{2, 0, 1}, {1, 2, 0}}};
  const std::array<std::array<double, 2>, 2> signs{{{-1.0, 1.0}, {1.0, -1.0}}};
  for (std::size_t k = 0; k < 2; ++k) {
    MachineBench bench;
    double worst = 0.0;
    double out = 0.0;
    bench.program("p.nc", programs[k]);
    bench.run(1, "p.nc");
    bench.run_to_end([&](const CycleOutput& output) {
      const auto& at = output.channels[0].axes;
      const double x = signs[k][0] * at[axes[k][0]].position;
      const double y = signs[k][1] * at[axes[k][1]].position;
      const double u = 0.5 * (1.0 - std::sqrt(std::max(0.0, 1.0 - y / 30.0)));
      const double left = 60.0 * u * u * (3.0 - 2.0 * u);
      worst = std::max(worst, std::min(std::abs(x - left), std::abs(x - (60.0 - left))));
      out = std::max(out, std::abs(at[axes[k][2]].position));
    });
    EXPECT_THAT(bench.alarm_codes(), IsEmpty());
    EXPECT_LT(worst, 1e-6);
    EXPECT_EQ(out, 0.0);
  }
}

TEST(Spline, SpeedIsTheFeedToRounding) {
  for (const double feed : {1.0, 50.0}) {  // mm/s
    MachineBench bench;
    const std::string f = "F" + std::to_string(feed * 60.0) + "\n";
    const std::string text = "G1 " + f + "G5 X30 Y0 I0 J20 P0 Q20\nX60 P0 Q-20\nM30\n";
    EXPECT_GT(steady_share(bench, text, feed), feed > 10.0 ? 0.85 : 0.99);
  }
}

TEST(Spline, NurbsGoesFromItsFirstToItsLastPoint) {
  MachineBench bench;
  const std::string text =
      "F2400\nG5.2 P1 L4\nX10 Y20 P2\nX25 Y-15 P0.7\nX40 Y20\nX60 Y0\nX70 Y10\nG5.3\nM30\n";
  EXPECT_GT(steady_share(bench, text, 40.0), 0.85);
  EXPECT_EQ(bench.channel(1).axes[0].position, 70.0);
  EXPECT_EQ(bench.channel(1).axes[1].position, 10.0);
}

TEST(Spline, InverseTimeCountsForTheWholeCurve) {
  MachineBench bench;
  // 2 s for the curve: F30 in 1/min.
  int moving = 0;
  bench.program("p.nc", "G93\nG5 X60 Y0 I0 J40 P0 Q40 F30\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) { moving += output.channels[0].moving ? 1 : 0; });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_GT(moving, 2000);  // and the ramps
  EXPECT_LT(moving, 2200);
}

// I0 J0: the first two control points coincide, the curve leaves straight towards the third.
TEST(Spline, RunsWithoutADirectionAtItsEnds) {
  MachineBench bench;
  bench.program("p.nc", "G1 X1 F6000\nG5 X60 Y0 I0 J0 P0 Q0\nG5 X60 Y0 I0 J0 P0 Q0\nM30\n");
  bench.run(1, "p.nc");
  double off = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    off = std::max(off, std::abs(output.channels[0].axes[1].position));
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, 60.0);
  EXPECT_LE(off, 1e-9);
}

// Both ends have a control point within less than a micrometre, which bends the curve back there
// within some nm: such a place is a corner, no crawl (124 s of machine time before).
TEST(Spline, CuspsOfNanometresCostNoTime) {
  MachineBench bench;
  int moving = 0;
  bench.program("p.nc",
                "G61.1\nG1 F5000 X25.4 Y0.3\nG5 I-0.0003 J0 P0 Q-0.0003 X25.3997 Y0\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) { moving += output.channels[0].moving ? 1 : 0; });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(moving, 1000);
}

// The curve passes its end by 0.16 nm and comes back: what turns it is a part of the nanometre that
// is passed on its chord, nothing beside it is bent for that (336 s of machine time before).
TEST(Spline, OvershootsOfLessThanANanometreCostNoTime) {
  MachineBench bench;
  int moving = 0;
  bench.program(
      "p.nc",
      "G1 F7892\nG0 X-2.117 Y8.38\n"
      "G5 I-0.000000000000636 J0 P[-0.000002179907/3] Q-0.000000000000636 X-2.1174 Y8.38\n"
      "M30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) { moving += output.channels[0].moving ? 1 : 0; });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, -2.1174);
  EXPECT_LT(moving, 1000);
}

}  // namespace
}  // namespace stanok::channels
