// Moves that end where a probe changes, without a path.
#include "channels/cycle/probe_watch.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

constexpr int input = 3;

class ProbeWatchTest : public ::testing::Test {
 protected:
  static ProbeBegin move(bool until_contact) {
    return {.input = input, .until_contact = until_contact};
  }

  CycleBench bench_;
  ProbeWatch probe_{bench_.parts.constants, bench_.inputs, bench_.parts.drives,
                    bench_.parts.motion};
};

TEST_F(ProbeWatchTest, EndsThePathWhereTheProbeTouches) {
  ASSERT_TRUE(probe_.begin(move(true)));
  probe_.advance(bench_.link);
  EXPECT_FALSE(probe_.ends_path());
  bench_.inputs.set(input, true);
  static_cast<void>(
      bench_.parts.drives.advance(bench_feedback(10.5, 20.0, 0.0), LimitSwitches::stop_the_axis));
  probe_.advance(bench_.link);
  EXPECT_TRUE(probe_.ends_path());
  const ChannelAnswer answer = probe_.take_answer();
  EXPECT_TRUE(answer.ok);
  EXPECT_TRUE(answer.left_path);
  EXPECT_EQ(answer.probe_M[bench_x], 10.5);  // as the drive says, not as it was commanded
  EXPECT_FALSE(probe_.ends_path());
}

TEST_F(ProbeWatchTest, AMoveThatTouchesNothingAnswersSo) {
  ASSERT_TRUE(probe_.begin(move(true)));
  probe_.advance(bench_.link);
  const ChannelAnswer answer = probe_.take_answer();
  EXPECT_FALSE(answer.ok);
  EXPECT_FALSE(answer.left_path);
}

TEST_F(ProbeWatchTest, AMoveMayEndWhereTheProbeLeaves) {
  bench_.inputs.set(input, true);
  ASSERT_TRUE(probe_.begin(move(false)));
  bench_.inputs.set(input, false);
  probe_.advance(bench_.link);
  EXPECT_TRUE(probe_.take_answer().ok);
}

TEST_F(ProbeWatchTest, AProbeThatTouchesAlreadyGivesTheMoveUp) {
  bench_.inputs.set(input, true);
  EXPECT_FALSE(probe_.begin(move(true)));
  EXPECT_TRUE(probe_.ends_path());
  EXPECT_FALSE(probe_.take_answer().ok);
}

}  // namespace
}  // namespace stanok::channels
