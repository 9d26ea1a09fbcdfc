// Active codes by block, as displays show them.
#include "lang/contract/active_codes.h"

#include <gmock/gmock.h>

#include "tests/lang/program_support.h"

namespace stanok::lang {
namespace {

using ::testing::Contains;
using ::testing::Not;

class ActiveCodesTest : public testing::ProgramTest {
 protected:
  // The codes at a block of a program that has run.
  [[nodiscard]] static std::vector<std::string> at(const std::vector<MeaningChange>& changes,
                                                   std::uint64_t block) {
    ActiveCodes codes = default_codes(ChannelKind::mill);
    for (const MeaningChange& change : changes) {
      if (change.block <= block) codes = change.meaning.codes;
    }
    return names_of(codes, 'G');
  }
};

TEST_F(ActiveCodesTest, AreThoseOfTheirBlockOnPlainLinesAndInLoops) {
  run("G17\nG1 X5 F100\nX6\nG18 G2 X7 Z0 I0.5 K0\n"
      "for (num ii = 0; ii < 1; ii++) {\nG0 X0\nG91 X5\n}\nM30\n");
  const auto changes = interpreter->take_meanings();
  EXPECT_THAT(at(changes, 1), Contains("G0"));
  EXPECT_THAT(at(changes, 2), Contains("G1"));
  EXPECT_THAT(at(changes, 3), Contains("G17"));
  EXPECT_THAT(at(changes, 4), Contains("G2"));
  EXPECT_THAT(at(changes, 4), Contains("G18"));
  EXPECT_THAT(at(changes, 5), Contains("G90"));
  EXPECT_THAT(at(changes, 6), Contains("G91"));
  EXPECT_EQ(names_of(interpreter->standing().codes, 'G'),
            names_of(default_codes(ChannelKind::mill), 'G'))
      << "M30 sets them back";
  EXPECT_TRUE(interpreter->take_meanings().empty());
}

TEST_F(ActiveCodesTest, OfAChannelKindAreThoseThatItsProgramsBeginWith) {
  EXPECT_THAT(names_of(default_codes(ChannelKind::lathe), 'G'), Contains("G95"));
  EXPECT_THAT(names_of(default_codes(ChannelKind::mill), 'G'), Contains("G94"));
  EXPECT_THAT(names_of(default_codes(ChannelKind::mill), 'G'), Not(Contains("G95")));
}

TEST_F(ActiveCodesTest, ShowM9OnlyWithoutCoolant) {
  run("M8 M3 S100\nG4 P0\nM30\n");
  const auto changes = interpreter->take_meanings();
  for (const MeaningChange& change : changes) {
    const auto names = names_of(change.meaning.codes, 'M');
    if (change.block != 1) continue;
    EXPECT_THAT(names, Contains("M3"));
    EXPECT_THAT(names, Contains("M8"));
    EXPECT_THAT(names, Not(Contains("M9")));
  }
  EXPECT_THAT(names_of(default_codes(ChannelKind::mill), 'M'), Contains("M9"));
}

}  // namespace
}  // namespace stanok::lang
