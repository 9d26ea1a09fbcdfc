// Smooth runs: tolerance, continuity, straightness, accuracy on circles, tags.
#include "motion/segments/smooth_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

using std::numbers::pi;

struct BuiltRun {
  MotionConfig config;
  std::vector<PathBlock> blocks;
  std::vector<Segment> segments;  // from the builder
  std::vector<bool> ends_chain;
  Tolerance tolerance;
};

void build(BuiltRun& run) {
  PathBuilder builder(run.config);
  builder.restart({});
  for (std::size_t k = 0; k < run.blocks.size(); ++k) {
    run.blocks[k].tag.block = k + 1;
    run.blocks[k].tolerance_mm = run.tolerance.mm;
    run.blocks[k].tolerance_deg = run.tolerance.deg;
    ASSERT_FALSE(builder.add(run.blocks[k]));
  }
  builder.finish();
  for (const auto& built : builder.built()) {
    run.segments.push_back(built.segment);
    run.ends_chain.push_back(built.ends_chain);
  }
}

// Blocks of all lengths that turn by up to `turn` rad at a time, in three or five axes.
BuiltRun random_run(std::uint64_t seed, double turn, double longest) {
  Random random(seed);
  BuiltRun run;
  const int axes = random.chance(0.5) ? 3 : 5;
  run.config = mill(axes);
  run.tolerance = {std::pow(10.0, random.between(-2.7, -1.0)),
                   std::pow(10.0, random.between(-2.0, -0.5))};
  Point at{};
  double heading = random.between(0.0, 2.0 * pi);
  double climb = 0.0;
  for (int n = 0; n < 150; ++n) {
    const double length = 0.02 * std::pow(longest / 0.02, random.between(0.0, 1.0));
    heading += random.between(-turn, turn);
    climb = std::clamp(climb + random.between(-turn, turn) * 0.3, -0.5, 0.5);
    at[0] += length * std::cos(heading) * std::cos(climb);
    at[1] += length * std::sin(heading) * std::cos(climb);
    at[2] += length * std::sin(climb);
    if (axes == 5) {
      at[3] += length * random.between(-2.0, 2.0);
      at[4] += length * random.between(-2.0, 2.0);
    }
    run.blocks.push_back(line_to(at, random.between(5.0, 50.0)));
  }
  build(run);
  return run;
}

// The nearest point of the programmed path: distance in X, Y, Z and the other axes there.
struct Foot {
  double distance = 1e300;
  Point point{};
};

Foot foot_on(const BuiltRun& run, const Point& p, std::size_t first, std::size_t last) {
  Foot best;
  for (std::size_t n = first; n < last; ++n) {
    const Point start = n == 0 ? Point{} : run.blocks[n - 1].end;
    const Point& end = run.blocks[n].end;
    double along = 0.0;
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      along += (p[k] - start[k]) * (end[k] - start[k]);
      squared += (end[k] - start[k]) * (end[k] - start[k]);
    }
    const double u = std::clamp(along / squared, 0.0, 1.0);
    Point foot;
    for (std::size_t k = 0; k < axes_max; ++k) foot[k] = start[k] + u * (end[k] - start[k]);
    const double distance = std::hypot(p[0] - foot[0], p[1] - foot[1], p[2] - foot[2]);
    if (distance < best.distance) best = {distance, foot};
  }
  return best;
}

Point position_at(const Segment& segment, double u) {
  JetPoint jet;
  evaluate_at_parameter(segment, u, jet);
  Point p;
  for (std::size_t k = 0; k < axes_max; ++k) p[k] = jet[k].value;
  return p;
}

TEST(SmoothRun, StaysWithinToleranceOfTheProgrammedWay) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const BuiltRun run = random_run(seed, seed % 2 == 0 ? 0.34 : 0.1, seed % 3 == 0 ? 30.0 : 1.0);
    double worst = 0.0;
    for (const Segment& segment : run.segments) {
      const auto block = static_cast<std::size_t>(segment.tag.block);
      const std::size_t first = block > 12 ? block - 12 : 0;
      const std::size_t last = std::min(run.blocks.size(), block + 12);
      for (int i = 0; i <= 8; ++i) {
        const Foot foot = foot_on(run, position_at(segment, i / 8.0), first, last);
        worst = std::max(worst, foot.distance);
      }
    }
    EXPECT_LE(worst, run.tolerance.mm) << "seed " << seed;
  }
}

TEST(SmoothRun, PassesEveryProgrammedPointWithinTolerance) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const BuiltRun run = random_run(seed, 0.3, 3.0);
    std::vector<double> nearest(run.blocks.size(), 1e300);
    std::vector<double> rotary(run.blocks.size(), 1e300);
    for (const Segment& segment : run.segments) {
      for (int i = 0; i <= 64; ++i) {
        const Point p = position_at(segment, i / 64.0);
        for (std::size_t n = segment.tag.block > 3 ? segment.tag.block - 3 : 0;
             n < std::min<std::size_t>(run.blocks.size(), segment.tag.block + 2); ++n) {
          const Point& corner = run.blocks[n].end;
          const double distance = std::hypot(p[0] - corner[0], p[1] - corner[1], p[2] - corner[2]);
          if (distance >= nearest[n]) continue;
          nearest[n] = distance;
          rotary[n] = std::max(std::abs(p[3] - corner[3]), std::abs(p[4] - corner[4]));
        }
      }
    }
    // Between samples lies at most 1/128 of the longest segment: 3 mm of path, 2 deg/mm.
    for (std::size_t n = 0; n < nearest.size(); ++n) {
      EXPECT_LE(nearest[n], run.tolerance.mm + 3.0 / 128.0 * 0.2) << "seed " << seed;
      EXPECT_LE(rotary[n], run.tolerance.deg + 3.0 / 128.0 * 2.9 + 2.9 * run.tolerance.mm)
          << "seed " << seed;
    }
  }
}

TEST(SmoothRun, ContinuesInPositionDirectionAndCurvature) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const BuiltRun run = random_run(seed, 0.34, 2.0);
    for (std::size_t n = 1; n < run.segments.size(); ++n) {
      if (run.ends_chain[n - 1]) continue;
      JetPoint before;
      JetPoint after;
      evaluate_at_parameter(run.segments[n - 1], 1.0, before);
      evaluate_at_parameter(run.segments[n], 0.0, after);
      for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_EQ(before[k].value, after[k].value);
        EXPECT_NEAR(before[k].first, after[k].first, 1e-8 * (1.0 + std::abs(after[k].first)));
        const double length = std::min(run.segments[n - 1].length, run.segments[n].length);
        const double curvature = std::max(std::abs(before[k].second), std::abs(after[k].second));
        EXPECT_NEAR(before[k].second, after[k].second, 1e-8 * (1.0 + curvature) + 1e-8 / length);
      }
    }
  }
}

// Two runs of blocks of nearly the same length meet at a corner: its blend takes all that the first
// one left of its last block, a little less or more than half of the next.
TEST(SmoothRun, BeginsWhereTheBlendBeforeItEnds) {
  for (int n = -20; n <= 20; ++n) {
    SCOPED_TRACE(n);
    BuiltRun run;
    run.config = mill(3);
    run.tolerance = {0.05, 0.05};
    Point at{};
    for (int k = 0; k < 8; ++k) {
      const double length = k < 4 ? 0.13 : 0.13 + 1e-5 * n;
      const double heading = 0.02 * k + (k < 4 ? 0.0 : 0.5);
      at[0] += length * std::cos(heading);
      at[1] += length * std::sin(heading);
      run.blocks.push_back(line_to(at, 10.0));
    }
    build(run);
    ASSERT_EQ(std::ranges::count(run.ends_chain, true), 1);
    Point end{};
    for (const Segment& segment : run.segments) {
      EXPECT_EQ(segment.geometry.start, end);
      const Point begin = position_at(segment, 1e-12);
      EXPECT_LT(xyz_norm(begin[0] - end[0], begin[1] - end[1], begin[2] - end[2]), 1e-11);
      end = segment.geometry.end;
    }
  }
}

TEST(SmoothRun, TakesEveryBlockInOrderWithItsFeed) {
  BuiltRun run;
  run.config = mill(3);
  run.tolerance = {0.01, 0.05};
  Random random(5);
  Point at{};
  for (int n = 0; n < 300; ++n) {
    at[0] += random.between(0.05, 0.3);
    at[1] = std::sin(at[0]);
    run.blocks.push_back(line_to(at, random.between(5.0, 50.0)));
  }
  build(run);
  std::uint64_t block = 1;
  for (const Segment& segment : run.segments) {
    EXPECT_TRUE(segment.tag.block == block || segment.tag.block == block + 1) << block;
    block = segment.tag.block;
    EXPECT_EQ(segment.feed_per_s, run.blocks[block - 1].feed_per_s);
  }
  EXPECT_EQ(block, run.blocks.size());
  EXPECT_EQ(run.segments.back().geometry.end, run.blocks.back().end);
}

TEST(SmoothRun, IsStraightWhereTheWayIs) {
  BuiltRun run;
  run.config = mill(3);
  run.tolerance = {0.01, 0.05};
  run.blocks = {line_to({40.0}), line_to({80.0, 4.0}), line_to({120.0, 4.0})};
  build(run);
  double straight = 0.0;
  double bent = 0.0;
  for (const Segment& segment : run.segments) {
    (segment.geometry.kind == SegmentKind::line ? straight : bent) += segment.length;
  }
  // A corner of 5.7 deg within 0.01 mm needs a few tenths of a millimetre.
  EXPECT_GT(straight, 110.0);
  EXPECT_GT(bent, 0.1);
  EXPECT_LE(run.segments.size(), 60U);
}

// Chords of a circle: the path itself lies inside by h^2 / 8R; the curve must not add to that what
// the tolerance would permit.
TEST(SmoothRun, FollowsACircleFarCloserThanTheToleranceAsks) {
  constexpr double R = 10.0;
  constexpr double h = 0.1;
  BuiltRun run;
  run.config = mill(3);
  run.tolerance = {0.01, 0.05};
  const int count = static_cast<int>(2.0 * pi * R / h);
  for (int n = 1; n <= count; ++n) {
    const double angle = n * h / R;
    run.blocks.push_back(line_to({R * std::sin(angle), R - R * std::cos(angle)}));
  }
  build(run);
  for (const Segment& segment : run.segments) {
    if (segment.tag.block < 20 || segment.tag.block > run.blocks.size() - 20) continue;
    for (const double u : {0.0, 0.5, 1.0}) {
      const Point p = position_at(segment, u);
      EXPECT_NEAR(std::hypot(p[0], p[1] - R), R, 0.1 * run.tolerance.mm);
      JetPoint jet;
      evaluate_at_parameter(segment, u, jet);
      EXPECT_NEAR(std::hypot(jet[0].second, jet[1].second), 1.0 / R, 0.05 / R);
    }
  }
}

TEST(SmoothRun, LeavesExactPathsAndSharpCornersAlone) {
  BuiltRun run;
  run.config = mill(3);
  run.tolerance = {0.0, 0.0};
  run.blocks = {line_to({1.0}), line_to({2.0, 0.1}), line_to({3.0, 0.1})};
  build(run);
  for (const Segment& segment : run.segments) EXPECT_EQ(segment.geometry.kind, SegmentKind::line);
}

}  // namespace
}  // namespace stanok::motion
