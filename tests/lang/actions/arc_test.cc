// Arcs: centres from words and radii, planes, helices, faults.
#include <cmath>
#include <numbers>
#include <random>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class Arc : public ProgramTest {};

TEST_F(Arc, TakesTheCentreFromTheStartPoint) {
  const auto list = moves("G0 X10 Y5\nG2 X20 Y15 I10 J0 F100\nG90.1 G3 X10 Y5 I20 J5\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].kind, MoveKind::arc);
  EXPECT_FALSE(list[1].counter_clockwise);
  EXPECT_EQ(list[1].centre, (std::array{20.0, 5.0}));
  EXPECT_EQ(list[1].end[0], 20.0);
  EXPECT_EQ(list[1].turns, 1);
  EXPECT_TRUE(list[2].counter_clockwise);
  EXPECT_EQ(list[2].centre, (std::array{20.0, 5.0}));
}

TEST_F(Arc, IsAFullCircleWhenTheEndIsTheStart) {
  const auto list = moves("G0 X10\nG3 I-10 F100\nG2 X10 Y0 J3 P2\nI1\nM30\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[1].words, 0);
  EXPECT_EQ(list[1].end[0], 10.0);
  EXPECT_EQ(list[1].centre, (std::array{0.0, 0.0}));
  EXPECT_EQ(list[2].turns, 2);
  EXPECT_EQ(list[3].centre, (std::array{11.0, 0.0}));
}

TEST_F(Arc, UsesThePlanesWords) {
  const auto list = moves("G18 G0 X10 Z0\nG2 X0 Z10 K0 I-10 F100\nG19 G3 Y0 Z10 J5 K0 X3\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].plane, Plane::zx);
  EXPECT_EQ(list[1].centre, (std::array{0.0, 0.0}));  // Z, X
  EXPECT_EQ(list[2].plane, Plane::yz);
  EXPECT_EQ(list[2].centre, (std::array{5.0, 10.0}));
  EXPECT_EQ(list[2].end[0], 3.0);  // helix
}

TEST_F(Arc, HalvesDiametersButNotRadiiAndCentres) {
  channel.kind = ChannelKind::lathe;
  const auto list = moves("G94 G0 X20 Z0\nG2 X40 Z-10 I10 K0 F100\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].end[0], 10.0);
  EXPECT_EQ(list[1].end[0], 20.0);
  EXPECT_EQ(list[1].centre, (std::array{0.0, 20.0}));
}

// The centre of a radius arc lies |R| from both ends, on the side that makes the arc less than half
// a turn for R > 0 and more for R < 0.
TEST_F(Arc, FindsTheCentreOfARadius) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-100.0, 100.0);
  for (int n = 0; n < 200; ++n) {
    const double x0 = std::round(coordinate(random) * 1000.0) / 1000.0;
    const double y0 = std::round(coordinate(random) * 1000.0) / 1000.0;
    const double x1 = std::round(coordinate(random) * 1000.0) / 1000.0;
    const double y1 = std::round(coordinate(random) * 1000.0) / 1000.0;
    const double chord = std::hypot(x1 - x0, y1 - y0);
    const double radius = (n % 2 == 0 ? 1.0 : -1.0) * (chord * (0.51 + (n % 7) * 0.3));
    const bool ccw = n % 3 == 0;
    char text[256];
    std::snprintf(text, sizeof text, "G0 X%.3f Y%.3f\n%s X%.3f Y%.3f R%.9f F100\nM30\n", x0, y0,
                  ccw ? "G3" : "G2", x1, y1, radius);
    const auto list = moves(text);
    ASSERT_EQ(list.size(), 2u) << text;
    const auto [cx, cy] = list[1].centre;
    EXPECT_NEAR(std::hypot(cx - x0, cy - y0), std::abs(radius), 1e-6) << text;
    EXPECT_NEAR(std::hypot(cx - x1, cy - y1), std::abs(radius), 1e-6) << text;
    const double from = std::atan2(y0 - cy, x0 - cx);
    const double to = std::atan2(y1 - cy, x1 - cx);
    double sweep = ccw ? to - from : from - to;
    if (sweep < 0.0) sweep += 2.0 * std::numbers::pi;
    EXPECT_EQ(sweep < std::numbers::pi, radius > 0.0) << text;
  }
}

TEST_F(Arc, AcceptsHalfACircleByItsRadius) {
  const auto list = moves("G2 X20 R10 F100\nG91 G3 X10 R4.999999\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_NEAR(list[0].centre[0], 10.0, 1e-12);
  EXPECT_NEAR(list[0].centre[1], 0.0, 1e-12);
  EXPECT_NEAR(list[1].centre[0], 25.0, 1e-12);
}

struct ArcFaultCase {
  const char* name;
  const char* text;
  const char* code;
  int column;
};

class ArcFault : public ProgramTest, public ::testing::WithParamInterface<ArcFaultCase> {};

TEST_P(ArcFault, IsReportedAtItsWord) {
  EXPECT_EQ(error_code(std::string("F100 G0 X10 Y0\n") + GetParam().text + "\nM30\n"),
            GetParam().code);
  EXPECT_EQ(error.place.line, 2);
  EXPECT_EQ(error.place.column, GetParam().column);
}

INSTANTIATE_TEST_SUITE_P(
    Arcs, ArcFault,
    ::testing::Values(ArcFaultCase{"NoCentre", "N120 G2 X40 Y10", "E4031", 6},
                      ArcFaultCase{"OtherRadius", "G2 X40 Y10 I5", "E4032", 1},
                      ArcFaultCase{"ZeroRadius", "G3 X40 I0 J0", "E4033", 1},
                      ArcFaultCase{"CircleByRadius", "G3 X10 Y0 R5", "E4034", 11},
                      ArcFaultCase{"RadiusTooSmall", "G3 X40 Y0 R5", "E4035", 11},
                      ArcFaultCase{"WrongPlaneWord", "G3 X40 Y0 K5", "E4030", 11},
                      ArcFaultCase{"CentreAndRadius", "G3 X40 Y0 I5 R5", "E4037", 14},
                      ArcFaultCase{"IncompleteCentre", "G90.1 G3 X40 I25", "E4038", 1},
                      ArcFaultCase{"Turns", "G3 X10 I5 P0", "E4008", 11},
                      ArcFaultCase{"BrokenTurns", "G3 X10 I5 P=1+0.5", "E4008", 11}),
    [](const auto& one) { return one.param.name; });

TEST_F(Arc, NamesThePlaneInItsFault) {
  EXPECT_EQ(error_code("G17 F300\nN120 G2 X40 Y10\nM30\n"), "E4031");
  EXPECT_EQ(error.message, "`G2` needs I, J or R");
  EXPECT_EQ(error.label, "arc in plane G17 without centre or radius");
  EXPECT_EQ(error.source_line, "N120 G2 X40 Y10");
  ASSERT_EQ(error.notes.size(), 1u);
  EXPECT_EQ(error.notes[0].text, "G17 is active by default");
  EXPECT_EQ(error_code("F300 G18\nG17\nN120 G2 X40 Y10\nM30\n"), "E4031");
  EXPECT_EQ(error.notes.at(0).text, "G17 is active since line 2");
}

}  // namespace
}  // namespace stanok::lang::testing
