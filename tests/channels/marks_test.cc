// Marks: channels that wait for each other, with and without a stop; deadlocks; flags.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::machine_of_one_axis_channels;
using testing::MachineBench;
using ::testing::UnorderedElementsAre;

// The channels with ids 1, 2, ... run these texts, all started in the same cycle.
class MarksTest : public ::testing::Test {
 protected:
  void start(const std::vector<std::string>& texts) {
    bench = std::make_unique<MachineBench>(
        machine_of_one_axis_channels(static_cast<int>(texts.size())));
    for (std::size_t k = 0; k < texts.size(); ++k) {
      const std::string name = "p" + std::to_string(k + 1) + ".nc";
      bench->program(name, texts[k]);
      bench->run(static_cast<int>(k) + 1, name);
    }
  }
  void run(const std::vector<std::string>& texts) {
    start(texts);
    bench->run_to_end();
  }
  [[nodiscard]] std::string alarm_text(std::size_t index) const {
    const auto alarms = bench->machine().alarms();
    return index < alarms.size() ? to_text(alarms[index].diagnostic) : "";
  }

  std::unique_ptr<MachineBench> bench;
};

TEST_F(MarksTest, EarlyChannelStandsUntilTheLateOneComes) {
  start({"G1 X1 F6000\nmark_wait (1, 2);\nX2\nM30\n",
         "G4 P0.5\nG1 X1 F6000\nmark_wait (1, 1);\nM30\n"});
  double left_at = 0.0;
  double came_at = 0.0;
  bench->run_to_end([&](const CycleOutput& output) {
    if (output.channels[0].axes[0].position <= 1.0) left_at = static_cast<double>(output.cycle);
    if (output.channels[1].axes[0].position < 1.0) came_at = static_cast<double>(output.cycle);
  });
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  EXPECT_GT(left_at, came_at) << "the first channel goes on when the second stands at the mark";
  EXPECT_LT(left_at, came_at + 10.0);
}

TEST_F(MarksTest, ThreeChannelsMeetAtOneMark) {
  run({"mark_wait (7, 2, 3);\nM30\n", "G4 P0.1\nmark_wait (7, 1, 3);\nM30\n",
       "G4 P0.2\nmark_wait (7, 1, 2);\nM30\n"});
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  const auto runs = bench->machine().runs();
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].end_cycle, runs[2].end_cycle);
  EXPECT_EQ(runs[1].end_cycle, runs[2].end_cycle);
}

TEST_F(MarksTest, DifferentSetsAtOneMarkAreAnErrorInTheArrivingChannel) {
  run({"mark_wait (1, 2);\nM30\n", "G4 P0.1\nmark_wait (1, 3);\nM30\n", "G4 P0.3\nM30\n"});
  ASSERT_THAT(bench->alarm_codes(), Contains("E6022"));
  EXPECT_EQ(bench->machine().alarms()[0].channel, 2);
  EXPECT_THAT(alarm_text(0), HasSubstr("p1.nc:1"));
}

TEST_F(MarksTest, IndependentGroupsMayUseTheSameMark) {
  run({"mark_wait (1, 2);\nM30\n", "mark_wait (1, 1);\nM30\n", "mark_wait (1, 4);\nM30\n",
       "mark_wait (1, 3);\nM30\n"});
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
}

TEST_F(MarksTest, CallThatClosesACircleNamesEveryEdge) {
  run({"\nmark_wait (1, 2);\nM30\n", "G4 P0.1\nmark_wait (2, 3);\nM30\n",
       "G4 P0.2\n\n\nif (channel_wait (1) == false) { msg (\"no\"); }\nM30\n"});
  ASSERT_THAT(bench->alarm_codes(), Contains("E6020"));
  EXPECT_EQ(bench->machine().alarms()[0].channel, 3) << "the call that closes the circle fails";
  EXPECT_THAT(alarm_text(0), HasSubstr("channel 1 waits for channel 2 at mark 1 (p1.nc:2)"));
  EXPECT_THAT(alarm_text(0), HasSubstr("channel 2 waits for channel 3 at mark 2 (p2.nc:2)"));
  EXPECT_THAT(alarm_text(0), HasSubstr("channel 3 waits for channel 1 (p3.nc:4)"));
}

TEST_F(MarksTest, PartnerThatEndedIsAnError) {
  run({"G4 P0.1\nmark_wait (1, 2);\nM30\n", "M30\n"});
  ASSERT_THAT(bench->alarm_codes(), ElementsAre("E6021"));
  EXPECT_EQ(bench->machine().alarms()[0].channel, 1);
}

TEST_F(MarksTest, PartnerThatIsResetWhileAwaitedIsAnError) {
  start({"mark_wait (1, 2);\nM30\n", "G4 P10\nM30\n"});
  for (int n = 0; n < 100; ++n) bench->cycle();
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  bench->ask(OperatorAction::program_reset, 2);
  bench->run_to_end();
  EXPECT_THAT(bench->alarm_codes(), ElementsAre("E6021"));
}

TEST_F(MarksTest, PartnerNotYetStartedIsAwaited) {
  bench = std::make_unique<MachineBench>(machine_of_one_axis_channels(2));
  bench->program("a.nc", "mark_wait (1, 2);\nM30\n");
  bench->program("b.nc", "mark_wait (1, 1);\nM30\n");
  bench->run(1, "a.nc");
  bench->run_to_end();
  EXPECT_TRUE(bench->channel(1).waiting);
  EXPECT_EQ(bench->channel(1).wait.cause, WaitCause::mark);
  EXPECT_EQ(bench->channel(1).wait.number, 1);
  EXPECT_EQ(bench->channel(1).wait.channels & 1U << 2U, 1U << 2U);
  bench->run(2, "b.nc");
  bench->run_to_end();
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  EXPECT_FALSE(bench->channel(1).running);
}

TEST_F(MarksTest, MarkOutsideItsRangeIsFoundAtLoad) {
  run({"mark_set (200);\nM30\n"});
  bench->may_refuse();
  EXPECT_THAT(bench->machine().load_diagnostics().at(0).diagnostic.code, "E6023");
}

TEST_F(MarksTest, SoftMarkDoesNotStopThePathWhenThePartnerIsThere) {
  const std::string moves = "G64 P0.01\nG1 X50 F6000\n";
  start({moves + "mark_wait_soft (3, 2);\nX100\nM30\n", "mark_wait (3, 1);\nM30\n"});
  double slowest = 1e9;
  bench->run_to_end([&](const CycleOutput& output) {
    const AxisSetpoint& axis = output.channels[0].axes[0];
    if (axis.position > 20.0 && axis.position < 80.0) slowest = std::min(slowest, axis.velocity);
  });
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  EXPECT_NEAR(slowest, 100.0, 1e-6) << "6000 mm/min all along";
  EXPECT_EQ(bench->channel(1).axes[0].position, 100.0);
}

TEST_F(MarksTest, SoftMarkStopsThePathWithinLimitsUntilThePartnerComes) {
  start({"G64 P0.01\nG1 X50 F6000\nmark_wait_soft (3, 2);\nX100\nM30\n",
         "G4 P2\nmark_wait (3, 1);\nM30\n"});
  int standing = 0;
  double velocity = 0.0;
  bench->run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& lane = output.channels[0];
    EXPECT_LE(std::abs(lane.axes[0].velocity - velocity), 2500.0 * 0.001 + 1e-6);
    velocity = lane.axes[0].velocity;
    if (lane.running && lane.waiting) {
      ++standing;
      EXPECT_NEAR(lane.axes[0].position, 50.0, 1e-6);
    }
  });
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  EXPECT_GT(standing, 1000);
  EXPECT_EQ(bench->channel(1).axes[0].position, 100.0);
}

TEST_F(MarksTest, SoftMarksMeetWhoeverIsFirst) {
  for (const char* delay : {"0.1", "0.5", "0.9"}) {
    run({"G1 X50 F6000\nmark_wait_soft (3, 2);\nX100\nmark_wait_soft (4, 2);\nM30\n",
         std::string("G4 P") + delay +
             "\nG1 X20 F6000\nmark_wait_soft (3, 1);\nX30\nmark_wait_soft (4, 1);\nX31\nM30\n"});
    EXPECT_THAT(bench->alarm_codes(), IsEmpty()) << delay;
    EXPECT_EQ(bench->channel(1).axes[0].position, 100.0);
    EXPECT_EQ(bench->channel(2).axes[0].position, 31.0);
  }
}

TEST_F(MarksTest, SoftMarkCloseBehindAnOpenOneIsNotRunOver) {
  start(
      {"G64 P0.01\nG1 X50 F6000\nmark_wait_soft (3, 2);\nX50.05\nmark_wait_soft (4, 2);\n"
       "X100\nM30\n",
       "mark_wait (3, 1);\nG4 P2\nmark_wait (4, 1);\nM30\n"});
  int standing = 0;
  bench->run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& lane = output.channels[0];
    if (!lane.running || !lane.waiting) return;
    ++standing;
    EXPECT_NEAR(lane.axes[0].position, 50.05, 1e-6);
  });
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  EXPECT_GT(standing, 1000);
  EXPECT_EQ(bench->channel(1).axes[0].position, 100.0);
}

TEST_F(MarksTest, DeadlockAtASoftMarkIsFoundWhereTheChannelStands) {
  run({"G1 X10 F6000\nmark_wait_soft (1, 2);\nX20\nM30\n", "G4 P1\nchannel_wait (1);\nM30\n"});
  ASSERT_THAT(bench->alarm_codes(), Contains("E6020"));
  run({"G4 P1\nG1 X10 F6000\nmark_wait_soft (1, 2);\nX20\nM30\n", "channel_wait (1);\nM30\n"});
  ASSERT_THAT(bench->alarm_codes(), Contains("E6020"));
  EXPECT_EQ(bench->machine().alarms()[0].channel, 1);
  EXPECT_THAT(alarm_text(0), HasSubstr("channel 2 waits for channel 1 (p2.nc:1)"));
}

TEST_F(MarksTest, FlagIsSetWhereThePathPassesIt) {
  start({"G1 X50 F6000\nmark_set (5);\nX100\nM30\n",
         "num was_set = 0;\nwhile (mark_is_set (1, 5) == false) { was_set = was_set + 1; }\n"
         "channel_stop (1);\nM30\n"});
  bench->run_to_end();
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  const double stopped = bench->channel(1).axes[0].position;
  EXPECT_GT(stopped, 50.0);
  EXPECT_LT(stopped, 60.0) << "not set before its place, and seen at once";
}

TEST_F(MarksTest, FlagIsClearedByItsChannelAndByTheNextStart) {
  run({"mark_set (5);\nmark_set (6);\nmark_clear (5);\nG4 P0.2\nM30\n",
       "G4 P0.1\nif (mark_is_set (1, 5)) { terminate (1005, \"5\"); }\n"
       "if (mark_is_set (1, 6) == false) { terminate (1006, \"6\"); }\n"
       "channel_wait (1);\nchannel_start (1);\n"
       "if (mark_is_set (1, 6)) { terminate (1007, \"6\"); }\nM30\n"});
  EXPECT_THAT(bench->alarm_codes(), IsEmpty());
}

TEST_F(MarksTest, CycleWithMarksNeverUsesTheHeap) {
  start({"G1 X50 F6000\nmark_set (1);\nmark_wait_soft (3, 2);\nX100\nM30\n",
         "G4 P1\nmark_wait (3, 1);\nmark_wait (4, 1);\nM30\n"});
  for (int n = 0; n < 5; ++n) bench->cycle();
  CycleOutput output;
  for (int n = 0; n < 3000; ++n) {
    for (int k = 0; k < 2; ++k) {
      while (bench->machine().prepare(k) != Progress::blocked) {
      }
    }
    const testing::NoAllocation guard;
    bench->machine().cycle({}, output);
  }
  EXPECT_THAT(bench->alarm_codes(), ElementsAre("E6021")) << "mark 4 is never met";
}

// A random program of moves, marks and waits for one of `count` channels.
std::string random_program(std::mt19937& random, int own, int count) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::string text = "G64 P0.01\n";
  double x = 0.0;
  const int lines = 2 + below(6);
  for (int line = 0; line < lines; ++line) {
    int other = 1 + below(count);
    if (other == own) other = own % count + 1;
    const std::string mark = std::to_string(below(2));
    switch (below(6)) {
      case 0:
        text += "G4 P0.0" + std::to_string(below(10)) + "\n";
        break;
      case 1:
        text += "mark_wait (" + mark + ", " + std::to_string(other) + ");\n";
        break;
      case 2:
        text += "mark_wait_soft (" + mark + ", " + std::to_string(other) + ");\n";
        break;
      case 3:
        text += "channel_wait (" + std::to_string(other) + ");\n";
        break;
      case 4:
        text += "mark_set (" + mark + ");\n";
        break;
      default:
        x += 1.0 + below(5);
        text += "G1 F6000 X" + std::to_string(x) + "\n";
    }
  }
  return text + "M30\n";
}

TEST_F(MarksTest, RandomProgramsEndOrReportWhyAndNeverHang) {
  constexpr int channels = 8;
  int deadlocks = 0;
  for (unsigned seed = 1; seed <= stanok::testing::cases(12U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto record = [&] {
      std::mt19937 random(seed);
      std::vector<std::string> texts;
      for (int k = 1; k <= channels; ++k) texts.push_back(random_program(random, k, channels));
      start(texts);
      std::string bytes;
      bench->run_to_end(
          [&](const CycleOutput& output) {
            for (const ChannelOutput& lane : output.channels) {
              bytes.append(reinterpret_cast<const char*>(&lane.axes[0].position), sizeof(double));
              bytes.push_back(static_cast<char>(lane.state));
            }
          },
          20000);
      return bytes;
    };
    const std::string first = record();
    for (int k = 1; k <= channels; ++k) {
      EXPECT_FALSE(bench->channel(k).running) << "channel " << k << " never ends";
    }
    const auto codes = bench->alarm_codes();
    EXPECT_THAT(codes, Each(::testing::AnyOf("E6010", "E6020", "E6021", "E6022")));
    deadlocks += static_cast<int>(std::count(codes.begin(), codes.end(), "E6020"));
    EXPECT_EQ(record(), first) << "two runs differ";
  }
  EXPECT_GT(deadlocks, 0) << "the programs are too tame";
}

}  // namespace
}  // namespace stanok::channels
