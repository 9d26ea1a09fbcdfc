// What a start from a line would change: what is so already is no change.
#include "daemon/report/search_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stanok::daemon {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

channels::SearchReport with_spindle(int id, lang::SpindleAction action, double rev_per_min) {
  channels::SearchReport report;
  report.state.spindles[id].action = action;
  report.state.speeds[id] = rev_per_min;
  return report;
}

TEST(ChangesOfStart, ASpindleThatTurnsSoAlreadyIsNone) {
  channels::ChannelOutput output;
  const auto clockwise = with_spindle(0, lang::SpindleAction::clockwise, 1000.0);
  EXPECT_THAT(changes_of_start(clockwise, output), ElementsAre("the spindle turning"));
  output.process.spindle_rev_per_min = 1000.0;
  EXPECT_THAT(changes_of_start(clockwise, output), IsEmpty());
  output.process.spindle_rev_per_min = 900.0;
  EXPECT_THAT(changes_of_start(clockwise, output), ElementsAre("the spindle turning"));
  output.process.spindle_rev_per_min = -1000.0;
  EXPECT_THAT(changes_of_start(clockwise, output), ElementsAre("the spindle turning"));
  const auto other_way = with_spindle(0, lang::SpindleAction::counter_clockwise, 1000.0);
  EXPECT_THAT(changes_of_start(other_way, output), IsEmpty());
}

// A spindle with a number is known by its setpoint, not by the master spindle.
TEST(ChangesOfStart, EachSpindleIsLookedAtByItsNumber) {
  channels::ChannelOutput output;
  output.process.spindle_rev_per_min = 500.0;
  output.process.spindles[0] = {.id = 2, .rev_per_min = 480.0, .target_rev_per_min = 500.0};
  EXPECT_THAT(changes_of_start(with_spindle(2, lang::SpindleAction::clockwise, 500.0), output),
              IsEmpty());
  EXPECT_THAT(changes_of_start(with_spindle(3, lang::SpindleAction::clockwise, 500.0), output),
              ElementsAre("spindle 3 turning"));
  EXPECT_THAT(changes_of_start(with_spindle(3, lang::SpindleAction::stop, 0.0), output), IsEmpty());
}

}  // namespace
}  // namespace stanok::daemon
