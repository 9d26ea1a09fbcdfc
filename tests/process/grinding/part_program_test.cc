// Part programs: a row of the table is a block.
#include "process/grinding/part_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

using ::testing::HasSubstr;

TEST(PartProgram, HasABlockForEachFeedOfTheTable) {
  const std::string program = part_program(petrakov::sheet(), petrakov::table(), {});
  EXPECT_THAT(program, HasSubstr("G52 X30\n"));
  EXPECT_THAT(program, HasSubstr("S120 M3\n"));
  EXPECT_THAT(program, HasSubstr(" G0 X0.35\n"));
  EXPECT_THAT(program, HasSubstr(" G1 X0.3 F2.4\n"));
  EXPECT_THAT(program, HasSubstr(" G1 X0.2602 F2.4\n"));
  EXPECT_THAT(program, HasSubstr(" G1 X0.0893 F1.764\n"));
  EXPECT_THAT(program, HasSubstr(" G1 X-0.0048 F0.24\n"));
}

TEST(PartProgram, SpeaksOfWheelAndSparkOutWhenThereAreAny) {
  const ProgramOptions options{.title = "shaft (7)\n\xC3\xA9",
                               .wheel_spindle = 2,
                               .wheel_speed_rpm = 1671.2,
                               .spark_out_s = 1.5};
  const std::string program = part_program(petrakov::sheet(), petrakov::table(), options);
  EXPECT_THAT(program, HasSubstr("(shaft  7    )\n"));
  EXPECT_THAT(program, HasSubstr("$2 S1671.2 M3\n"));
  EXPECT_THAT(program, HasSubstr("G4 P1.5\n"));
  EXPECT_THAT(part_program(petrakov::sheet(), petrakov::table(), {}), HasSubstr("G4 P0.01\n"));
}

// The gauge ends the last feed only; without its signal the wheel retracts and the program says so.
TEST(PartProgram, LetsTheGaugeEndTheLastFeed) {
  const std::string program =
      part_program(petrakov::sheet(), petrakov::table(), {.gauge_margin_mm = 0.02});
  EXPECT_THAT(program, HasSubstr(" G1 X0.02 F0.582\n"));
  EXPECT_THAT(program, HasSubstr(" G38.3 X-0.0248 F0.24\n"));
  EXPECT_THAT(program, Not(HasSubstr("G1 X-0.0048")));
  EXPECT_THAT(program, HasSubstr("G0 X5\nif ($probe_ok == false) { terminate (1600,"));
}

TEST(FeedBlocks, FollowAChangingFeedFromBelow) {
  const InfeedLaw law{{0.3, 0.04}, {0.1, 0.01}};
  double begin_mm = 0.3;
  for (const FeedBlock& block : feed_blocks(law)) {
    const double feed_begin = 0.04 - (0.3 - begin_mm) * 0.15;
    const double feed_end = 0.04 - (0.3 - block.end_mm) * 0.15;
    EXPECT_NEAR(block.feed_mm_per_s, std::min(feed_begin, feed_end), 1e-12);
    EXPECT_LT(feed_begin - feed_end, 0.08 * feed_end);
    begin_mm = block.end_mm;
  }
  EXPECT_EQ(begin_mm, 0.1);
}

}  // namespace
}  // namespace stanok::process
