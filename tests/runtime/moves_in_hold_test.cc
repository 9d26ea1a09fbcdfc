// A held program whose axes are jogged away, led back along the path and returned, and whose tools
// get other lengths, at random, and whose preparation comes as threads do: the log repeats it bit
// for bit.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "runtime/replay.h"
#include "tests/runtime/recorded_by_chance.h"
#include "tests/support/sanitized.h"

namespace stanok::runtime {
namespace {

using channels::OperatorAction;

class RandomHands {
 public:
  explicit RandomHands(std::uint64_t seed)
      : run("mill3.toml", DriveChoice::ideal, seed), random_(seed) {
    run.watch([this](const channels::CycleOutput& output) { look(output.channels[0]); },
              [](const channels::Event&) {});
    run.program("part.nc", program());
  }

  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  // Corners, arcs, and now and then what cannot be undone.
  std::string program() {
    std::string text = "G90 G17 G21 G54\nM3 S1000\nF3000\nG43 H1\nG0 X200 Y200 Z200\n";
    const std::array<const char*, 4> of_lengths{"G49\n", "G43 H1\n", "G43 H2\n", "G53 G0 Z320\n"};
    for (int n = 0; n < 60; ++n) {
      text += pick(0, 3) == 0 ? "G2 X" + std::to_string(pick(150, 250)) + " Y" +
                                    std::to_string(pick(150, 250)) + " R200\n"
                              : std::string(pick(0, 5) == 0 ? "G0" : "G1") + " X" +
                                    std::to_string(pick(150, 250)) + " Z" +
                                    std::to_string(pick(150, 250)) + "\n";
      if (pick(0, 9) == 0) text += pick(0, 1) == 0 ? "M8\n" : "G4 P0.05\n";
      if (pick(0, 4) == 0) text += of_lengths[static_cast<std::size_t>(pick(0, 3))];
    }
    return text + "M30\n";
  }

  void act() {
    const std::string axis(1, "XYZ"[pick(0, 2)]);
    const double length = pick(0, 1) == 0 ? 0.0 : real(0.1, 60.0);
    const double velocity = (pick(0, 1) == 0 ? -1.0 : 1.0) * real(5.0, 100.0);
    switch (pick(0, 13)) {
      case 0:
        return run.ask(OperatorAction::jog, 1, axis, velocity, real(0.1, 20.0));
      case 1:
        return run.ask(OperatorAction::jog, 1, axis, velocity);
      case 2:
        return run.ask(OperatorAction::handwheel, 1, pick(0, 1) == 0 ? "path" : axis,
                       real(-2.0, 2.0));
      case 3:
        return run.ask(OperatorAction::override_feed, 1, "", real(0.1, 1.5));
      case 4:
      case 5:
        return run.ask(OperatorAction::program_return, 1, "", real(5.0, 80.0));
      case 6:
        return run.ask(OperatorAction::program_resume, 1);
      case 7:
        return run.ask(OperatorAction::program_hold, 1);
      case 8:
      case 9:
        return change_length();
      default: {
        channels::OperatorEvent event;
        event.channel = 1;
        event.command =
            channels::commands::ProgramRetrace{pick(0, 2) == 0 ? channels::RetraceDirection::forward
                                                               : channels::RetraceDirection::back,
                                               length};
        return run.ask(event);
      }
    }
  }

  RecordedByChance run;
  int retraced = 0;  // cycles
  int jogged = 0;

 private:
  void change_length() {
    channels::OperatorEvent event;
    event.command = channels::commands::ToolSet{
        .key = channels::ShortText(pick(0, 1) == 0 ? "length" : "wear_length"),
        .value = real(0.0, 0.4),
        .tool = pick(1, 2)};
    run.ask(event);
  }
  void look(const channels::ChannelOutput& channel) {
    if (!channel.moving || !channel.aside) return;
    ++(channel.retrace.line != 0 ? retraced : jogged);
  }

  std::mt19937_64 random_;
};

TEST(MovesInHold, RepeatBitForBit) {
  int retraced = 0;
  int jogged = 0;
  for (std::uint64_t seed = 1; seed <= testing::cases(20U); ++seed) {
    SCOPED_TRACE(seed);
    RandomHands hands(seed);
    hands.run.run(300);
    hands.run.ask(OperatorAction::program_run, 1, "part.nc");
    hands.run.run(hands.pick(500, 4000));
    hands.run.ask(OperatorAction::program_hold, 1);
    hands.run.run(400);
    for (int n = 0; n < 60; ++n) {
      hands.act();
      hands.run.run(hands.pick(1, 400));
    }
    retraced += hands.retraced;
    jogged += hands.jogged;
    hands.run.close();
    EXPECT_TRUE(replay(hands.run.path(), {}).is_same());
  }
  EXPECT_GT(retraced, 1000);
  EXPECT_GT(jogged, 500);
}

}  // namespace
}  // namespace stanok::runtime
