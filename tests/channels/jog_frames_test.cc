// Jogs in the directions of the tool and of the plane, through the whole machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

class JogFrames : public ::testing::Test {
 protected:
  void jog(JogFrame frame, std::string_view axis, double velocity, double increment) {
    OperatorEvent event;
    event.channel = 1;
    event.command = commands::Jog{ShortText(axis), velocity, increment, frame};
    bench.ask(event);
  }
  // The code of the refusal; empty: it was taken.
  std::string jogged(JogFrame frame, std::string_view axis, double velocity, double increment) {
    const std::size_t before = bench.replies().size();
    jog(frame, axis, velocity, increment);
    bench.run_to_end();
    EXPECT_GT(bench.replies().size(), before);
    return std::string(bench.replies().back().code.view());
  }
  void line(const std::string& text) {
    bench.ask(OperatorAction::mdi, 1, text);
    bench.run_to_end();
  }
  std::array<double, 5> axes() {
    std::array<double, 5> positions{};
    for (std::size_t k = 0; k < positions.size(); ++k)
      positions[k] = bench.channel(1).axes[k].position;
    return positions;
  }
  void expect_moved(const std::array<double, 5>& from, const std::array<double, 5>& by) {
    const auto now = axes();
    for (std::size_t k = 0; k < now.size(); ++k) EXPECT_NEAR(now[k] - from[k], by[k], 1e-9) << k;
  }

  MachineBench bench;
};

// Out of an inclined hole.
TEST_F(JogFrames, AlongTheToolHeadAndSlideGoTogether) {
  line("#kinematics (2, 1)");
  line("G0 B30 C45");
  const auto from = axes();
  EXPECT_EQ(jogged(JogFrame::tool, "Z", 10.0, 8.0), "");
  const double angle = std::numbers::pi / 6.0;
  expect_moved(from, {8.0 * std::sin(angle), 0.0, 8.0 * std::cos(angle), 0.0, 0.0});
  EXPECT_EQ(jogged(JogFrame::tool, "Z", -10.0, 8.0), "");
  expect_moved(from, {});
}

// As G91 G1 Y8 goes there.
TEST_F(JogFrames, InATiltedPlaneAsAProgramWouldGo) {
  line("#kinematics (2, 1)");
  line("G68.2 X0 Y0 Z0 I0 J25 K0");
  const auto from = axes();
  line("G91 G1 Y8 F600");
  const auto end = axes();
  std::array<double, 5> by{};
  for (std::size_t k = 0; k < by.size(); ++k) by[k] = end[k] - from[k];
  EXPECT_GT(std::abs(by[2]), 1.0);
  line("G91 G1 Y-8 F600");
  EXPECT_EQ(jogged(JogFrame::plane, "Y", 10.0, 8.0), "");
  expect_moved(from, by);
}

TEST_F(JogFrames, RefusesWhatHasNoDirection) {
  EXPECT_EQ(jogged(JogFrame::tool, "B", 10.0, 1.0), "E6052");
  EXPECT_EQ(jogged(JogFrame::tool, "", 10.0, 1.0), "E6052");
  EXPECT_EQ(jogged(JogFrame::tool, "X", 0.0, 1.0), "E6054");
}

TEST_F(JogFrames, RefusesAxesThatAreNotHomed) {
  std::vector<AxisFeedback> drives(5);
  for (AxisFeedback& drive : drives) drive.valid = drive.enabled = drive.referenced = true;
  drives[2].referenced = false;
  bench.feedback(drives);
  bench.cycle();
  const auto from = axes();
  EXPECT_EQ(jogged(JogFrame::plane, "X", 10.0, 1.0), "E6059");
  expect_moved(from, {});
}

// Nobody renews it.
TEST_F(JogFrames, ALeaseEndsAJogAlongALine) {
  jog(JogFrame::plane, "X", 20.0, 0.0);
  bench.run_to_end();
  EXPECT_GT(axes()[0], 1.0);
  EXPECT_LT(axes()[0], 6.0);
}

}  // namespace
}  // namespace stanok::channels
