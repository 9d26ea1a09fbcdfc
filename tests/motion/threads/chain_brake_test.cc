// Ways to rest within a chain that a spindle leads, by themselves.
#include "motion/threads/chain_brake.h"

#include <gtest/gtest.h>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using stanok::testing::cycle_s;

constexpr RampLimits brake_limits{.a = 100.0, .j = 2000.0};
constexpr double chain_length = 20.0;  // turns

ChainBrake in_chain() {
  SpindleCoupling coupling;
  coupling.entry = coupling.chain =
      coupling.exit = {.acceleration_max = brake_limits.a, .jerk_max = brake_limits.j};
  ChainBrake brake(cycle_s);
  brake.begin(coupling, chain_length);
  return brake;
}

// Until it is at rest.
ChainBrake::Answer run_out(ChainBrake& brake, PathMotion& motion) {
  ChainBrake::Answer answer = ChainBrake::Answer::moves;
  for (int n = 0; n < 10000 && answer == ChainBrake::Answer::moves; ++n) {
    answer = brake.advance(motion);
    EXPECT_GE(motion.s, 0.0);
    EXPECT_LE(motion.s, chain_length);
  }
  EXPECT_TRUE(is_at_rest(motion));
  return answer;
}

// From v = 10 a ramp takes T = a / j + v / a = 0.15 s and v T / 2 = 0.75 turns.
TEST(ChainBrake, BrakesAtOnceWhereThereIsRoom) {
  ChainBrake brake = in_chain();
  PathMotion motion{.s = 5.0, .v = 10.0};
  brake.brake(motion, brake_limits);
  EXPECT_EQ(run_out(brake, motion), ChainBrake::Answer::at_rest);
  EXPECT_NEAR(motion.s, 5.75, 1e-9);
}

TEST(ChainBrake, ComesToRestAtTheVeryEnd) {
  ChainBrake brake = in_chain();
  PathMotion motion{.s = 5.0, .v = 10.0, .a = 20.0};
  brake.brake_at(chain_length, motion, brake_limits);
  EXPECT_EQ(run_out(brake, motion), ChainBrake::Answer::at_end_of_chain);
  EXPECT_EQ(motion.s, chain_length);
}

TEST(ChainBrake, ComesToRestAtTheStartOfAChainThatIsRunBack) {
  ChainBrake brake = in_chain();
  PathMotion motion{.s = 5.0, .v = -10.0};
  brake.brake_at(0.0, motion, brake_limits);
  EXPECT_EQ(run_out(brake, motion), ChainBrake::Answer::at_end_of_chain);
  EXPECT_EQ(motion.s, 0.0);
}

TEST(ChainBrake, KnowsUpToWhereTheEndCanBeReachedAtRest) {
  const ChainBrake brake = in_chain();
  EXPECT_TRUE(brake.comes_to_rest_before(chain_length, {.s = chain_length - 0.76, .v = 10.0},
                                         brake_limits));
  EXPECT_FALSE(brake.comes_to_rest_before(chain_length, {.s = chain_length - 0.74, .v = 10.0},
                                          brake_limits));
  EXPECT_TRUE(brake.comes_to_rest_before(chain_length, {.s = chain_length}, brake_limits));
}

// At rest already: nothing moves.
TEST(ChainBrake, APathAtRestStaysWhereItIs) {
  ChainBrake brake = in_chain();
  PathMotion motion{.s = 3.0};
  brake.brake(motion, brake_limits);
  EXPECT_EQ(run_out(brake, motion), ChainBrake::Answer::at_rest);
  EXPECT_EQ(motion.s, 3.0);
}

}  // namespace
}  // namespace stanok::motion
