// Force control in the words of programs and of people.
#include "channels/cycle/force_terms.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

TEST(ForceTermsTest, LossOfTheForceSensorHoldsTheFeedUnlessTheFeedIsTheSmallest) {
  stanok::testing::CycleBench bench;
  ChannelLog& log = bench.parts.log;
  EXPECT_EQ(tell(motion::ForceEvent::sensor_lost, {}, log), SensorLoss::holds_feed);
  EXPECT_EQ(bench.event(), "A4010");
  EXPECT_EQ(tell(motion::ForceEvent::no_answer_slow, {}, log), SensorLoss::none);
  EXPECT_EQ(bench.event(), "A4011");
  EXPECT_EQ(tell(motion::ForceEvent::overload_at_feed_min, {}, log), SensorLoss::none);
  EXPECT_EQ(bench.event(), "W614");
}

TEST(ForceTermsTest, AnOrderHasWhatTheProgramSays) {
  lang::ForceControl program;
  program.kind = lang::ForceControl::Kind::oscillate;
  program.oscillation_n = 12.0;
  program.oscillation_hz = 3.0;
  const motion::ForceCommand order = command_of(program);
  EXPECT_EQ(order.kind, motion::ForceCommand::Kind::oscillate);
  EXPECT_EQ(order.oscillation_n, 12.0);
  EXPECT_EQ(order.oscillation_hz, 3.0);
}

}  // namespace
}  // namespace stanok::channels
