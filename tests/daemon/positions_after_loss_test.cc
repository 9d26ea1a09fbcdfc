// What is kept and shown of an axis whose drive was away: where the drive says that it is, and
// whether that can be relied on.
#include <gtest/gtest.h>

#include "config/files/positions_file.h"
#include "daemon/start/kept_state.h"
#include "tests/daemon/daemon_bench.h"

namespace stanok::daemon {
namespace {

constexpr double near_mm = 0.01;    // the bus rounds
constexpr double ran_out_mm = 0.1;  // an axis without power runs out into its brake

class PositionsAfterLoss : public ::testing::Test {
 protected:
  PositionsAfterLoss() {
    bench.demand("machine.on");
    bench.program("go.nc", "G53 G0 X12 Y-5\nM30\n");
    bench.demand("program.run", {{"channel", 1}, {"program", "go.nc"}});
    wait("the program's end",
         [this] { return !bench.channel(1).running && bench.channel(1).axes[0].position == 12.0; });
  }
  template <class Condition>
  void wait(const char* what, const Condition& is_so) {
    constexpr int cycles_max = 60'000;
    for (int n = 0; n < cycles_max && !is_so(); ++n) bench.cycle();
    ASSERT_TRUE(is_so()) << what;
  }
  // As it would be written now.
  [[nodiscard]] double kept(const std::string& axis) {
    return config::read_positions_text(snapshot(bench.output()), "positions.toml").at(axis);
  }
  [[nodiscard]] bool is_verified(const char* axis) {
    const auto status = bench.answer("channel.status", {{"channel", 1}});
    return (*status)->at("axes").at(axis).at("verified").get<bool>();
  }
  [[nodiscard]] const channels::AxisFeedback& drive() const { return bench.channel(1).feedback[0]; }

  DaemonBench bench;
  PositionSnapshot snapshot{mill_of_the_bench().machine};
};

TEST_F(PositionsAfterLoss, AreThoseOfTheProgramBefore) {
  EXPECT_EQ(kept("X"), 12.0);
  EXPECT_EQ(kept("Y"), -5.0);
  EXPECT_TRUE(is_verified("X"));
}

TEST_F(PositionsAfterLoss, AreTheLatestOnesWhileTheDriveIsSilent) {
  bench.fail("X", plant::FaultKind::off);
  wait("no contact", [this] { return !drive().valid; });
  bench.cycles(2000);
  EXPECT_NEAR(kept("X"), 12.0, near_mm);
  EXPECT_EQ(kept("Y"), -5.0);
  EXPECT_FALSE(is_verified("X"));
  EXPECT_TRUE(is_verified("Y")) << "its drive answers";
}

TEST_F(PositionsAfterLoss, AreOfTheDriveThatComesBackElsewhere) {
  bench.fail("X", plant::FaultKind::elsewhere);
  wait("no contact", [this] { return !drive().valid; });
  EXPECT_NEAR(kept("X"), 12.0, near_mm);
  bench.fail("X", plant::FaultKind::none);
  wait("contact", [this] { return drive().valid; });
  bench.cycles(2000);
  EXPECT_GT(std::abs(drive().position - 12.0), 1.0) << "it was moved";
  EXPECT_NEAR(kept("X"), drive().position, near_mm);
  EXPECT_FALSE(is_verified("X")) << "what it counts is not the machine's any more";
  EXPECT_EQ(kept("Y"), -5.0);
}

TEST_F(PositionsAfterLoss, AreVerifiedAgainOfADriveThatComesBackWhereItWas) {
  bench.fail("X", plant::FaultKind::off);
  wait("no contact", [this] { return !drive().valid; });
  bench.fail("X", plant::FaultKind::none);
  wait("contact", [this] { return drive().valid; });
  bench.cycles(2000);
  EXPECT_NEAR(kept("X"), drive().position, near_mm);
  EXPECT_EQ(is_verified("X"), drive().referenced);
  EXPECT_NEAR(kept("X"), 12.0, ran_out_mm);
}

}  // namespace
}  // namespace stanok::daemon
