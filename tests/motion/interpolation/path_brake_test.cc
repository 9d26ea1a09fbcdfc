// Brakes from states that the brake_limits of segments do not know, against closed forms of the
// axes.
#include "motion/interpolation/path_brake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/interpolation/path_cursor.h"
#include "tests/motion/path_samples.h"

namespace stanok::motion::testing {
namespace {

constexpr Limits brake_limits{.v = 1000.0, .a = 2000.0, .j = 200000.0};

// A queue with one chunk, entered.
struct BrakeBench {
  explicit BrakeBench(const ChainMaker& chain) {
    for (const auto& built : chain.built()) EXPECT_TRUE(queue.segments.push(built.segment));
    const Chunk chunk{.segments = static_cast<std::uint32_t>(chain.built().size()),
                      .last = true,
                      .length = chain.length()};
    EXPECT_TRUE(queue.chunks.push(chunk));
    queue.show(1);
    cursor.enter(queue);
  }
  PathQueue queue;
  PathCursor cursor;
};

// At the speed at which an axis has all of its acceleration at its turning point: the brake_limits
// along the segment leave nothing for a brake, those of the axes do.
TEST(PathBrake, BrakesOnACircleAtTheSpeedThatItsAxesAllow) {
  constexpr double radius = 20.0;
  ChainMaker chain(brake_limits);
  chain.arc(radius, 6.0, brake_limits.v);
  const BrakeBench bench(chain);
  PathBrake brake(three_axes(brake_limits));
  const PathMotion from{.s = 0.5, .v = 0.98 * std::sqrt(brake_limits.a * radius)};
  std::optional<PhaseRun> run;
  for (int k = 0; k < 4 && !run; ++k)
    run = brake.find(bench.queue, bench.cursor, unlimited, from, UsedLimits::of_axes);
  ASSERT_TRUE(run);
  EXPECT_EQ((*run)[run->size() - 1].v_end, 0.0);
  double used = 0.0;
  for (const Phase& phase : *run) {
    for (int k = 0; k <= 200; ++k) {
      const PathMotion m = motion_at(phase, 0.005 * k * phase.duration);
      const double w = m.s / radius;
      const double a_n = m.v * m.v / radius;
      const double j_t = m.j - m.v * m.v * m.v / (radius * radius);
      const double j_n = 3.0 * m.v * m.a / radius;
      const double c = std::cos(w);
      const double s = std::sin(w);
      for (const double a : {m.a * s + a_n * c, m.a * c - a_n * s})
        used = std::max(used, std::abs(a) / brake_limits.a);
      for (const double j : {j_t * s + j_n * c, j_t * c - j_n * s})
        used = std::max(used, std::abs(j) / brake_limits.j);
    }
  }
  EXPECT_LE(used, 1.0);
}

TEST(PathBrake, StaysOnThePathThatIsOpen) {
  ChainMaker chain(brake_limits);
  chain.line(200.0, brake_limits.v);
  const BrakeBench bench(chain);
  PathBrake brake(three_axes(brake_limits));
  const PathMotion from{.s = 0.0, .v = 400.0};
  const double distance = ramp_distance(0.0, 400.0, {.a = brake_limits.a, .j = brake_limits.j});
  const auto run =
      brake.find(bench.queue, bench.cursor, 1.05 * distance, from, UsedLimits::of_axes);
  ASSERT_TRUE(run);
  EXPECT_NEAR((*run)[run->size() - 1].s_end, distance, 0.04 * distance);
  brake.restart();
  EXPECT_FALSE(brake.find(bench.queue, bench.cursor, 0.999 * distance, from, UsedLimits::of_axes));
}

// A sharp corner of 0.4 um that is passed within a fraction of a cycle is not passed over.
TEST(PathBrake, SeesSegmentsThatACycleDoesNotMeet) {
  ChainMaker chain(brake_limits);
  chain.line(1.0, brake_limits.v).arc(2.5e-4, 1.5, brake_limits.v).line(50.0, brake_limits.v);
  const BrakeBench bench(chain);
  PathBrake brake(three_axes(brake_limits));
  for (int k = 0; k < 8; ++k) {
    EXPECT_FALSE(brake.find(bench.queue, bench.cursor, unlimited, {.s = 0.0, .v = 100.0},
                            UsedLimits::of_axes));
  }
}

}  // namespace
}  // namespace stanok::motion::testing
