// A preparation that is too slow for its program: the axes rest seldom, each time with a word of
// where and why, the path is kept, and the recorded run repeats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "runtime/replay.h"
#include "tests/runtime/recorded_by_chance.h"

namespace stanok::runtime {
namespace {

using channels::OperatorAction;

// Chords of 0.05 mm on a circle of 20 mm radius, three times round, at 100 mm/s: 3.8 s of motion.
constexpr int circle_chords = 7540;
constexpr double circle_radius = 20.0;

std::string circle() {
  std::ostringstream text;
  text << "G21 G90 G17 G64 P0.01\nG0 X" << circle_radius << " Y0\nF6000\n";
  text << std::fixed;
  for (int k = 1; k <= circle_chords; ++k) {
    const double angle = 3.0 * 2.0 * std::numbers::pi * k / circle_chords;
    text << "G1 X" << circle_radius * std::cos(angle) << " Y" << circle_radius * std::sin(angle)
         << "\n";
  }
  text << "M30\n";
  return text.str();
}

TEST(StarvedPath, RestsOnceInTwoSecondsOfMotionAndSaysWhere) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 3);
  run.program("circle.nc", circle());
  run.ask(OperatorAction::program_load, 1, "circle.nc");
  run.run(200);
  run.ask(OperatorAction::program_start, 1);
  run.prepare_every(100);  // 64 commands in 100 ms: a third of what the path wants
  run.run(100);
  std::vector<std::uint32_t> told;
  int rests = 0;
  double speed_before = 0.0;
  bool is_over = false;
  double worst = 0.0;
  run.watch(
      [&](const channels::CycleOutput& output) {
        const channels::ChannelOutput& channel = output.channels[0];
        is_over = !channel.running;
        const bool in_cut =
            channel.running && channel.tag.line > 3 && channel.tag.line < 3 + circle_chords;
        if (in_cut && channel.path_speed == 0.0 && speed_before > 0.0) ++rests;
        speed_before = channel.path_speed;
        const double x = channel.point_W[0].value;
        const double y = channel.point_W[1].value;
        if (in_cut) worst = std::max(worst, std::abs(std::hypot(x, y) - circle_radius));
      },
      [&](const channels::Event& event) {
        if (event.code.view() == "W730") told.push_back(event.tag.line);
      });
  for (int n = 0; n < 100 && !is_over; ++n) run.run(500);
  run.close();
  EXPECT_TRUE(is_over);
  EXPECT_GE(rests, 1);
  EXPECT_LE(rests, 3) << "3.8 s of motion";
  EXPECT_EQ(told.size(), static_cast<std::size_t>(rests));
  for (const std::uint32_t line : told) EXPECT_GT(line, 3U);
  EXPECT_LT(worst, 0.011) << "the path is kept";
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same()) << (result.difference ? result.difference->field : "");
}

}  // namespace
}  // namespace stanok::runtime
