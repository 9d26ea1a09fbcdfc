// The steps of a change of kinematics, with drives that obey and that do not.
#include "channels/cycle/kinematics_change.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

using namespace stanok::testing;

class KinematicsChangeTest : public ::testing::Test {
 protected:
  KinematicsChangeTest() {
    bench_.parts.run.apply(Change::power_on);
    bench_.parts.axes.power(bench_.parts.axes.all());
  }
  static AxesStep step(AxesStep::Kind kind) { return {.kind = kind, .axes = 1U << bench_y}; }
  void take(const std::vector<AxisFeedback>& feedback) {
    static_cast<void>(bench_.parts.drives.advance(feedback, LimitSwitches::stop_the_axis));
  }
  Situation situation() const { return bench_.parts.run.state().situation(); }

  CycleBench bench_;
  KinematicsChange change_{bench_.parts.axes, bench_.parts.drives, bench_.parts.motion,
                           bench_.parts.run, bench_.link};
};

TEST_F(KinematicsChangeTest, TellsThePreparationWhereTheAxesStandAndWhichAreOn) {
  change_.begin(1);
  EXPECT_TRUE(change_.is_pending());
  EXPECT_EQ(situation(), Situation::switching);
  const auto notice = std::get<SchemeSwitch>(bench_.notice());
  EXPECT_EQ(notice.scheme, 1);
  EXPECT_EQ(notice.axes_M[bench_y], 20.0);
  EXPECT_EQ(notice.enabled, bench_.parts.axes.all());
}

// The brake closes before the drive goes off; both take their times, 2 and 3 ms.
TEST_F(KinematicsChangeTest, ParksAnAxisInTwoSteps) {
  change_.begin(1);
  const AxesStep parks = step(AxesStep::Kind::park);
  EXPECT_DOUBLE_EQ(change_.begin_step(parks), 0.005);
  EXPECT_TRUE(bench_.parts.axes.drive(bench_y).brake_closed);
  EXPECT_TRUE(bench_.parts.axes.drive(bench_y).enabled);
  EXPECT_EQ(change_.disobedient_axis(parks), -1);  // ideal drives obey
  change_.finish_step(parks);
  EXPECT_FALSE(bench_.parts.axes.drive(bench_y).enabled);
  change_.succeed();
  EXPECT_EQ(change_.outcome(), Outcome::succeeded);
  EXPECT_EQ(situation(), Situation::idle);
}

TEST_F(KinematicsChangeTest, ABrakeThatDoesNotCloseFailsTheChangeAndNamesTheAxis) {
  change_.begin(1);
  const AxesStep parks = step(AxesStep::Kind::park);
  static_cast<void>(change_.begin_step(parks));
  take(bench_feedback(10.0, 20.0, 0.0));  // brakes open
  ASSERT_EQ(change_.disobedient_axis(parks), bench_y);
  change_.fail(parks, bench_y);
  EXPECT_EQ(change_.outcome(), Outcome::failed);
  EXPECT_EQ(change_.code().view(), "E5205");
  EXPECT_NE(std::string(change_.text().view()).find("brake of axis Y"), std::string::npos);
  EXPECT_TRUE(bench_.parts.axes.drive(bench_y).brake_closed);
  EXPECT_EQ(situation(), Situation::ending);
}

TEST_F(KinematicsChangeTest, ADriveThatDoesNotSwitchOnFailsTheProgramThatAsked) {
  bench_.begin_run();
  change_.begin(0);
  const AxesStep joins = step(AxesStep::Kind::join);
  static_cast<void>(change_.begin_step(joins));
  auto feedback = bench_feedback(10.0, 20.0, 0.0);
  of_axis(feedback, bench_y).enabled = false;
  take(feedback);
  ASSERT_EQ(change_.disobedient_axis(joins), bench_y);
  change_.fail(joins, bench_y);
  EXPECT_EQ(bench_.event(), "E5205");
  EXPECT_EQ(situation(), Situation::ending);
}

TEST_F(KinematicsChangeTest, AStopInItsMiddleBrakesWhatItMoved) {
  change_.begin(1);
  static_cast<void>(change_.begin_step(step(AxesStep::Kind::join)));
  change_.end();
  EXPECT_EQ(change_.code().view(), "E6072");
  EXPECT_FALSE(bench_.parts.axes.drive(bench_y).enabled);
  EXPECT_TRUE(bench_.parts.axes.drive(bench_x).enabled);  // no part of it
}

}  // namespace
}  // namespace stanok::channels
