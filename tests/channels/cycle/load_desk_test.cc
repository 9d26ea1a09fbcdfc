// Loads that a preparation is asked for, and what came of them.
#include "channels/cycle/load_desk.h"

#include <gtest/gtest.h>

#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

LoadDone done(bool ok, std::int32_t load, std::string_view text) {
  return {.succeeded = ok, .number = load, .text = ShortText(text)};
}

class LoadDeskTest : public ::testing::Test {
 protected:
  stanok::testing::CycleBench bench_;
  LoadDesk loads_{bench_.parts.run, bench_.link};
};

TEST_F(LoadDeskTest, AProgramThatIsLoadedMakesTheChannelReady) {
  bench_.parts.run.apply(Change::power_on);
  loads_.begin(ShortText("part.nc"), Job::program);
  EXPECT_EQ(loads_.outcome(), Outcome::pending);
  const auto notice = std::get<ProgramLoad>(bench_.notice());
  EXPECT_EQ(notice.number, 1);
  EXPECT_EQ(notice.load_in_use, 0);  // there is none yet
  EXPECT_EQ(notice.program.view(), "part.nc");
  loads_.take(done(true, 1, "part.nc"));
  EXPECT_EQ(loads_.program(), 1);
  EXPECT_EQ(bench_.parts.run.state().situation(), Situation::ready);
}

TEST_F(LoadDeskTest, ALoadThatFailsLeavesTheProgramThatIsThere) {
  loads_.begin(ShortText("part.nc"), Job::program);
  loads_.take(done(true, 1, "part.nc"));
  loads_.begin(ShortText("other.nc"), Job::program);
  loads_.take(done(false, 2, "other.nc:1:1: no such word"));
  EXPECT_EQ(loads_.outcome(), Outcome::failed);
  EXPECT_EQ(loads_.text().view(), "other.nc:1:1: no such word");
  EXPECT_EQ(loads_.program(), 1);
}

TEST_F(LoadDeskTest, ALineIsNoProgram) {
  loads_.begin(ShortText("G0 X0"), Job::line);
  EXPECT_EQ(std::get<LineLoad>(bench_.notice()).line.view(), "G0 X0");
  loads_.take(done(true, 0, ""));
  EXPECT_EQ(loads_.outcome(), Outcome::succeeded);
  EXPECT_FALSE(bench_.parts.run.state().has_program());
}

TEST_F(LoadDeskTest, AResetGivesUpWhatIsBeingLoaded) {
  loads_.end();
  EXPECT_EQ(loads_.outcome(), Outcome::succeeded);  // nothing was
  loads_.begin(ShortText("part.nc"), Job::program);
  loads_.end();
  EXPECT_EQ(loads_.outcome(), Outcome::failed);
}

}  // namespace
}  // namespace stanok::channels
