// Chains of segments: order, continuity, tolerance, stops, soft limits.
#include "motion/segments/path_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

using std::numbers::pi;
using Built = PathBuilder::Built;

// Without smooth runs: every join is one of its own.
MotionConfig blending_mill(int axis_count) {
  MotionConfig config = mill(axis_count);
  config.run_turn_max_deg = 0.0;
  return config;
}

struct Program {
  Point start{};
  std::vector<PathBlock> blocks;
};

std::vector<Built> build(const Program& program, const MotionConfig& config) {
  PathBuilder builder(config);
  builder.restart(program.start);
  for (const PathBlock& block : program.blocks) {
    EXPECT_FALSE(builder.add(block).has_value());
  }
  builder.finish();
  return builder.built();
}

// Lines and arcs in a row, with turns of all sizes, some tangent, in 3 or 5 axes.
Program random_program(Random& random, int axis_count, int block_count) {
  Program program;
  Point at{};
  double heading = 0.0;
  for (int n = 0; n < block_count; ++n) {
    const double size = std::pow(10.0, random.between(-1.5, 1.5));
    if (!random.chance(0.3)) heading += random.between(-2.8, 2.8) * random.between(0.0, 1.0);
    Point end = at;
    for (std::size_t k = 2; k < static_cast<std::size_t>(axis_count); ++k) {
      if (random.chance(0.6)) end[k] += size * random.between(-0.5, 0.5);
    }
    PathBlock block;
    if (random.chance(0.4)) {
      const double side = random.chance(0.5) ? 1.0 : -1.0;
      const double sweep = side * random.between(0.1, 4.0);
      const std::array<double, 2> centre{at[0] - side * size * std::sin(heading),
                                         at[1] + side * size * std::cos(heading)};
      block = arc_to(at, centre, sweep, end, std::pow(10.0, random.between(-0.5, 2.0)));
      heading += sweep;
    } else {
      end[0] += size * std::cos(heading);
      end[1] += size * std::sin(heading);
      block = line_to(end, std::pow(10.0, random.between(-0.5, 2.0)));
    }
    block.tag.block = static_cast<std::uint64_t>(n);
    program.blocks.push_back(block);
    at = block.end;
  }
  return program;
}

double xyz_distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Parameter of the nearest point of the course between two parameters: scan, then golden section.
double nearest(const Course& course, const Point& p, double from, double to) {
  constexpr int steps = 24;
  double best = from;
  for (int i = 0; i <= steps; ++i) {
    const double u = from + (to - from) * i / steps;
    if (xyz_distance(course.at(u), p) < xyz_distance(course.at(best), p)) best = u;
  }
  double low = std::max(from, best - (to - from) / steps);
  double high = std::min(to, best + (to - from) / steps);
  for (int i = 0; i < 40; ++i) {
    const double a = low + 0.381966 * (high - low);
    const double b = high - 0.381966 * (high - low);
    (xyz_distance(course.at(a), p) < xyz_distance(course.at(b), p) ? high : low) =
        xyz_distance(course.at(a), p) < xyz_distance(course.at(b), p) ? b : a;
  }
  return 0.5 * (low + high);
}

struct Deviation {
  double mm = 0.0;
  double deg = 0.0;
};

Deviation deviation_at(const Course& course, const Point& p, double from, double to,
                       int axis_count) {
  const Point foot = course.at(nearest(course, p, from, to));
  Deviation d{xyz_distance(foot, p), 0.0};
  for (std::size_t k = 3; k < static_cast<std::size_t>(axis_count); ++k) {
    d.deg = std::max(d.deg, std::abs(foot[k] - p[k]));
  }
  return d;
}

// Deviation of every blend from the two blocks it joins, and of the corners from the blends.
Deviation worst_deviation(const Program& program, const std::vector<Built>& built, int axis_count) {
  std::vector<Course> courses;
  Point at = program.start;
  for (const PathBlock& block : program.blocks) {
    courses.push_back({at, &block});
    at = block.end;
  }
  Deviation worst;
  double corner = unlimited;
  for (std::size_t k = 0; k < built.size(); ++k) {
    const Built& b = built[k];
    if (b.segment.geometry.kind != SegmentKind::quintic) continue;
    const auto n = static_cast<std::size_t>(b.segment.tag.block);
    for (int i = 0; i <= 60; ++i) {
      JetPoint jet;
      evaluate(b.segment, b.segment.length * i / 60.0, jet);
      Point p{};
      for (std::size_t k = 0; k < 5; ++k) p[k] = jet[k].value;
      const Deviation before = deviation_at(courses[n], p, 0.0, 1.0, axis_count);
      const Deviation after = deviation_at(courses[n + 1], p, 0.0, 0.6, axis_count);
      const Deviation& nearer = before.mm < after.mm ? before : after;
      worst.mm = std::max(worst.mm, nearer.mm);
      worst.deg = std::max(worst.deg, nearer.deg);
      corner = std::min(corner, xyz_distance(p, program.blocks[n].end));
    }
    const bool goes_on = k + 1 < built.size() &&
                         built[k + 1].segment.geometry.kind == SegmentKind::quintic &&
                         built[k + 1].segment.tag.block == n;
    if (goes_on) continue;  // a curve in several parts
    // Chords of 1/60 of the curve pass the corner at most that much farther off.
    worst.mm = std::max(worst.mm, corner - b.segment.length / 120.0);
    corner = unlimited;
  }
  return worst;
}

class Axes : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(ThreeAndFive, Axes, ::testing::Values(3, 5));

TEST_P(Axes, BlendsStayWithinTolerance) {
  const MotionConfig config = blending_mill(GetParam());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Program program = random_program(random, GetParam(), 25);
    const double mm = std::pow(10.0, random.between(-3.0, -0.5));
    const double deg = std::pow(10.0, random.between(-2.5, 0.0));
    for (PathBlock& block : program.blocks) {
      block.tolerance_mm = mm;
      block.tolerance_deg = deg;
    }
    const std::vector<Built> built = build(program, config);
    const Deviation worst = worst_deviation(program, built, GetParam());
    EXPECT_LE(worst.mm, mm);
    EXPECT_LE(worst.deg, deg);
  }
}

// Relative to the size of the values that meet.
void expect_continuous(const Segment& before, const Segment& after, int axis_count) {
  JetPoint end;
  JetPoint start;
  evaluate(before, before.length, end);
  evaluate(after, 0.0, start);
  for (std::size_t k = 0; k < static_cast<std::size_t>(axis_count); ++k) {
    EXPECT_EQ(end[k].value, start[k].value);
    EXPECT_NEAR(end[k].first, start[k].first, 1e-9 * (1.0 + std::abs(end[k].first)));
    const double curvature_scale =
        std::abs(end[k].second) + 1.0 / before.length + 1.0 / after.length;
    EXPECT_NEAR(end[k].second, start[k].second, 1e-9 * curvature_scale);
  }
}

TEST_P(Axes, TangentAndCurvatureContinueAcrossJoins) {
  const MotionConfig config = blending_mill(GetParam());
  int joins = 0;
  for (std::uint64_t seed = 100; seed < 180; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Program program = random_program(random, GetParam(), 40);
    const std::vector<Built> built = build(program, config);
    for (std::size_t i = 0; i + 1 < built.size(); ++i) {
      ASSERT_GT(built[i].segment.length, 0.0);
      ASSERT_LE(built[i].segment.tag.block, built[i + 1].segment.tag.block);
      if (built[i].ends_chain) {
        EXPECT_EQ(built[i].segment.geometry.end, built[i + 1].segment.geometry.start);
        continue;
      }
      ++joins;
      expect_continuous(built[i].segment, built[i + 1].segment, GetParam());
    }
    ASSERT_TRUE(built.back().ends_chain);
    EXPECT_EQ(built.back().segment.geometry.end, program.blocks.back().end);
    EXPECT_EQ(built.front().segment.geometry.start, program.start);
  }
  EXPECT_GT(joins, 3000);
}

TEST(PathBuilder, RightAngleDeviatesByTheClosedForm) {
  // e = L (1 + 5 beta + 10 gamma) / 16 * sin(theta / 2); 3 % are kept in reserve.
  const std::vector<Built> built =
      build({{}, {line_to({10.0, 0.0}, 2.0), line_to({10.0, 10.0}, 2.0)}}, blending_mill(3));
  ASSERT_EQ(built.size(), 3U);
  const double reach = 0.97 * 0.01 * 16.0 / ((1.0 + 5.0 * 0.6 + 10.0 * 0.15) * std::sin(pi / 4.0));
  EXPECT_NEAR(built[0].segment.length, 10.0 - reach, 1e-12);
  JetPoint middle;
  evaluate(built[1].segment, 0.5 * built[1].segment.length, middle);
  EXPECT_NEAR(std::hypot(middle[0].value - 10.0, middle[1].value), 0.0097, 1e-10);
}

TEST(PathBuilder, CollinearLinesPassWithoutBlend) {
  const std::vector<Built> built =
      build({{}, {line_to({1.0, 2.0, 3.0}), line_to({2.0, 4.0, 6.0})}}, blending_mill(3));
  ASSERT_EQ(built.size(), 2U);
  EXPECT_EQ(built[0].segment.geometry.kind, SegmentKind::line);
  EXPECT_FALSE(built[0].ends_chain);
}

TEST(PathBuilder, KinkOfRotaryRateOnAStraightWayIsBlended) {
  const std::vector<Built> built =
      build({{}, {line_to({10.0, 0.0, 0.0, 5.0}, 2.0), line_to({20.0, 0.0, 0.0, 25.0}, 2.0)}},
            blending_mill(5));
  ASSERT_EQ(built.size(), 3U);
  EXPECT_EQ(built[1].segment.geometry.kind, SegmentKind::quintic);
  expect_continuous(built[0].segment, built[1].segment, 5);
}

TEST(PathBuilder, ArcsOfOneCirclePassWithoutBlend) {
  const Point start{10.0, 0.0};
  const PathBlock first = arc_to(start, {0.0, 0.0}, 0.5 * pi, {});
  const PathBlock second = arc_to(first.end, {0.0, 0.0}, pi, {});
  const std::vector<Built> built = build({start, {first, second}}, blending_mill(3));
  ASSERT_EQ(built.size(), 2U);
  EXPECT_FALSE(built[0].ends_chain);
}

TEST(PathBuilder, TangentLineAndArcAreJoinedByACurveForTheirStepOfCurvature) {
  const Point corner{10.0, 0.0};
  const std::vector<Built> built =
      build({{}, {line_to(corner), arc_to(corner, {10.0, 5.0}, pi, {})}}, blending_mill(3));
  ASSERT_EQ(built.size(), 6U);
  double length = 0.0;
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_EQ(built[k].segment.geometry.kind, SegmentKind::quintic);
    EXPECT_FALSE(built[k - 1].ends_chain || built[k].ends_chain);
    length += built[k].segment.length;
  }
  EXPECT_GT(length, 0.5);
}

struct StopCase {
  const char* name;
  PathBlock first;
  PathBlock second;
};
class Stops : public ::testing::TestWithParam<StopCase> {};

PathBlock with(PathBlock block, double tolerance_mm, BlockEnding ending) {
  block.tolerance_mm = tolerance_mm;
  block.ending = ending;
  return block;
}

TEST_P(Stops, EndTheChainAtTheProgrammedPoint) {
  const std::vector<Built> built =
      build({{}, {GetParam().first, GetParam().second}}, blending_mill(5));
  ASSERT_EQ(built.size(), 2U);
  EXPECT_TRUE(built[0].ends_chain);
  EXPECT_EQ(built[0].segment.geometry.end, GetParam().first.end);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Stops,
    ::testing::Values(
        StopCase{"exact_stop", with(line_to({9.0}), 0.01, BlockEnding::exact_stop),
                 line_to({9.0, 9.0})},
        StopCase{"exact_path_corner", with(line_to({9.0}), 0.0, BlockEnding::continuous),
                 line_to({9.0, 9.0})},
        StopCase{"exact_path_of_the_next_block", line_to({9.0}),
                 with(line_to({9.0, 9.0}), 0.0, BlockEnding::continuous)},
        StopCase{"turn_back", line_to({9.0}), line_to({0.0})},
        StopCase{"turn_of_170_deg", line_to({9.0}),
                 line_to({9.0 - 5.0 * std::cos(pi / 18.0), 5.0 * std::sin(pi / 18.0)})},
        StopCase{"mm_to_deg", line_to({9.0}), line_to({9.0, 0.0, 0.0, 45.0})}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(PathBuilder, RotaryWordsAloneMakeAWayInDegrees) {
  const std::vector<Built> built =
      build({{}, {line_to({0.0, 0.0, 0.0, 30.0, 40.0})}}, blending_mill(5));
  ASSERT_EQ(built.size(), 1U);
  EXPECT_DOUBLE_EQ(built[0].segment.length, 50.0);
}

TEST(PathBuilder, RotaryCornersAreBlendedWithinTheirTolerance) {
  const std::vector<Built> built = build(
      {{}, {line_to({0.0, 0.0, 0.0, 30.0, 0.0}, 2.0), line_to({0.0, 0.0, 0.0, 30.0, 30.0}, 2.0)}},
      blending_mill(5));
  ASSERT_EQ(built.size(), 3U);
  JetPoint middle;
  evaluate(built[1].segment, 0.5 * built[1].segment.length, middle);
  EXPECT_NEAR(30.0 - middle[3].value, 0.97 * 0.05, 1e-9);
  EXPECT_NEAR(middle[4].value, 0.97 * 0.05, 1e-9);
}

TEST(PathBuilder, RapidAndFeedBlendAtTheFeedOfTheSlower) {
  PathBlock rapid = line_to({10.0});
  rapid.rapid = true;
  const std::vector<Built> built =
      build({{}, {rapid, line_to({20.0, 0.1}, 30.0)}}, blending_mill(3));
  ASSERT_EQ(built.size(), 3U);
  EXPECT_TRUE(built[0].segment.rapid);
  EXPECT_EQ(built[0].segment.feed_per_s, unlimited);
  EXPECT_FALSE(built[1].segment.rapid);
  EXPECT_EQ(built[1].segment.feed_per_s, 30.0);
  EXPECT_DOUBLE_EQ(built[0].segment.bounds.velocity, 1.0 / 350.0);
  EXPECT_NEAR(built[2].segment.bounds.velocity, 1.0 / 400.0, 1e-6);
}

TEST(PathBuilder, BlocksWithoutMotionAreSwallowed) {
  const std::vector<Built> built =
      build({{}, {line_to({1.0}), line_to({1.0}), line_to({2.0})}}, blending_mill(3));
  ASSERT_EQ(built.size(), 2U);
  EXPECT_FALSE(built[0].ends_chain);
}

TEST(PathBuilder, ExactStopOfABlockWithoutMotionStopsThePathThere) {
  const std::vector<Built> built = build(
      {{}, {line_to({1.0}), with(line_to({1.0}), 0.01, BlockEnding::exact_stop), line_to({2.0})}},
      blending_mill(3));
  ASSERT_EQ(built.size(), 2U);
  EXPECT_TRUE(built[0].ends_chain);
}

// The next block says whether it goes on in the same line, the one behind that how both are joined.
TEST(PathBuilder, SegmentIsFinalTwoBlocksLater) {
  PathBuilder builder(blending_mill(3));
  builder.restart({});
  EXPECT_FALSE(builder.add(line_to({10.0})));
  EXPECT_FALSE(builder.add(line_to({20.0, 0.1})));
  EXPECT_TRUE(builder.built().empty());
  EXPECT_FALSE(builder.add(line_to({30.0, 0.3})));
  EXPECT_EQ(builder.built().size(), 2U);
  builder.finish();
  EXPECT_GT(builder.built().size(), 2U);
  EXPECT_EQ(builder.end(), (Point{30.0, 0.3}));
}

// Full stop from 83 mm/s at 50,000 mm/s^3: 2 sqrt(v / j) = 0.082 s. A right angle within 0.01 mm
// could be taken at about 2.5 mm/s over 0.1 mm: later.
TEST(PathBuilder, StopsWhereABlendWouldTakeLonger) {
  MotionConfig config = blending_mill(3);
  for (AxisLimits& axis : config.axes) axis.jerk_max = 50000.0;
  const auto corner = [&](double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return build({{}, {line_to({20.0}, 83.3), line_to({20.0 + 20.0 * c, 20.0 * s}, 83.3)}}, config);
  };
  EXPECT_TRUE(corner(pi / 2.0)[0].ends_chain);
  EXPECT_FALSE(corner(pi / 36.0)[0].ends_chain);
}

// Blocks of CAM length whose blends take half of each: all bits of joins are shared.
TEST(PathBuilder, DenseBlocksBecomeOneBlendEach) {
  Program program;
  for (int n = 1; n <= 1000; ++n) {
    const double angle = 0.001 * n;
    program.blocks.push_back(line_to({100.0 * std::sin(angle), 100.0 - 100.0 * std::cos(angle)}));
  }
  const std::vector<Built> built = build(program, blending_mill(3));
  EXPECT_LE(built.size(), 1002U);
  for (std::size_t i = 0; i + 1 < built.size(); ++i) {
    EXPECT_FALSE(built[i].ends_chain);
    expect_continuous(built[i].segment, built[i + 1].segment, 3);
  }
}

MotionConfig fenced(double x_max) {
  MotionConfig config = blending_mill(3);
  config.axes[0].position_max = x_max;
  return config;
}

TEST(SoftLimits, AreTouchedByTheCrestOfAnArc) {
  const Point start{0.0, -50.0};
  PathBuilder builder(fenced(50.0));
  builder.restart(start);
  EXPECT_FALSE(builder.add(arc_to(start, {0.0, 0.0}, pi, {})));
}

TEST(SoftLimits, NameAxisLimitAndPlaceOfTheCrestBeyond) {
  const Point start{50.0 * std::cos(-1.3), 50.0 * std::sin(-1.3)};
  PathBuilder builder(fenced(50.0 - 1e-6));
  builder.restart(start);
  PathBlock block = arc_to(start, {0.0, 0.0}, 2.0, {});
  block.tag.line = 17;
  const auto unreachable = builder.add(block);
  ASSERT_TRUE(unreachable);
  EXPECT_EQ(unreachable->axis, 0);
  EXPECT_EQ(unreachable->tag.line, 17U);
  EXPECT_EQ(unreachable->limit, 50.0 - 1e-6);
  EXPECT_NEAR(unreachable->position, 50.0, 1e-9);
  // The block is not taken.
  EXPECT_EQ(builder.end(), start);
  EXPECT_TRUE(builder.built().empty());
}

TEST(SoftLimits, ArcThatEndsBeforeItsCrestPasses) {
  const Point start{50.0 * std::cos(-1.3), 50.0 * std::sin(-1.3)};
  PathBuilder builder(fenced(49.9));
  builder.restart(start);
  EXPECT_FALSE(builder.add(arc_to(start, {0.0, 0.0}, 1.2, {})));
}

TEST(SoftLimits, HoldForTheLastTurnOfAHelixInATurnedFrame) {
  // Frame turned by 90 deg: the helix' linear axis Y drives X down, its radial wave rides on it.
  const auto scheme = head_table();
  kinematics::Transform transform;
  transform.scheme = scheme.get();
  transform.frame.rotation = Rotation::about({0, 0, 1}, 90);
  MotionConfig config = blending_mill(5);
  const Point start{0.0, 0.0, 10.0};
  PathBlock helix = line_to({0.0, 40.0, 10.0});
  helix.kind = BlockKind::arc;
  helix.plane = {2, 0};
  helix.centre = {0.0, 0.0};
  helix.sweep_rad = 10.0 * 2.0 * pi;
  helix.transform = &transform;
  // X_M = -y - nose and offsets of the scheme, all 0 here.
  for (const double margin : {1e-6, -1e-6}) {
    config.axes[0].position_min = -40.0 - margin;
    PathBuilder builder(config);
    builder.restart(start);
    EXPECT_EQ(builder.add(helix).has_value(), margin < 0.0);
  }
}

TEST(SoftLimits, NotANumberIsUnreachable) {
  PathBuilder builder(blending_mill(3));
  builder.restart({});
  EXPECT_TRUE(builder.add(line_to({std::nan(""), 0.0})));
}

}  // namespace
}  // namespace stanok::motion
