// Threads: the path follows the measured angle of a spindle (docs/developer/motion.md#threads).
//
// What it must come to follows from the formula of the spindle itself: s = lead * (turns - turns at
// the start), the start being at the start angle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/motion/threads/thread_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

// Largest distance, in mm along Z, of the setpoints between two places from the helix that the
// formula of the spindle gives. `lead` is along Z and has its sign.
double helix_error(const std::vector<ThreadSample>& samples, const Turning& turning, double z_start,
                   double lead, double angle_deg, double z_from, double z_to) {
  double error = 0.0;
  int seen = 0;
  for (const ThreadSample& sample : samples) {
    const double way = (sample.z - z_start) / lead;  // turns
    if (way < (z_from - z_start) / lead || way > (z_to - z_start) / lead) continue;
    const double turns = turning(sample.t) - angle_deg / 360.0;
    error = std::max(error, stanok::testing::off_helix(turns, sample.z - z_start, lead));
    ++seen;
  }
  EXPECT_GT(seen, 50);
  return error;
}

TEST(SynchronousRun, CutsTheHelixOfTheStartAngleAtSteadySpeed) {
  const Turning turning = steady(10.0);
  ThreadBench bench(turning, 10.0);
  bench.idle(0.3);
  bench.send({.point = at(0.0, 0.0), .angle_deg = 90.0, .speed = 10.0},
             {block_to(at(0.0, -20.0), 2.0)});
  const auto samples = bench.cut();
  EXPECT_EQ(samples.back().z, -20.0);  // to the bit
  EXPECT_LE(helix_error(samples, turning, 0.0, -2.0, 90.0, -1.0, -19.0), 0.2 * increment_mm);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

struct RippleCase {
  const char* name;
  double speed;  // turns/s
  double lead;   // mm
};

class Ripple : public ::testing::TestWithParam<RippleCase> {};

// Ten starts at random instants, to and fro, at start angles of a thread of three starts.
TEST_P(Ripple, TenPassesCutOneHelixPerStart) {
  const auto [name, speed, lead] = GetParam();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> pause(0.1, 0.7);
  const Turning turning = with_ripple(speed, 0.3);
  ThreadBench bench(turning, speed);
  for (int pass = 0; pass < 10; ++pass) {
    SCOPED_TRACE(::testing::Message() << "pass " << pass);
    bench.idle(pause(random));
    const double z = pass % 2 == 0 ? 0.0 : -60.0;
    const double way = pass % 2 == 0 ? -1.0 : 1.0;
    const double start_deg = 120.0 * (pass % 3);
    bench.send({.point = at(0.0, z), .angle_deg = start_deg, .speed = speed},
               {block_to(at(0.0, -60.0 - z), lead)});
    const auto samples = bench.cut(60.0);
    // Run-in and run-out take half the way of a ramp to and from 1.2 times the speed.
    const double ramp = 5.0 + 1.2 * speed * lead * 0.06;
    EXPECT_LE(helix_error(samples, turning, z, way * lead, start_deg, z + way * ramp,
                          -60.0 - z - way * ramp),
              increment_mm);
    EXPECT_EQ(samples.back().z, -60.0 - z);
    EXPECT_EQ(samples.back().v_z, 0.0);
  }
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

INSTANTIATE_TEST_SUITE_P(SynchronousRun, Ripple,
                         ::testing::Values(RippleCase{"S300F5", 5.0, 5.0},
                                           RippleCase{"S600F2", 10.0, 2.0},
                                           RippleCase{"S1500F2", 25.0, 2.0},
                                           RippleCase{"S3000F1", 50.0, 1.0},
                                           RippleCase{"S3000F2", 50.0, 2.0}),
                         [](const auto& with) { return std::string(with.param.name); });

// A run-in to almost all that an axis can takes so long that the steps of the encoder, through the
// acceleration that is seen of them, add up to more than the speed may change meanwhile.
TEST(SynchronousRun, BeginsNearTheHighestSpeedOfTheAxes) {
  const Turning turning = steady(10.0);
  constexpr double lead = 24.6;  // 246 of 250 mm/s
  ThreadBench bench(turning, 10.0, at(0.0, 200.0));
  constexpr int lines = 1024;
  bench.see_through(lines);
  bench.idle(0.3);
  bench.send({.point = at(0.0, 200.0), .speed = 10.0}, {block_to(at(0.0, -280.0), lead)});
  const auto samples = bench.cut();
  EXPECT_LE(helix_error(samples, turning, 200.0, -lead, 0.0, 100.0, -180.0), lead / lines);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

// The start angle is one of the spindle, whichever way it turns.
TEST(SynchronousRun, FollowsASpindleThatTurnsCounterClockwise) {
  const Turning turning = [](double t) { return -10.0 * t; };
  ThreadBench bench(turning, -10.0);
  bench.idle(0.3);
  bench.send({.point = at(0.0, 0.0), .angle_deg = 30.0, .speed = 10.0},
             {block_to(at(0.0, -20.0), 2.0)});
  const auto samples = bench.cut();
  // Falling angles, falling Z.
  const Turning against = [&](double t) { return -turning(t); };
  EXPECT_LE(helix_error(samples, against, 0.0, -2.0, -30.0, -1.0, -19.0), 0.2 * increment_mm);
}

TEST(SynchronousRun, KeepsTheHelixWhileTheSpeedChanges) {
  // From 10 to 16 turns/s at 6 turns/s^2, from t = 1 s on; a parabola between two straight lines.
  const Turning turning = [](double t) {
    const double into = std::clamp(t - 1.0, 0.0, 1.0);
    return 10.0 * t + 3.0 * into * into + 6.0 * std::max(t - 2.0, 0.0);
  };
  ThreadBench bench(turning, 10.0);
  bench.idle(0.5);
  bench.send({.point = at(0.0, 0.0), .speed = 10.0}, {block_to(at(0.0, -60.0), 2.0)});
  const auto samples = bench.cut();
  EXPECT_LE(helix_error(samples, turning, 0.0, -2.0, 0.0, -1.0, -58.0), increment_mm);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

TEST(SynchronousRun, ATaperHasItsLeadAlongThePath) {
  const Turning turning = with_ripple(10.0, 1.0);
  ThreadBench bench(turning, 10.0, at(10.0, 0.0));
  bench.idle(0.3);
  bench.send({.point = at(10.0, 0.0), .speed = 10.0}, {block_to(at(13.0, -40.0), 2.0)});
  const auto samples = bench.cut();
  const double lead_z = -2.0 * 40.0 / std::hypot(3.0, 40.0);
  EXPECT_LE(helix_error(samples, turning, 0.0, lead_z, 0.0, -2.0, -38.0), increment_mm);
  for (const ThreadSample& sample : samples)
    EXPECT_NEAR(sample.x, 10.0 - sample.z * 3.0 / 40.0, 1e-9);  // on the line, run-in and all
}

// A straight thread with tapers at both ends and one lead along Z: Z knows nothing of the corners.
TEST(SynchronousRun, AChainDoesNotStopAtItsCorners) {
  const Turning turning = with_ripple(5.0, 2.0);
  ThreadBench bench(turning, 5.0, at(12.0, 0.0));
  bench.idle(0.3);
  const double slope = std::hypot(2.0, 4.0) / 4.0;
  bench.send({.point = at(12.0, 0.0), .speed = 5.0},
             {block_to(at(10.0, -4.0), 2.0 * slope), block_to(at(10.0, -26.0), 2.0),
              block_to(at(12.0, -30.0), 2.0 * slope)});
  const auto samples = bench.cut();
  EXPECT_LE(helix_error(samples, turning, 0.0, -2.0, 0.0, -1.0, -29.0), increment_mm);
  EXPECT_EQ(samples.back().x, 12.0);
  EXPECT_EQ(samples.back().z, -30.0);
  EXPECT_LE(bench.used(), 1.0 + rounding);
  double off = 0.0;
  for (const ThreadSample& sample : samples) {
    const double depth = std::min({2.0, -0.5 * sample.z, 0.5 * (30.0 + sample.z)});
    off = std::max(off, std::abs(sample.x - (12.0 - depth)));
  }
  // At 10 mm/s the axes can turn the corner well within a tenth of a millimetre, and not at once.
  EXPECT_LT(off, 0.1);
  EXPECT_GT(off, 1e-4);
}

TEST(SynchronousRun, ACornerKeepsAToleranceThatIsProgrammed) {
  const Turning turning = steady(1.0);
  ThreadBench bench(turning, 1.0, at(10.0, 0.0));
  bench.idle(0.3);
  ThreadBlock straight = block_to(at(10.0, -10.0), 2.0);
  straight.keeps_tolerance = true;
  ThreadBlock out = block_to(at(12.0, -12.0), 2.0 * std::sqrt(2.0));
  out.keeps_tolerance = true;
  bench.send({.point = at(10.0, 0.0), .speed = 1.0}, {straight, out});
  double off = 0.0;
  for (const ThreadSample& sample : bench.cut())
    off = std::max(off, sample.x - std::max(10.0, 10.0 - (sample.z + 10.0)));
  EXPECT_LE(off, 0.01 + 1e-9);
  EXPECT_GT(off, 0.009);  // it uses what it may
}

// At a corner that leaves the path hardly any acceleration, less than the steps of the encoder seem
// to ask for in some cycles: the thread waits for a calm one while there is time.
TEST(SynchronousRun, ACornerThatNeedsAlmostAllIsJoinedInACalmCycle) {
  for (int start = 0; start < 20; ++start) {
    const Turning turning = steady(10.0);
    ThreadBench bench(turning, 10.0, at(10.0, 0.0));
    bench.see_through(1024);
    bench.idle(0.3 + 0.0137 * start);
    ThreadBlock out = block_to(at(10.0, 2.557), 0.265);
    ThreadBlock back = block_to(at(10.0, -4.478), 1.681);
    for (ThreadBlock* block : {&out, &back}) {
      block->tolerance_mm = 0.1;
      block->keeps_tolerance = true;
    }
    bench.send({.point = at(10.0, 0.0), .speed = 10.0}, {out, back});
    EXPECT_EQ(bench.cut().back().z, -4.478) << start;
    EXPECT_FALSE(bench.output().has_lost_spindle) << start;
    EXPECT_LE(bench.used(), 1.0 + rounding) << start;
  }
}

// A thread to a corner, so many turns before it, and back with another lead.
void add_with_corner(ThreadBuilder& builder, double turns, double lead) {
  ASSERT_FALSE(builder.add(block_to(at(10.0, turns * lead), lead)));
  ASSERT_FALSE(builder.add(block_to(at(10.0, -10.0), 1.0)));
}

// Where the run-in just fits before a corner, the noise of the encoder makes it a short one in one
// cycle and a long one in the next; it begins at the begin of the one that is taken.
TEST(SynchronousRun, ARunInThatJustFitsBeforeACornerIsAWholeOne) {
  constexpr double speed = 10.0;
  constexpr double lead = 1.83;
  // With 45 % of the jerk of the axes, which does not come to their acceleration; it fits three
  // times.
  const double duration = 2.0 * std::sqrt(speed * lead / (0.45 * 50000.0));
  const double needed = 3.0 * 0.5 * speed * duration;
  for (int start = 0; start < 40; ++start) {
    ThreadBench bench(steady(speed), speed, at(10.0, 0.0));
    bench.see_through(1024);
    bench.idle(0.3 + 0.0137 * start);
    ThreadBuilder builder(bench.config());
    const auto begin = [&] {
      builder.begin(at(10.0, 0.0), bench.config().geometry, thread_from(0.0), speed);
    };
    begin();
    add_with_corner(builder, 2.0 * needed, lead);
    const double corner = 2.0 * needed - builder.finish().coupling.entry_end;
    begin();
    add_with_corner(builder, needed + corner, lead);
    bench.send(builder);
    EXPECT_EQ(bench.cut().back().z, -10.0) << start;
    EXPECT_FALSE(bench.output().has_lost_spindle) << start;
    EXPECT_LE(bench.used(), 1.0 + rounding) << start;
  }
}

// The limits of a corner to a lead that is 20 times as large come when the path has settled behind
// its run-in: held back by them in the middle of a correction it would overshoot.
TEST(SynchronousRun, ACornerToAMuchLargerLeadIsJoinedWhenThePathHasSettled) {
  constexpr double speed = 10.26;
  for (int start = 0; start < 20; ++start) {
    ThreadBench bench(steady(speed), speed, at(10.0, 14.0));
    bench.idle(0.3 + 0.0137 * start);
    bench.send({.point = at(10.0, 14.0), .speed = speed},
               {block_to(at(10.0, 2.4), 0.389), block_to(at(10.0, 59.5), 8.05)});
    EXPECT_EQ(bench.cut().back().z, 59.5) << start;
    EXPECT_FALSE(bench.output().has_lost_spindle) << start;
    EXPECT_LE(bench.used(), 1.0 + rounding) << start;
  }
}

// Through 256 pulses a turn in a second looks a quarter faster or slower from cycle to cycle.
TEST(SynchronousRun, ASlowSpindleWithACoarseEncoderIsNotTooFastForACorner) {
  constexpr double speed = 1.03;
  for (int start = 0; start < 10; ++start) {
    ThreadBench bench(steady(speed), speed, at(0.0, 0.0));
    bench.see_through(256);
    bench.idle(0.3 + 0.0137 * start);
    bench.send({.point = at(0.0, 0.0), .speed = speed},
               {block_to(at(0.0, 1.0), 0.2), block_to(at(0.1, 2.0), 0.2)});
    EXPECT_EQ(bench.cut().back().z, 2.0) << start;
    EXPECT_FALSE(bench.output().has_lost_spindle) << start;
  }
}

// A corner takes of the jerk of its axes no more than leaves enough for the steps of the encoder.
// It may grow for that, and the corners before a larger lead grow with it.
TEST(SynchronousRun, ACornerLeavesTheJerkThatACoarseEncoderNeeds) {
  constexpr double speed = 181.16 / 60.0;
  constexpr int lines = 256;
  for (int start = 0; start < 20; ++start) {
    ThreadBench bench(steady(speed), speed, at(2.409, 24.239));
    bench.see_through(lines);
    bench.idle(0.3 + 0.0137 * start);
    // The last one, with a larger lead, leaves those before it less of the jerk: they grow.
    bench.send({.point = at(2.409, 24.239),
                .speed = speed,
                .jerk_to_follow = jerk_to_follow(lines, cycle_s)},
               {block_to(at(2.409, 18.886), 2.949), block_to(at(2.374, -39.704), 1.253),
                block_to(at(2.391, -35.352), 2.409)});
    EXPECT_EQ(bench.cut().back().z, -35.352) << start;
    EXPECT_FALSE(bench.output().has_lost_spindle) << start;
    EXPECT_LE(bench.used(), 1.0 + rounding) << start;
  }
}

TEST(SynchronousRun, AChangeOfLeadIsSmooth) {
  const Turning turning = steady(10.0);
  ThreadBench bench(turning, 10.0);
  bench.idle(0.3);
  bench.send({.point = at(0.0, 0.0), .speed = 10.0},
             {block_to(at(0.0, -10.0), 1.0), block_to(at(0.0, -40.0), 2.0)});
  const auto samples = bench.cut();
  EXPECT_LE(helix_error(samples, turning, 0.0, -1.0, 0.0, -1.0, -9.0), increment_mm);
  // Ten turns have passed where the second lead begins.
  EXPECT_LE(helix_error(samples, turning, -10.0, -2.0, 0.0, -12.0, -38.0), increment_mm);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

// An override of the spindle while its start angle is waited for: what it turns before it has come
// to the new speed does not count.
TEST(SynchronousRun, ASpindleThatChangesItsSpeedPassesItsStartAngleAnew) {
  for (int start = 0; start < 10; ++start) {
    constexpr double from = 0.51;                    // a tenth of a turn behind the start angle
    const double acceleration = 20.0 + 2.0 * start;  // turns/s^2, a quarter in two run-ins
    const Turning turning = [=](double t) {
      const double into = std::clamp(t - from, 0.0, 10.0 / acceleration);
      return 10.0 * t + into * acceleration * (std::max(t - from, 0.0) - 0.5 * into);
    };
    ThreadBench bench(turning, 10.0);
    bench.idle(0.5);
    bench.send({.point = at(0.0, 0.0), .speed = 10.0}, {block_to(at(0.0, -60.0), 2.0)});
    bench.idle(from - bench.time());
    bench.want_speed(20.0);
    const auto samples = bench.cut();
    EXPECT_FALSE(bench.output().has_lost_spindle) << start;
    EXPECT_LE(helix_error(samples, turning, 0.0, -2.0, 0.0, -30.0, -50.0), increment_mm) << start;
  }
}

// A chain with a corner is made for 1.25 times the programmed speed. A spindle that an override
// lets turn faster is waited for when it comes down.
TEST(SynchronousRun, ASpindleThatComesDownToItsSpeedIsWaitedFor) {
  constexpr double slows = 6.0;  // turns/s^2, from 1.6 to 1.0 times the speed
  const Turning turning = [](double t) {
    const double into = std::clamp(t, 0.0, 1.0);
    return 10.0 * t + 6.0 * into - 0.5 * slows * into * into;
  };
  ThreadBench bench(turning, 10.0, at(10.0, 0.0));
  bench.idle(0.4);
  bench.send({.point = at(10.0, 0.0), .speed = 10.0},
             {block_to(at(10.0, -20.0), 2.0), block_to(at(11.0, -25.0), 2.0)});
  const auto samples = bench.cut();
  EXPECT_FALSE(bench.output().has_lost_spindle);
  EXPECT_LE(helix_error(samples, turning, 0.0, -2.0, 0.0, -4.0, -18.0), increment_mm);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

TEST(SynchronousRun, AHoldWaitsForTheEndOfTheThread) {
  const Turning turning = steady(10.0);
  ThreadBench bench(turning, 10.0);
  bench.idle(0.3);
  bench.send({.point = at(0.0, 0.0), .speed = 10.0}, {block_to(at(0.0, -20.0), 2.0)});
  while (bench.output().axes[Z].value > -5.0) bench.cycle();
  bench.control().hold = true;
  bench.control().feed_override = 0.5;
  const auto samples = bench.cut();
  EXPECT_LE(helix_error(samples, turning, 0.0, -2.0, 0.0, -5.0, -19.0), increment_mm);
  EXPECT_EQ(samples.back().z, -20.0);
}

TEST(SynchronousRun, AHoldBeforeTheRunInKeepsThePathAtRest) {
  ThreadBench bench(steady(10.0), 10.0);
  bench.send({.point = at(0.0, 0.0), .speed = 10.0}, {block_to(at(0.0, -20.0), 2.0)});
  bench.cycle();
  bench.control().hold = true;
  bench.idle(1.0);
  EXPECT_EQ(bench.output().axes[Z].value, 0.0);
  bench.control().hold = false;
  EXPECT_EQ(bench.cut().back().z, -20.0);
}

TEST(SynchronousRun, LeavingAThreadBrakesOnItsWay) {
  ThreadBench bench(steady(10.0), 10.0);
  bench.idle(0.3);
  bench.send({.point = at(0.0, 0.0), .speed = 10.0}, {block_to(at(0.0, -20.0), 2.0)});
  while (bench.output().axes[Z].value > -5.0) bench.cycle();
  bench.control().hold = true;
  bench.control().leaves_thread = true;
  bench.idle(0.2);
  EXPECT_EQ(bench.output().axes[Z].first, 0.0);
  // From 20 mm/s under 50000 mm/s^3 a ramp takes 40 ms and 0.4 mm.
  EXPECT_NEAR(bench.output().axes[Z].value, -5.4, 0.03);
  EXPECT_FALSE(bench.output().has_lost_spindle);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

TEST(SynchronousRun, ASpindleThatTheAxesCannotFollowIsLostWithinTheLimits) {
  // From 10 to 30 turns/s at 1000 turns/s^2: 2000 mm/s^2 of axis at a lead of 2 mm, at once.
  const Turning turning = [](double t) {
    const double into = std::clamp(t - 1.0, 0.0, 0.02);
    return 10.0 * t + 500.0 * into * into + 20.0 * std::max(t - 1.02, 0.0);
  };
  ThreadBench bench(turning, 10.0);
  bench.idle(0.5);
  bench.send({.point = at(0.0, 0.0), .speed = 10.0}, {block_to(at(0.0, -60.0), 2.0)});
  bench.idle(1.0);
  EXPECT_TRUE(bench.output().has_lost_spindle);
  EXPECT_EQ(bench.output().axes[Z].first, 0.0);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

TEST(SynchronousRun, AShortThreadEndsAtItsEnd) {
  ThreadBench bench(steady(10.0), 10.0);
  bench.idle(0.3);
  for (const double way : {0.001, 0.05, 0.3, 0.5, 0.9}) {
    const double z = bench.output().axes[Z].value;
    bench.send({.point = at(0.0, z), .speed = 10.0}, {block_to(at(0.0, z - way), 2.0)});
    EXPECT_EQ(bench.cut().back().z, z - way);
  }
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

// Chains of all kinds, led by spindles of all kinds: those that the axes can follow, and those that
// they lose. Whatever comes of it, the axes keep their limits, and an end that is reached is exact.
TEST(SynchronousRun, RandomChainsKeepTheLimits) {
  int over = 0;
  int lost = 0;
  for (unsigned seed = 1; seed <= stanok::testing::cases(150U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const double speed = 1.0 + 30.0 * part(random) * part(random);
    const double ripple = seed % 3 == 0 ? 0.8 * part(random) : 0.25 * part(random);
    const double w = 2.0 * std::numbers::pi * (0.5 + 6.0 * part(random));
    const Turning turning = [=](double t) {
      return speed * (t - ripple / w * (std::cos(w * t) - 1.0));
    };
    const double z_start = 50.0 * part(random);
    ThreadBench bench(turning, speed, at(20.0, z_start));
    bench.idle(0.2);
    ThreadBuilder builder(bench.config());
    builder.begin(at(20.0, z_start), bench.config().geometry, thread_from(360.0 * part(random)),
                  speed);
    Point end = at(20.0, z_start);
    const int blocks = 1 + static_cast<int>(4.0 * part(random));
    for (int k = 0; k < blocks; ++k) {
      const Point next =
          at(end[X] + 3.0 * (part(random) - 0.5), end[Z] - 0.2 - 15.0 * part(random));
      if (!builder.add(block_to(next, 0.3 + 3.0 * part(random)))) end = next;
    }
    if (builder.is_empty()) continue;
    bench.send(builder);
    const double hold_at = 10.0 * part(random);
    while (bench.time() < 20.0 && bench.output().chunks_done == 0) {
      bench.cycle();
      bench.control().hold = bench.time() > hold_at && bench.time() < hold_at + 0.3;
      bench.control().leaves_thread = bench.control().hold && seed % 7 == 0;
      if (bench.output().has_lost_spindle && bench.output().axes[Z].first == 0.0) break;
    }
    lost += bench.output().has_lost_spindle ? 1 : 0;
    EXPECT_LE(bench.used(), 1.0 + 1e-9);
    if (bench.output().chunks_done == 0) continue;
    ++over;
    EXPECT_EQ(bench.output().axes[X].value, end[X]);
    EXPECT_EQ(bench.output().axes[Z].value, end[Z]);
  }
  EXPECT_GT(over, stanok::testing::cases(80));
  EXPECT_GT(lost, 3);
}

}  // namespace
}  // namespace stanok::motion::testing
