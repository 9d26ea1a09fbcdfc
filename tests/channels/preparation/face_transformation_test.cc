// Milling on the face and on the side of a turned workpiece: G12.1, G7.1 on X, Z and C.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using testing::lathe_C;
using testing::lathe_X;
using testing::lathe_Z;
using testing::MachineBench;

constexpr double pi = std::numbers::pi;

struct FaceVector {
  double x = 0.0;
  double y = 0.0;
};

// The tip over the workpiece from the machine axes alone: it turns by C against the tool on X.
FaceVector on_face(const ChannelOutput& channel) {
  const double angle = channel.axes[lathe_C].position * pi / 180.0;
  return {channel.axes[lathe_X].position * std::cos(angle),
          channel.axes[lathe_X].position * std::sin(angle)};
}
FaceVector velocity_on_face(const ChannelOutput& channel) {
  const double angle = channel.axes[lathe_C].position * pi / 180.0;
  const double turning = channel.axes[lathe_C].velocity * pi / 180.0;
  const double r = channel.axes[lathe_X].position;
  const double dr = channel.axes[lathe_X].velocity;
  return {dr * std::cos(angle) - r * turning * std::sin(angle),
          dr * std::sin(angle) + r * turning * std::cos(angle)};
}

class Face : public ::testing::Test {
 protected:
  explicit Face(const MachineConfig& machine = testing::turning_machine()) : bench(machine) {}

  // Runs the program; `watch` sees the cycles in which C is an axis. Axis limits are judged.
  void run(
      const std::string& text,
      const std::function<void(const ChannelOutput&)>& watch = [](const ChannelOutput&) {}) {
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    bool was_axis = false;
    motion::Point before{};
    bench.run_to_end([&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      const bool is_axis = !channel.drives[lathe_C].follows_velocity;
      if (is_axis && was_axis) judge(channel, before);
      if (is_axis) watch(channel);
      was_axis = is_axis;
      for (std::size_t k = 0; k < 3; ++k) before[k] = channel.axes[k].position;
    });
  }
  static void judge(const ChannelOutput& channel, const motion::Point& before) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool rotary = k == lathe_C;
      EXPECT_LE(std::abs(channel.axes[k].velocity), (rotary ? 120.0 : 250.0) * (1 + 1e-9));
      EXPECT_LE(std::abs(channel.axes[k].acceleration), (rotary ? 1200.0 : 2500.0) * (1 + 1e-9));
      EXPECT_LE(std::abs(channel.axes[k].jerk), (rotary ? 24000.0 : 50000.0) * (1 + 1e-9));
      EXPECT_LE(std::abs(channel.axes[k].position - before[k]), (rotary ? 0.12 : 0.25) + 1e-9);
    }
  }

  MachineBench bench;
};

TEST_F(Face, ACircleThroughTheCentreIsRefused) {
  run("G94 G8 M902\nG0 X40 C0\nG12.1\nG1 F1000 X40 C0\nG3 I-20 J0\nG13.1\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), Contains("E5103"));
}

TEST_F(Face, ACircleOfRadius20IsACircleAtTheFeed) {
  double off = 0.0;
  double fastest = 0.0;
  int steady = 0;
  int moving = 0;
  run("G94 G8 M902\nG0 X50 C0\nG12.1\nG1 F1000 X50 C0\nG3 I-20 J0 P3\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        if (channel.tag.line != 5 || !channel.moving) return;
        const FaceVector p = on_face(channel);
        const FaceVector v = velocity_on_face(channel);
        off = std::max(off, std::abs(std::hypot(p.x - 30.0, p.y) - 20.0));
        const double share = std::hypot(v.x, v.y) * 60.0 / 1000.0;
        fastest = std::max(fastest, share);
        ++moving;
        if (std::abs(share - 1.0) < 1e-9) ++steady;
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(off, 1e-9);
  EXPECT_LE(fastest, 1.0 + 1e-9);
  EXPECT_GT(moving, 20000);  // 3 turns of 7.54 s
  EXPECT_GT(static_cast<double>(steady) / moving, 0.98);
}

TEST_F(Face, RoundTheCentreCGoesOnTurning) {
  double last = 0.0;
  run("G94 G8 M902\nG0 X20 C0\nG12.1\nG1 F3000 X20 C0\nG3 I-20 J0 P3\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) { last = channel.axes[lathe_C].position; });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(last, 3 * 360.0, 1e-9);
}

TEST_F(Face, ALineHalfAMillimetreBesideTheCentreStaysALine) {
  double off = 0.0;
  double way = 0.0;
  std::int64_t cycles = 0;
  run("G94 G8 M902\nG0 X20 C0\nG12.1\nG1 F1000 X20 C0.5\nX-20\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        if (channel.tag.line != 5) return;
        const FaceVector p = on_face(channel);
        off = std::max(off, std::abs(p.y - 0.5));
        way = p.x;
        ++cycles;
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(off, 1e-9);
  EXPECT_NEAR(way, -20.0, 1e-9);
  // C turns by 177 deg at no more than 120 deg/s; 40 mm at F1000 take 2.4 s.
  EXPECT_GT(cycles, 2400);
  EXPECT_LT(cycles, 8000);
}

TEST_F(Face, ALineThroughTheCentreIsRefused) {
  run("G94 G8 M902\nG0 X20 C0\nG12.1\nG1 F1000 X-20 C0\nG13.1\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), Contains("E5103"));
}

TEST_F(Face, BeginsOnTheSideWhereTheToolStands) {
  FaceVector end;
  double x = 0.0;
  run("G94 G8 M902\nG0 X-20 C0\nG12.1\nG1 F1000 X-20 C15\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        end = on_face(channel);
        x = channel.axes[lathe_X].position;
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(x, 0.0);
  EXPECT_NEAR(end.x, -20.0, 1e-9);
  EXPECT_NEAR(end.y, 15.0, 1e-9);
}

TEST(FaceAxis, MustTurnWithoutEnd) {
  MachineConfig machine = testing::turning_machine();
  machine.axes[lathe_C].limits.position_min = -360.0;
  machine.axes[lathe_C].limits.position_max = 360.0;
  MachineBench bench(machine);
  bench.program("p.nc", "M902\nG12.1\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), Contains("E5104"));
}

TEST_F(Face, TheSideOfACylinderIsAPlaneOfItsCircumference) {
  // Radius 20: 90 deg are 10 pi mm. A full circle of radius 5 about (C 0, Z -10) in that plane.
  double off = 0.0;
  double fastest = 0.0;
  double last = 1.0;
  run("G94 G8 M902\nG0 X20 Z-15 C0\nG7.1 C20\nG1 F600 Z-15 C0\nG3 C0 J0 K5\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        last = channel.axes[lathe_C].position;
        if (channel.tag.line != 5 || !channel.moving) return;
        const double length = channel.axes[lathe_C].position * pi / 180.0 * 20.0;
        off = std::max(off,
                       std::abs(std::hypot(length, channel.axes[lathe_Z].position + 10.0) - 5.0));
        const double around = channel.axes[lathe_C].velocity * pi / 180.0 * 20.0;
        fastest = std::max(fastest, std::hypot(around, channel.axes[lathe_Z].velocity));
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(off, 1e-9);
  EXPECT_NEAR(fastest, 10.0, 1e-9);
  EXPECT_NEAR(last, 0.0, 1e-9);
}

// The rotary axis is called A and turns about X.
MachineConfig machine_with_axis_a() {
  MachineConfig machine = testing::turning_machine();
  machine.channels[0].words = {"X", "Z", "A"};
  return machine;
}

class CylinderAboutX : public Face {
 protected:
  CylinderAboutX() : Face(machine_with_axis_a()) {}
};

TEST_F(CylinderAboutX, TheSideIsAPlaneOfXAndTheCircumference) {
  // Radius 20. A full circle of radius 5 about (X 15, A 0) in the plane of X and 20 A.
  double off = 0.0;
  double fastest = 0.0;
  run("G94 G8 M902\nG0 X20 Z40 A0\nG7.1 A20\nG1 F600 X20 A0\nG3 A0 I-5 J0\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        if (channel.tag.line != 5 || !channel.moving) return;
        const double length = channel.axes[lathe_C].position * pi / 180.0 * 20.0;
        off = std::max(off,
                       std::abs(std::hypot(length, channel.axes[lathe_X].position - 15.0) - 5.0));
        const double around = channel.axes[lathe_C].velocity * pi / 180.0 * 20.0;
        fastest = std::max(fastest, std::hypot(around, channel.axes[lathe_X].velocity));
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(off, 1e-9);
  EXPECT_NEAR(fastest, 10.0, 1e-9);
}

TEST_F(Face, AWorkOffsetOfCTurnsTheFace) {
  // G10 L2 P1 C30: the x axis of the face lies at C = 30.
  double last = 0.0;
  double x = 0.0;
  run("G94 G8 M902\nG10 L2 P1 C30\nG0 X20 C0\nG12.1\nG1 F1000 X20 C20\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        last = channel.axes[lathe_C].position;
        x = channel.axes[lathe_X].position;
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(last, 75.0, 1e-9);  // 30 + 45
  EXPECT_NEAR(x, 20.0 * std::numbers::sqrt2, 1e-9);
}

TEST_F(Face, InverseTimeCountsTheWayOverTheFace) {
  // 15 mm along X and 20 mm along C, 25 mm, in 2 s: F30 per minute.
  std::int64_t cycles = 0;
  double fastest = 0.0;
  run("G94 G8 M902\nG0 X30 C0\nG12.1\nG1 F1000 X30 C0\nG93 G1 X15 C20 F30\nG94\nG13.1\nM0\nM30\n",
      [&](const ChannelOutput& channel) {
        if (channel.tag.line != 5 || !channel.moving) return;
        const FaceVector v = velocity_on_face(channel);
        fastest = std::max(fastest, std::hypot(v.x, v.y));
        ++cycles;
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(fastest, 12.5, 1e-6);
  EXPECT_GT(cycles, 2000);
  EXPECT_LT(cycles, 2200);
}

TEST_F(Face, EndsWhereItStandsInDegrees) {
  run("G94 G8 M902\nG0 X20 C0\nG12.1\nG1 F1000 X20 C20\nG13.1\n"
      "if (abs ($pos[C] - 45) > 1e-6) { terminate (1001, \"not 45\"); }\nM30\n");
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

// Once and one and a half times round the centre, by lines and by an arc: C has turned, and from
// there a programmed C0 turns it back. Every step of every axis is judged.
TEST_F(Face, ItsAxisKeepsItsTurnsBehindIt) {
  double c_max = 0.0;
  run("G94 G8 M902\nG0 X20 C0\nG12.1\nG1 X10 C10 F1200\nX-10\nC-10\nX10\nC5\n"
      "X20 C0\nG3 X-20 C0 I-20 J0\nG13.1\nG0 X25\nC0\nM30\n",
      [&](const ChannelOutput& channel) {
        c_max = std::max(c_max, channel.axes[lathe_C].position);
      });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(c_max, 540.0, 1.0);
  EXPECT_NEAR(bench.channel(1).axes[lathe_X].position, 25.0, 1e-9);
}

}  // namespace
}  // namespace stanok::channels
