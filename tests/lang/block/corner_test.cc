// Chamfers and roundings of corners, `,C` and `,R`, against their definitions: the rounding touches
// both elements at its radius, the chamfer begins and ends at its size from the corner.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

struct At {
  double x = 0.0;
  double y = 0.0;
};

double between(At a, At b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

At end_of(const Move& move) {
  return {move.end[0], move.end[1]};
}

// An element that ends or starts at the origin: a line, or an arc about `centre`.
struct Side {
  bool is_arc = false;
  At other;  // its other end
  At centre;
  bool ccw = false;

  [[nodiscard]] double off(At p) const {
    if (is_arc) return std::abs(between(p, centre) - between({}, centre));
    return std::abs(p.x * other.y - p.y * other.x) / between({}, other);
  }
};

std::string text_of(const char* format, double a, double b) {
  char text[120];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

class CornerTest : public ProgramTest {
 protected:
  std::mt19937_64 random{7};
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }

  // Heading away from the origin at `angle`, some 20 to 40 mm.
  Side side(double angle, bool leaves) {
    Side made;
    made.is_arc = uniform(0.0, 1.0) < 0.5;
    const double length = uniform(20.0, 40.0);
    made.other = {length * std::cos(angle), length * std::sin(angle)};
    if (!made.is_arc) return made;
    const double radius = length * uniform(1.0, 3.0);
    const bool left = uniform(0.0, 1.0) < 0.5;
    const double height = std::sqrt(radius * radius - 0.25 * length * length);
    const double sense = (left ? height : -height) / length;
    made.centre = {0.5 * made.other.x - sense * made.other.y,
                   0.5 * made.other.y + sense * made.other.x};
    made.ccw = left == leaves;
    return made;
  }

  // The heading at the origin of a way that goes along this side to its other end.
  static double heading_at_corner(const Side& side) {
    if (!side.is_arc) return std::atan2(side.other.y, side.other.x);
    const At along{-side.centre.y, side.centre.x};
    const bool is_forth = along.x * side.other.x + along.y * side.other.y > 0.0;
    return is_forth ? std::atan2(along.y, along.x) : std::atan2(-along.y, -along.x);
  }

  static bool is_smooth(const Side& before, const Side& after) {
    const double turn = heading_at_corner(after) - heading_at_corner(before) - std::numbers::pi;
    return std::abs(std::remainder(turn, 2.0 * std::numbers::pi)) < std::numbers::pi / 180.0;
  }

  static std::string line_to(const Side& side, At from, At to) {
    if (!side.is_arc) return text_of("G1 X%.12f Y%.12f", to.x, to.y);
    return text_of(side.ccw ? "G3 X%.12f Y%.12f" : "G2 X%.12f Y%.12f", to.x, to.y) +
           text_of(" I%.12f J%.12f", side.centre.x - from.x, side.centre.y - from.y);
  }

  // Both sides with the corner at the origin between them: three moves, behind the way to the
  // start.
  std::vector<Move> cut(const Side& before, const Side& after, const std::string& word) {
    run("G21 G90 F100\n" + text_of("G0 X%.12f Y%.12f\n", before.other.x, before.other.y) +
        line_to(before, before.other, {}) + word + "\n" + line_to(after, {}, after.other) +
        "\nM30\n");
    return all<Move>();
  }
};

TEST_F(CornerTest, RoundingsTouchBothElementsAtTheirRadius) {
  int fitting = 0;
  for (int n = 0; n < 2000; ++n) {
    SCOPED_TRACE(n);
    const double heading = uniform(0.0, 6.28);
    const Side before = side(heading, false);
    const Side after = side(heading + uniform(0.6, 5.6), true);
    const double radius = uniform(0.2, 4.0);
    const auto moves = cut(before, after, text_of(",R%.12f", radius, 0.0));
    if (error.code == "E4152") continue;
    ASSERT_EQ(error.code, "") << to_text(error);
    ASSERT_EQ(moves.size(), is_smooth(before, after) ? 3U : 4U);
    ++fitting;
    if (moves.size() == 3U) continue;
    const At from = end_of(moves[1]);
    const At to = end_of(moves[2]);
    EXPECT_EQ(moves[2].kind, MoveKind::arc);
    const At centre{moves[2].centre[0], moves[2].centre[1]};
    EXPECT_NEAR(between(centre, from), radius, 1e-8);
    EXPECT_NEAR(between(centre, to), radius, 1e-8);
    EXPECT_LT(before.off(from), 1e-8);
    EXPECT_LT(after.off(to), 1e-8);
    // Its centre is as far from both elements: so they are tangents.
    EXPECT_NEAR(before.off(centre), radius, 1e-8);
    EXPECT_NEAR(after.off(centre), radius, 1e-8);
    EXPECT_NEAR(between(end_of(moves[3]), after.other), 0.0, 1e-9);
    // Less than half a turn, in the direction in which the way turns.
    const double cross =
        (from.x - centre.x) * (to.y - centre.y) - (from.y - centre.y) * (to.x - centre.x);
    EXPECT_EQ(cross > 0.0, moves[2].counter_clockwise);
  }
  EXPECT_GT(fitting, 1500);
}

TEST_F(CornerTest, ChamfersBeginAndEndAtTheirSizeFromTheCorner) {
  int fitting = 0;
  for (int n = 0; n < 1000; ++n) {
    SCOPED_TRACE(n);
    const double heading = uniform(0.0, 6.28);
    const Side before = side(heading, false);
    const Side after = side(heading + uniform(0.6, 5.6), true);
    const double size = uniform(0.1, 10.0);
    const auto moves = cut(before, after, text_of(" ,C%.12f", size, 0.0));
    ASSERT_EQ(error.code, "") << to_text(error);
    ASSERT_EQ(moves.size(), is_smooth(before, after) ? 3U : 4U);
    ++fitting;
    if (moves.size() == 3U) continue;
    const At from = end_of(moves[1]);
    const At to = end_of(moves[2]);
    EXPECT_EQ(moves[2].kind, MoveKind::line);
    EXPECT_NEAR(between({}, from), size, 1e-9);
    EXPECT_NEAR(between({}, to), size, 1e-9);
    EXPECT_LT(before.off(from), 1e-9);
    EXPECT_LT(after.off(to), 1e-9);
    // On the side of its element, not on its continuation.
    EXPECT_LT(between(from, before.other), between({}, before.other));
    EXPECT_LT(between(to, after.other), between({}, after.other));
  }
  EXPECT_EQ(fitting, 1000);
}

std::string points_of(const std::vector<Move>& moves) {
  std::string text;
  for (const Move& move : moves) {
    char one[60];
    std::snprintf(one, sizeof one, "%s%.3f %.3f", text.empty() ? "" : ", ", move.end[0],
                  move.end[1]);
    text += one;
  }
  return text;
}

TEST_F(CornerTest, FollowEachOtherAroundAContour) {
  EXPECT_EQ(points_of(moves("G21 F100\nG1 X20,R5\nY20,C2\nX0,R3\nY0\nM30\n")),
            "15.000 0.000, 20.000 5.000, 20.000 18.000, 18.000 20.000, 3.000 20.000, 0.000 17.000, "
            "0.000 0.000");
}

TEST_F(CornerTest, HaveTheUnitOfTheProgramAndItsScale) {
  EXPECT_EQ(points_of(moves("G20 F10\nG1 X2,R0.5\nY2\nM30\n")),
            "38.100 0.000, 50.800 12.700, 50.800 50.800");
  EXPECT_EQ(points_of(moves("G21 F100\nG51 X0 Y0 P2\nG1 X20,C2\nY20\nM30\n")),
            "36.000 0.000, 40.000 4.000, 40.000 40.000");
  EXPECT_EQ(points_of(moves("G21 F100\nG51.1 X0\nG1 X20,R5\nY20\nM30\n")),
            "-15.000 0.000, -20.000 5.000, -20.000 20.000");
}

TEST_F(CornerTest, TakeTheFeedAndTheLineOfTheirBlock) {
  run("G21 F100\nG1 X20 ,R5 F300\nG4 P0.5\nM8\nG1 Y20 F50\nM30\n");
  const auto list = all<Move>();
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].feed, 300.0);
  EXPECT_EQ(list[2].feed, 50.0);
  std::string order;
  for (const Command& command : commands) {
    if (std::holds_alternative<Move>(command.payload)) order += 'M';
    if (std::holds_alternative<Dwell>(command.payload)) order += 'D';
    if (std::holds_alternative<CoolantCommand>(command.payload)) order += 'C';
    const Move* const move = move_of(command.payload);
    const bool rounds = move != nullptr && move->kind == MoveKind::arc;
    EXPECT_TRUE(!rounds || command.origin.line == 2U);
  }
  EXPECT_EQ(order.substr(0, 5), "MMDCM");
}

TEST_F(CornerTest, AreLeftOutWhereTheWayHardlyTurns) {
  EXPECT_EQ(points_of(moves("G21 F100\nG1 X20,R5\nX40 Y0.1\nM30\n")), "20.000 0.000, 40.000 0.100");
  EXPECT_EQ(points_of(moves("G21 F100\nG1 X20,R0\nY20\nM30\n")), "20.000 0.000, 20.000 20.000");
}

// The parallel of a rounded corner, outside of it: an arc of both radii.
TEST_F(CornerTest, AreContoursToRadiusCompensation) {
  const auto list =
      moves("G21 F100\nG0 X0 Y-20\nG42.1 D4 G1 X0 Y0\nX20,R5\nY20,C2\nX0\nG40 Y40\nM30\n");
  std::string arcs;
  for (const Move& move : list) {
    if (move.kind != MoveKind::arc) continue;
    arcs += text_of("%.3f %.3f ", move.centre[0], move.centre[1]);
    arcs += text_of("r%.3f, ",
                    std::hypot(move.end[0] - move.centre[0], move.end[1] - move.centre[1]), 0.0);
  }
  EXPECT_EQ(arcs, "15.000 5.000 r7.000, 20.000 18.000 r2.000, 18.000 20.000 r2.000, ");
}

class CornerFaults : public CornerTest, public ::testing::WithParamInterface<FaultCase> {};

TEST_P(CornerFaults, SayWhereThereCanBeNoCorner) {
  EXPECT_EQ(error_code(GetParam().text), GetParam().code) << to_text(error);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, CornerFaults,
    ::testing::Values(FaultCase{"G21 F100\nG1 X5,R6\nY20\nM30\n", "E4152"},
                      FaultCase{"G21 F100\nG1 X20,C6\nY5\nM30\n", "E4152"},
                      FaultCase{"G21 F100\nG1 X20,R2\nX0\nM30\n", "E4152"},
                      FaultCase{"G21 F100\nG0 X20,R2\nG1 Y5\nM30\n", "E4150"},
                      FaultCase{"G21 F100\nG1 Z-2,R2\nY5\nM30\n", "E4150"},
                      FaultCase{"G21 F100\nG1 X20,R2\nZ5\nM30\n", "E4151"},
                      FaultCase{"G21 F100\nG1 X20,R2\nG0 Y5\nM30\n", "E4151"},
                      FaultCase{"G21 F100\nG1 X20,R2\nG55 G1 Y5\nM30\n", "E4151"},
                      FaultCase{"G21 F100\nG1 X20,R2\nM30\n", "E4151"},
                      FaultCase{"G21 F100\nG1 X20,R2,C2\nY5\nM30\n", "E4150"},
                      FaultCase{"G21 F100\nG4 P1 ,R2\nG1 Y5\nM30\n", "E4150"},
                      FaultCase{"G21 F100\nG1 X20,R-2\nY5\nM30\n", "E4008"},
                      FaultCase{"G21 F100\nG1 X20,R2,R2\nY5\nM30\n", "E4001"},
                      FaultCase{"G21 F100 G93\nG1 X20,R2 F60\nY5 F60\nM30\n", "E4150"},
                      FaultCase{"G21 F100\nG42.1 D4 G1 X20\nY20,R1\nG40 X40\nM30\n", "E4151"}));

}  // namespace
}  // namespace stanok::lang::testing
