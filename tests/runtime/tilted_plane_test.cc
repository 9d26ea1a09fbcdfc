// Tilted planes on whole machines: where the axes go, against programs that are turned by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/runtime/feed_ends.h"

namespace stanok::runtime {
namespace {

Eigen::Matrix3d plane_turn(double i_deg, double j_deg, double k_deg) {
  const auto about = [](const Point& axis, double angle_deg) {
    return Eigen::AngleAxisd(angle_deg / deg_of_plane, axis).toRotationMatrix();
  };
  return about(Point::UnitZ(), i_deg) * about(Point::UnitX(), j_deg) * about(Point::UnitZ(), k_deg);
}

std::string words(const Point& point) {
  char text[96];
  std::snprintf(text, sizeof text, " X%.13f Y%.13f Z%.13f", point.x(), point.y(), point.z());
  return text;
}

// The trunnion rocks A about X over C about Z. To bring the normal n upright C turns it into the
// plane YZ on the side of -Y, then A lifts it: A is -(angle between n and Z).
std::string trunnion_angles(const Point& n) {
  char text[96];
  const double a = -deg_of_plane * std::atan2(std::hypot(n.x(), n.y()), n.z());
  const double c = -90.0 - deg_of_plane * std::atan2(n.y(), n.x());
  std::snprintf(text, sizeof text, " A%.13f C%.13f", a, std::remainder(c, 360.0));
  return text;
}

TEST(TiltedPlaneOnMachine, IsTheProgramThatIsTurnedByHand) {
  const channels::MachineConfig machine = machine_called("trunnion.toml");
  const std::array<Point, 6> points{Point(0, 0, 5),   Point(12.5, 0, -1), Point(12.5, 9.25, -1),
                                    Point(-4, 7, -2), Point(0, 0, 0),     Point(3, -8, 4)};
  int planes = 0;
  for (const double i : {0.0, 30.0, -75.0, 140.0}) {
    for (const double j : {10.0, 25.0, 60.0}) {
      const double k = 15.0 - i;
      const Point origin(8.0, -5.5, -3.0);
      const Eigen::Matrix3d turn = plane_turn(i, j, k);
      char plane[128];
      std::snprintf(plane, sizeof plane, "G68.2 X8 Y-5.5 Z-3 I%.1f J%.1f K%.1f\n", i, j, k);
      const std::string head = "T2 M6\nS1000 M3\nG54 G43 H2 F500\nG0 X0 Y0 Z90\n";
      std::string tilted = head + plane + "G53.1 P2\n";
      std::string by_hand = head + "G0" + trunnion_angles(turn * Point::UnitZ()) + "\nG43.4 H2\n";
      for (const Point& point : points) {
        tilted += "G1" + words(point) + "\n";
        by_hand += "G1" + words(origin + turn * point) + "\n";
      }
      const auto ends = feed_ends(machine, tilted + "G69\nM30\n");
      const auto expected = feed_ends(machine, by_hand + "M30\n");
      ASSERT_EQ(ends.size(), points.size());
      ASSERT_EQ(expected.size(), points.size());
      for (std::size_t n = 0; n < points.size(); ++n) {
        for (std::size_t axis = 0; axis < 5; ++axis) {
          EXPECT_NEAR(ends[n].axes_M[axis], expected[n].axes_M[axis], 1e-9)
              << plane << "point " << n << " axis " << axis;
        }
      }
      ++planes;
    }
  }
  EXPECT_EQ(planes, 12);
}

struct PlaneMachine {
  const char* name;
  const char* machine;
  int scheme;  // -1: the one at power-on
};

class ThreePlanes : public ::testing::TestWithParam<PlaneMachine> {};

// Cycles drill along the normal, whatever axes the machine has: at the bottom of each hole the tip
// is where the drawing has it, and the tool stands square to the plane. Mirror and rotation count
// within the plane, the work offset below it.
TEST_P(ThreePlanes, AreDrilledSquare) {
  const channels::MachineConfig machine = machine_called(GetParam().machine);
  std::string text = "T2 M6\nS1000 M3\nG54 G43 H2\nG0 X0 Y0 Z90\n";
  std::vector<std::pair<Point, Point>> holes;  // bottom in B without the work offset, normal
  const std::array<std::array<double, 3>, 3> planes{
      {{0.0, 20.0, 0.0}, {90.0, 15.0, -90.0}, {-120.0, 25.0, 40.0}}};
  for (const auto& [i, j, k] : planes) {
    const Eigen::Matrix3d turn = plane_turn(i, j, k);
    const Point origin(4.0, -6.0, 2.0);
    char plane[160];
    std::snprintf(plane, sizeof plane,
                  "G68.2 X4 Y-6 Z2 I%.1f J%.1f K%.1f\nG53.1\nG0 X0 Y0 Z40\n"
                  "G51.1 X0\nG68 X0 Y0 R90\nG81 X10 Y5 Z-4 R2 F200\nG80 G50.1\nG0 Z40\nG69\n",
                  i, j, k);
    text += plane;
    // X10 is mirrored to -10, then a quarter turn brings (-10, 5) to (-5, -10).
    holes.emplace_back(origin + turn * Point(-5.0, -10.0, -4.0), turn * Point::UnitZ());
  }
  const auto ends = feed_ends(machine, text + "M30\n", GetParam().scheme);
  ASSERT_EQ(ends.size(), holes.size());
  Point offset = Point(ends[0].tip_B[0], ends[0].tip_B[1], ends[0].tip_B[2]) - holes[0].first;
  for (std::size_t n = 0; n < holes.size(); ++n) {
    const Point tip(ends[n].tip_B[0], ends[n].tip_B[1], ends[n].tip_B[2]);
    EXPECT_LT((tip - holes[n].first - offset).norm(), 1e-9) << "hole " << n;
    EXPECT_LT((ends[n].tool_B - holes[n].second).norm(), 1e-9) << "hole " << n;
  }
  // One offset for all, and it is the work offset: it lies along Z, where the machine files have
  // it.
  EXPECT_LT(std::hypot(offset.x(), offset.y()), 1e-9);
}

// The moves of a program of tool vectors, what each wants and where the parts of each end.
struct VectorProgram {
  std::vector<std::pair<Point, Point>> wanted;  // tip in B without the work offset, direction
  std::vector<std::vector<FeedEnd>> parts;
};

VectorProgram random_vectors(const PlaneMachine& on, unsigned seed) {
  const channels::MachineConfig machine = machine_called(on.machine);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::string text = "T2 M6\nS1000 M3\nG54 G0 X0 Y0 Z90\nG43.5 H2\n";
  VectorProgram program;
  for (int n = 0; n < 200; ++n) {
    const Point tip(20.0 * part(random), 20.0 * part(random), 30.0 + 5.0 * part(random));
    const Point vector(0.3 * part(random), 0.3 * part(random), 1.0);
    const double length = n % 3 == 0 ? 1.0 : 40.0 + 39.0 * part(random);
    char direction[120];
    std::snprintf(direction, sizeof direction, " I%.13f J%.13f K%.13f F300\n", length * vector.x(),
                  length * vector.y(), length * vector.z());
    text += "G1" + words(tip) + direction;
    program.wanted.emplace_back(tip, vector.normalized());
  }
  std::uint64_t block = 0;
  for (const FeedEnd& end : feed_ends(machine, text + "G49\nM30\n", on.scheme)) {
    if (end.block != block) program.parts.emplace_back();
    block = end.block;
    program.parts.back().push_back(end);
  }
  EXPECT_EQ(program.parts.size(), program.wanted.size());
  return program;
}

// G43.5: at the end of each move the tip is at its point and the tool along its vector, whose
// length does not count.
TEST_P(ThreePlanes, AndVectorsPointTheTool) {
  const VectorProgram program = random_vectors(GetParam(), 20);
  const auto tip_of = [](const FeedEnd& end) {
    return Point(end.tip_B[0], end.tip_B[1], end.tip_B[2]);
  };
  const Point offset = tip_of(program.parts.front().back()) - program.wanted.front().first;
  EXPECT_LT(std::hypot(offset.x(), offset.y()), 1e-9);
  for (std::size_t n = 0; n < program.wanted.size(); ++n) {
    const FeedEnd& end = program.parts[n].back();
    EXPECT_LT((tip_of(end) - program.wanted[n].first - offset).norm(), 1e-9) << "move " << n;
    EXPECT_LT((end.tool_B - program.wanted[n].second).norm(), 1e-9) << "move " << n;
  }
}

// Between two vectors the tool stays in their plane within 0.005 deg, goes on all the time, and the
// tip goes straight, however near to a pole the way leads.
TEST_P(ThreePlanes, AndBetweenVectorsTheToolGoesOnTheGreatCircle) {
  const VectorProgram program = random_vectors(GetParam(), 21);
  double most_off_deg = 0.0;
  for (std::size_t n = 1; n < program.wanted.size(); ++n) {
    const Point& from = program.wanted[n - 1].second;
    const Point& to = program.wanted[n].second;
    const Point normal = from.cross(to).normalized();
    const double whole = std::acos(std::clamp(from.dot(to), -1.0, 1.0));
    const Point way = program.wanted[n].first - program.wanted[n - 1].first;
    const motion::Point& start_B = program.parts[n - 1].back().tip_B;
    for (const FeedEnd& end : program.parts[n]) {
      for (const Point& tool : end.tools_B)
        most_off_deg = std::max(most_off_deg, deg_of_plane * std::asin(std::abs(tool.dot(normal))));
      // Straight, and even: the angle gone is the part of the way gone.
      const Point gone(end.tip_B[0] - start_B[0], end.tip_B[1] - start_B[1],
                       end.tip_B[2] - start_B[2]);
      EXPECT_LT(gone.cross(way).norm(), 1e-9 * (1.0 + way.squaredNorm()));
      const double angle = std::atan2(from.cross(end.tool_B).norm(), from.dot(end.tool_B));
      EXPECT_NEAR(angle, whole * gone.norm() / way.norm(), 1e-7);
    }
  }
  EXPECT_LE(most_off_deg, 0.0055);
  EXPECT_GT(most_off_deg, 0.0001);
}

// The angles of the same directions, under #orientation (vector): the same ways, to the programmed
// angles. Where a part of a move ends the tool is in the plane of both directions within 1e-9.
TEST_P(ThreePlanes, AndAnglesOnTheGreatCircleAreItsVectors) {
  const channels::MachineConfig machine = machine_called(GetParam().machine);
  const VectorProgram vectors = random_vectors(GetParam(), 22);
  std::string text = "T2 M6\nS1000 M3\nG54 G0 X0 Y0 Z90\nG43.4 H2\n#orientation (vector)\n";
  const std::string rotary = machine.name == "trunnion" ? "AC" : "BC";
  for (std::size_t n = 0; n < vectors.wanted.size(); ++n) {
    const motion::Point& axes = vectors.parts[n].back().tip_B;
    char angles[96];
    std::snprintf(angles, sizeof angles, " %c%.13f %c%.13f F300\n", rotary[0], axes[3], rotary[1],
                  axes[4]);
    text += "G1" + words(vectors.wanted[n].first) + angles;
  }
  const auto ends = feed_ends(machine, text + "G49\nM30\n", GetParam().scheme);
  std::size_t at = 0;
  for (std::size_t n = 0; n < vectors.wanted.size(); ++n) {
    const Point normal =
        n == 0 ? Point::Zero()
               : Point(vectors.wanted[n - 1].second.cross(vectors.wanted[n].second).normalized());
    for (const FeedEnd& part : vectors.parts[n]) {
      ASSERT_LT(at, ends.size());
      EXPECT_LT(std::abs(ends[at].tool_B.dot(normal)), 1e-9) << "move " << n;
      for (std::size_t axis = 0; axis < 5; ++axis)
        EXPECT_NEAR(ends[at].axes_M[axis], part.axes_M[axis], 1e-9) << "move " << n;
      ++at;
    }
  }
  EXPECT_EQ(at, ends.size());
}

INSTANTIATE_TEST_SUITE_P(Machines, ThreePlanes,
                         ::testing::Values(PlaneMachine{"table_table", "trunnion.toml", -1},
                                           PlaneMachine{"head_table", "e7106mf4.toml", 2}),
                         [](const auto& info) { return info.param.name; });

// The tip stands while the axes turn: its position in B is the same before and after.
TEST(TiltedPlaneOnMachine, KeepsTheTipWhileItAligns) {
  const channels::MachineConfig machine = machine_called("trunnion.toml");
  const std::string begin = "T2 M6\nS1000 M3\nG54 G43.4 H2 F500\nG1 X10 Y20 Z30\nG49\nG43 H2\n";
  const auto ends =
      feed_ends(machine, begin + "G68.2 I30 J25\nG53.6\nG91 G1 X0 Y0 Z0\nG90 G69\nM30\n");
  ASSERT_EQ(ends.size(), 2U);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(ends[0].tip_B[axis], ends[1].tip_B[axis], 1e-9);
  EXPECT_GT(std::abs(ends[1].axes_M[3] - ends[0].axes_M[3]), 20.0);
}

// G54.2 on a trunnion: A about X through (0, 10, -600), C about Z, whose plate begins (0, -35, 40)
// from there. The offset is measured from the middle of the plate with A and C at 0; the axes X, Y
// and Z of the program stay those of the machine.
TEST(TiltedPlaneOnMachine, CarriesAWorkOffsetWithTheTable) {
  const channels::MachineConfig machine = machine_called("trunnion.toml");
  const Point offset(30.0, -12.5, 60.0);
  const double length = 130.0;
  const std::array<Point, 4> points{Point(0, 0, 5), Point(12.5, 3, -1), Point(-7, 9.25, 20),
                                    Point(4, 4, 4)};
  const std::array<std::array<double, 2>, 4> angles{{{0, 0}, {-30, 40}, {-90, 155}, {20, -75}}};
  std::string text =
      "T2 M6\nS1000 M3\nG43 H2 F3000\nG10 L2 P2 X30 Y-12.5 Z60 A0 C0\nG54.2 P2\nG0 Z120\n";
  for (std::size_t n = 0; n < points.size(); ++n) {
    char turn[48];
    std::snprintf(turn, sizeof turn, "A%g C%g\n", angles[n][0], angles[n][1]);
    text += "G0 " + std::string(turn) + "G1" + words(points[n]) + "\n";
  }
  text += "G1 A0 C0\n";  // X, Y and Z follow
  const auto ends = feed_ends(machine, text + "G54.2 P0\nM30\n");
  ASSERT_EQ(ends.size(), points.size() + 1);
  const Point centre(0.0, 10.0, -600.0);
  const Point plate(0.0, -35.0, 40.0);
  for (std::size_t n = 0; n < ends.size(); ++n) {
    const auto [a, c] = n < angles.size() ? angles[n] : angles[0];
    const Point& point = n < points.size() ? points[n] : points.back();
    const auto about = [](const Point& axis, double deg) {
      return Eigen::AngleAxisd(deg / deg_of_plane, axis).toRotationMatrix();
    };
    const Point zero =
        centre + about(Point::UnitX(), a) * (plate + about(Point::UnitZ(), c) * offset);
    const Point nose = zero + point + Point(0.0, 0.0, length);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(ends[n].axes_M[k], nose[static_cast<Eigen::Index>(k)], 1e-9)
          << "point " << n << " axis " << k;
  }
}

// G54.4: the part lies shifted, and turned about X, Y and Z one after the other.
TEST_P(ThreePlanes, AndASetUpErrorTurnsPointsAndDirections) {
  const channels::MachineConfig machine = machine_called(GetParam().machine);
  const auto about = [](const Point& axis, double deg) {
    return Eigen::AngleAxisd(deg / deg_of_plane, axis).toRotationMatrix();
  };
  const Eigen::Matrix3d lies =
      about(Point::UnitZ(), -1.2) * about(Point::UnitY(), 0.8) * about(Point::UnitX(), 1.5);
  const Point shift(0.4, -0.7, 0.25);
  const std::string head = "T2 M6\nS1000 M3\nG54 G0 X0 Y0 Z90\n";
  const std::string error = "G54.4 X0.4 Y-0.7 Z0.25 I1.5 J0.8 K-1.2\n";
  const std::string rotary = machine.name == "trunnion" ? "AC" : "BC";
  const VectorProgram drawn = random_vectors(GetParam(), 23);
  std::string vectors = head + error + "G43.5 H2\n";
  std::string angles = head + error + "G43.4 H2\n";
  for (std::size_t n = 0; n < drawn.wanted.size(); ++n) {
    const auto& [tip, tool] = drawn.wanted[n];
    char turn[120];
    std::snprintf(turn, sizeof turn, " I%.13f J%.13f K%.13f F300\n", tool.x(), tool.y(), tool.z());
    vectors += "G1" + words(tip) + turn;
    const motion::Point& axes = drawn.parts[n].back().tip_B;
    std::snprintf(turn, sizeof turn, " %c%.13f %c%.13f F300\n", rotary[0], axes[3], rotary[1],
                  axes[4]);
    angles += "G1" + words(tip) + turn;
  }
  const Point offset = Point(drawn.parts[0].back().tip_B[0], drawn.parts[0].back().tip_B[1],
                             drawn.parts[0].back().tip_B[2]) -
                       drawn.wanted[0].first;
  for (const std::string& text : {vectors, angles}) {
    std::vector<FeedEnd> last;  // of each block
    for (const FeedEnd& end : feed_ends(machine, text + "G49\nM30\n", GetParam().scheme)) {
      if (!last.empty() && last.back().block == end.block) last.pop_back();
      last.push_back(end);
    }
    ASSERT_EQ(last.size(), drawn.wanted.size());
    for (std::size_t n = 0; n < last.size(); ++n) {
      const Point tip(last[n].tip_B[0], last[n].tip_B[1], last[n].tip_B[2]);
      const Point place = shift + lies * drawn.wanted[n].first;
      EXPECT_LT((tip - offset - place).norm(), 1e-9) << "move " << n;
      EXPECT_LT((last[n].tool_B - lies * drawn.wanted[n].second).norm(), 1e-9) << "move " << n;
    }
  }
}

// A plane, aligned on the part as it lies; behind it the tool stays where it stands.
TEST_P(ThreePlanes, AndAPlaneLiesOnTheSetUpError) {
  const channels::MachineConfig machine = machine_called(GetParam().machine);
  const auto ends = feed_ends(machine,
                              "T2 M6\nS1000 M3\nG54 G43 H2\nG0 X0 Y0 Z90\nG54.4 X1 I2\n"
                              "G68.2 X4 Y-6 Z2 I30 J20\nG53.1\nG1 X3 Y5 Z1 F500\nG69\n"
                              "G43.4 H2\nG1 X0 Y0 Z50\nG49\nM30\n",
                              GetParam().scheme);
  ASSERT_EQ(ends.size(), 2U);
  const Eigen::Matrix3d lies = plane_turn(0.0, 2.0, 0.0);
  const Eigen::Matrix3d turn = plane_turn(30.0, 20.0, 0.0);
  const Point tip(ends[0].tip_B[0], ends[0].tip_B[1], ends[0].tip_B[2]);
  const Point place = Point(1, 0, 0) + lies * (Point(4, -6, 2) + turn * Point(3, 5, 1));
  const Point offset = tip - place;
  EXPECT_LT(std::hypot(offset.x(), offset.y()), 1e-9);  // the work offset lies along Z
  for (const FeedEnd& end : ends)
    EXPECT_LT((end.tool_B - lies * turn * Point::UnitZ()).norm(), 1e-9);
}

Diagnostics checked_plane(const std::string& machine, const std::string& program) {
  return jobs::check_program(machine_called(machine), 1, -1, "plane.nc", PlaneProgram(program))
      .diagnostics;
}

TEST(TiltedPlaneOnMachine, NamesAxisLimitAndTheNearestDirection) {
  // The cradle reaches from -120 to 30 deg: P1 wants it at +50.
  const Diagnostics found = checked_plane("trunnion.toml", "G54\nG68.2 J50\nG53.1 P1\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E4354");
  EXPECT_EQ(found[0].place.line, 3);
  for (const char* part : {"A would have to be at 50 deg", "its limit is 30 deg", "G53.1"})
    EXPECT_NE(found[0].message.find(part), std::string::npos) << found[0].message;
  EXPECT_FALSE(found[0].help.empty());
  EXPECT_TRUE(checked_plane("trunnion.toml", "G54\nG68.2 J50\nG53.1\nM30\n").empty());
}

PlanePositions positions(const std::string& machine, const std::string& program) {
  const jobs::DryRunResult found =
      jobs::check_program(machine_called(machine), 1, -1, "plane.nc", PlaneProgram(program));
  EXPECT_TRUE(found.diagnostics.empty()) << found.diagnostics[0].message;
  return found.planes;
}

void expect_angles(const std::vector<RotaryAngle>& axes, double a, double c) {
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes[0].word, "A");
  EXPECT_EQ(axes[1].word, "C");
  EXPECT_NEAR(axes[0].deg, a, 1e-9);
  EXPECT_NEAR(std::remainder(axes[1].deg - c, 360.0), 0.0, 1e-9);
}

// The face falls towards -Y: the cradle lifts it at -J, or at J with the table turned about.
TEST(TiltedPlaneOnMachine, TellsThePositionThatItTakesAndTheOther) {
  const auto planes =
      positions("trunnion.toml", "G54\nG68.2 J25\nG53.1\nG69\nG68.2 J25\nG53.6 P1\nG69\nM30\n");
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].place.file, "plane.nc");
  EXPECT_EQ(planes[0].place.line, 3);
  EXPECT_NEAR(planes[0].tool[1], -std::sin(25.0 / deg_of_plane), 1e-12);
  EXPECT_NEAR(planes[0].tool[2], std::cos(25.0 / deg_of_plane), 1e-12);
  expect_angles(planes[0].axes, -25.0, 0.0);
  ASSERT_TRUE(planes[0].other);
  EXPECT_EQ(planes[0].other->word, "P1");
  expect_angles(planes[0].other->axes, 25.0, 180.0);
  EXPECT_FALSE(planes[0].other->limit_deg);
  EXPECT_EQ(planes[1].place.line, 6);
  expect_angles(planes[1].axes, 25.0, 180.0);
  ASSERT_TRUE(planes[1].other);
  EXPECT_EQ(planes[1].other->word, "P2");
  expect_angles(planes[1].other->axes, -25.0, 0.0);
}

TEST(TiltedPlaneOnMachine, TellsTheLimitOfTheOtherPosition) {
  const auto planes = positions("trunnion.toml", "G54\nG68.2 J50\nG53.1\nG69\nM30\n");
  ASSERT_EQ(planes.size(), 1U);
  expect_angles(planes[0].axes, -50.0, 0.0);
  ASSERT_TRUE(planes[0].other);
  ASSERT_EQ(planes[0].other->axes.size(), 1U);
  EXPECT_EQ(planes[0].other->axes[0].word, "A");
  EXPECT_NEAR(planes[0].other->axes[0].deg, 50.0, 1e-9);
  EXPECT_NEAR(planes[0].other->limit_deg.value(), 30.0, 1e-9);
}

// The tip is held, and Y would have to go too far: what the other position comes to helps then.
TEST(TiltedPlaneOnMachine, TellsAPositionThatAnotherAxisCannotFollow) {
  const jobs::DryRunResult found =
      jobs::check_program(machine_called("trunnion.toml"), 1, -1, "plane.nc",
                          PlaneProgram("G54\nG68.2 J35\nG53.6\nG69\nM30\n"));
  ASSERT_EQ(found.diagnostics.size(), 1U);
  EXPECT_EQ(found.diagnostics[0].code, "E5101");
  ASSERT_EQ(found.planes.size(), 1U);
  expect_angles(found.planes[0].axes, -35.0, 0.0);
  ASSERT_TRUE(found.planes[0].other);
}

TEST(TiltedPlaneOnMachine, TellsAPositionOnceAndNoneBesideThePole) {
  const auto planes = positions("trunnion.toml",
                                "G54\nnum turn = 0;\nwhile (turn < 3)\n{\nG68.2 J0\nG53.1\nG69\n"
                                "G68.2 J10\nG53.1\nG69\nturn = turn + 1;\n}\nM30\n");
  ASSERT_EQ(planes.size(), 2U);
  expect_angles(planes[0].axes, 0.0, 0.0);
  EXPECT_FALSE(planes[0].other);
  expect_angles(planes[1].axes, -10.0, 0.0);
}

// The parts of a move are one move: the axes stand at its end, and nowhere before.
TEST(TiltedPlaneOnMachine, AVectorMoveStandsAtItsEndAloneInExactStop) {
  const auto ends = feed_ends(machine_called("trunnion.toml"),
                              "T2 M6\nS1000 M3\nG54 G0 X0 Y0 Z90\nG61.1 G43.5 H2\nG0 I0.3 K1 Z30\n"
                              "G1 X10 J0.3 K1 F300\nX0 I0.3 K1\nG49\nM30\n");
  ASSERT_GT(ends.size(), 10U);
  for (std::size_t n = 0; n < ends.size(); ++n) {
    const bool is_last = n + 1 == ends.size() || ends[n + 1].block != ends[n].block;
    EXPECT_EQ(ends[n].stops, is_last) << n;
  }
}

TEST(TiltedPlaneOnMachine, RefusesAVectorWithTheOtherBranchOnTheWay) {
  // From A at 20 deg on, where the cradle ends at 30 deg: a vector at 60 deg is reached by the
  // other branch alone, for which the tool would turn about in the cut.
  const std::string program = "T2 M6\nS1000 M3\nG54 G0 X0 Y0 Z90\nG43.5 H2\nG0 J0.3640 K1 Z30\n";
  const std::string move = " X10 J1.7320 K1 F500\nG49\nM30\n";
  const Diagnostics found = checked_plane("trunnion.toml", program + "G1" + move);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E4354");
  EXPECT_EQ(found[0].place.line, 6);
  EXPECT_NE(found[0].message.find("other position"), std::string::npos) << found[0].message;
  EXPECT_TRUE(checked_plane("trunnion.toml", program + "G0" + move).empty());
}

// A20 C180 leans the tool as A-20 C0 does, but is another position of the axes than the one in
// which the circle from A-30 C0 ends.
TEST(TiltedPlaneOnMachine, RefusesAnglesThatLeaveTheGreatCircle) {
  const std::string program =
      "T2 M6\nS1000 M3\nG54 G0 X0 Y0 Z90\nG43.4 H2\nG0 A-30 C0 Z30\n#orientation (vector)\n";
  const Diagnostics found =
      checked_plane("trunnion.toml", program + "G1 X10 A20 C180 F500\nG49\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E4354");
  EXPECT_EQ(found[0].place.line, 7);
  EXPECT_TRUE(checked_plane("trunnion.toml",
                            program + "#orientation (axis)\nG1 X10 A20 C180 F500\nG49\nM30\n")
                  .empty());
}

TEST(TiltedPlaneOnMachine, NeedsATableThatCarriesTheOffset) {
  const Diagnostics found = checked_plane("mill5.toml", "G54\nG54.2 P1\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E4353");
  EXPECT_NE(found[0].message.find("table"), std::string::npos);
}

TEST(TiltedPlaneOnMachine, NeedsASchemeThatInclinesTheTool) {
  const Diagnostics found = checked_plane("mill5.toml", "G54\nG68.2 J50\nG53.1\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E4353");
}

}  // namespace
}  // namespace stanok::runtime
