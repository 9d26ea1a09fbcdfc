// The tip led through head and table (G43.4) near the pole of the tool axis: B through 0 while C
// turns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

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

using Direction = std::array<double, 3>;

// The head turns the tool by B about Y, the table turns the part by C about Z under it: seen from
// the part the tool points to Rz(C)^T Ry(B) z.
Direction tool_of(double b_deg, double c_deg) {
  const double b = b_deg * std::numbers::pi / 180.0;
  const double c = c_deg * std::numbers::pi / 180.0;
  return {std::sin(b) * std::cos(c), -std::sin(b) * std::sin(c), std::cos(b)};
}

double dot(const Direction& one, const Direction& other) {
  return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
}

Direction normal_of(const Direction& one, const Direction& other) {
  const Direction product{one[1] * other[2] - one[2] * other[1],
                          one[2] * other[0] - one[0] * other[2],
                          one[0] * other[1] - one[1] * other[0]};
  const double length = std::sqrt(dot(product, product));
  return {product[0] / length, product[1] / length, product[2] / length};
}

// How a move from B10 C-20 to B40 C70 turns the tool.
struct Turning {
  double off_circle_deg = 0.0;  // from the plane of both directions
  double off_even = 0.0;        // of B and C from the part of the way that X has gone
  double off_line = 0.0;        // of the tip, mm
  double share = 0.0;           // of the limits
  double b_deg = 0.0;           // where it ends
  double c_deg = 0.0;
};

Turning turning_of(const std::string& directive, const std::string& length_code,
                   const std::string& end) {
  MachineBench bench;
  bench.program("p.nc", "#kinematics (2, 1)\nG0 X50 Y20 Z50 B0 C0\n" + directive + "\n" +
                            length_code + " H0\nG0 X-40 Y10 Z0\nG0 B10 C-20\nG1 X40 Y10 " + end +
                            " F3000\nM0\nM30\n");
  bench.run(1, "p.nc");
  const Direction normal = normal_of(tool_of(10.0, -20.0), tool_of(40.0, 70.0));
  Turning turning;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    turning.share = std::max(turning.share, share_of_limits(channel));
    if (channel.tag.line != 7) return;
    const TipPosition tip = tip_of(channel);
    turning.b_deg = channel.axes[3].position;
    turning.c_deg = channel.axes[4].position;
    turning.off_line = std::max(turning.off_line, std::hypot(tip.y - 10.0, tip.z));
    const double gone = (tip.x + 40.0) / 80.0;
    turning.off_even = std::max({turning.off_even, std::abs((turning.b_deg - 10.0) / 30.0 - gone),
                                 std::abs((turning.c_deg + 20.0) / 90.0 - gone)});
    const double off = std::asin(dot(tool_of(turning.b_deg, turning.c_deg), normal));
    turning.off_circle_deg =
        std::max(turning.off_circle_deg, std::abs(off) * 180.0 / std::numbers::pi);
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  return turning;
}

std::string vector_words(const Direction& direction) {
  char text[96];
  std::snprintf(text, sizeof text, "I%.15f J%.15f K%.15f", direction[0], direction[1],
                direction[2]);
  return text;
}

// A straight way of tips 1 mm apart under vectors that change at each of them.
struct VectorWay {
  std::vector<Direction> tools;  // at X -30, -29 ... 30
  std::string text;

  explicit VectorWay(const std::string& path_mode) {
    std::mt19937 engine(436);
    std::uniform_real_distribution<double> lean(15.0, 18.0);
    std::uniform_real_distribution<double> turn(-12.0, 12.0);
    text = "#kinematics (2, 1)\nG43.5 H0\n" + path_mode + "\nG0 X-30 Y5 Z0\n";
    for (int k = -30; k <= 30; ++k) {
      tools.push_back(tool_of(lean(engine), turn(engine)));
      text += (k == -30 ? "G0 X" : "G1 X") + std::to_string(k) + " " + vector_words(tools.back()) +
              (k == -29 ? " F3000\n" : "\n");
    }
    text += "M0\nM30\n";
  }
  // On the great circle between both neighbours.
  [[nodiscard]] Direction tool_at(double x) const {
    const double from_start = std::clamp(x + 30.0, 0.0, 60.0);
    const auto place = std::min<std::size_t>(static_cast<std::size_t>(from_start), 59);
    const double part = from_start - static_cast<double>(place);
    const Direction& from = tools[place];
    const Direction& to = tools[place + 1];
    const double angle = std::acos(std::min(1.0, dot(from, to)));
    Direction tool{};
    for (std::size_t k = 0; k < 3; ++k) {
      tool[k] = (std::sin((1.0 - part) * angle) * from[k] + std::sin(part * angle) * to[k]) /
                std::sin(angle);
    }
    return tool;
  }
};

struct VectorRun {
  double off_mm = 0.0;   // of the tip from its line
  double off_deg = 0.0;  // of the tool from where it should point there
  double share = 0.0;    // of the limits
  int cycles = 0;
};

VectorRun run_of(const VectorWay& way) {
  MachineBench bench;
  bench.program("p.nc", way.text);
  bench.run(1, "p.nc");
  VectorRun run;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    run.share = std::max(run.share, share_of_limits(channel));
    if (channel.tag.line < 6) return;
    ++run.cycles;
    const TipPosition tip = tip_of(channel);
    run.off_mm = std::max(run.off_mm, std::hypot(tip.y - 5.0, tip.z));
    const Direction tool = tool_of(channel.axes[3].position, channel.axes[4].position);
    const double cosine = std::clamp(dot(tool, way.tool_at(tip.x)), -1.0, 1.0);
    run.off_deg = std::max(run.off_deg, std::acos(cosine) * 180.0 / std::numbers::pi);
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  return run;
}

// Under G64 points and vectors are smoothed together: the tip stays within 0.01 mm of its line, the
// tool within what 0.05 deg of each rotary axis, the division of the moves (0.005 deg) and 0.01 mm
// of the way (up to 4 deg in 1 mm) make, and nothing stops.
TEST(TipControl, PointsAndVectorsAreSmoothedWithinBothTolerances) {
  const VectorRun smooth = run_of(VectorWay("G64 P0.01"));
  const VectorRun stopping = run_of(VectorWay("G61.1"));
  EXPECT_LE(smooth.off_mm, 0.01);
  EXPECT_LE(smooth.off_deg, 0.05 + 0.05 * std::sin(18.0 * std::numbers::pi / 180.0) + 0.005 + 0.04);
  EXPECT_LE(smooth.share, 1.0 + 1e-9);
  EXPECT_LE(stopping.off_deg, 0.0055);
  EXPECT_LT(smooth.cycles, stopping.cycles);
}

struct TurningCase {
  const char* name;
  const char* directive;
  const char* length_code;
  bool by_vector;  // the end of the move is said by I, J, K
  bool on_circle;  // else the axes move evenly
};

class TurningWays : public ::testing::TestWithParam<TurningCase> {};

TEST_P(TurningWays, AreThoseOfOrientation) {
  const auto& [name, directive, length_code, by_vector, on_circle] = GetParam();
  const std::string end = by_vector ? vector_words(tool_of(40.0, 70.0)) : "B40 C70";
  const Turning turning = turning_of(directive, length_code, end);
  EXPECT_NEAR(turning.b_deg, 40.0, 1e-9);
  EXPECT_NEAR(turning.c_deg, 70.0, 1e-9);
  EXPECT_LT(turning.off_line, 1e-9);
  EXPECT_LE(turning.share, 1.0 + 1e-9);
  if (on_circle) {
    // 0.005 deg by the division of the move, and what smooths the joints of its parts.
    EXPECT_LE(turning.off_circle_deg, 0.006);
    EXPECT_GT(turning.off_even, 0.02);
  } else {
    EXPECT_LE(turning.off_even, 1e-9);
    EXPECT_GT(turning.off_circle_deg, 3.0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfOrientation, TurningWays,
    ::testing::Values(
        TurningCase{"angles", "", "G43.4", false, false},
        TurningCase{"angles_on_circle", "#orientation (vector)", "G43.4", false, true},
        TurningCase{"angles_evenly", "#orientation (axis)", "G43.4", false, false},
        TurningCase{"vectors", "", "G43.5", true, true},
        TurningCase{"vectors_on_circle", "#orientation (vector)", "G43.5", true, true},
        TurningCase{"vectors_evenly", "#orientation (axis)", "G43.5", true, false}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace stanok::channels
