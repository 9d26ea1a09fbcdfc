// Lines of a text, whatever stands before the program in it: a mark of UTF-8, a leader of NULs,
// comments and the frame of `%`.
#include "lang/text/source.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

Source source_with(std::string text) {
  auto held = std::make_shared<SourceText>();
  held->name = held->path = "part.nc";
  held->text = std::move(text);
  return Source(std::move(held), TextRules{});
}

TEST(SourceLines, AreThoseOfTheTextBehindAnyBeginning) {
  std::mt19937 random(20261128);
  const auto pick = [&](const std::vector<std::string>& from) {
    return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random)];
  };
  const std::vector<std::string> beginnings{"", "\xEF\xBB\xBF", std::string(94, '\0'),
                                            std::string(3, '\0') + " \t", "  "};
  const std::vector<std::string> first{"", "%", "G21", "; note", "(dialect fanuc)"};
  const std::vector<std::string> words{"", "G0 X1", "(a longer comment than the next line)", "M30",
                                       "N5"};
  for (int round = 0; round < 2000; ++round) {
    const std::string end = pick({"\n", "\r\n"});
    std::vector<std::string> lines{pick(first)};
    for (int k = 0; k < 6; ++k) lines.push_back(pick(words));
    std::string text = pick(beginnings);
    for (std::size_t k = 0; k < lines.size(); ++k)
      text += (k == 0 ? "" : pick({"", "  "})) + lines[k] + pick({"", " "}) + end;
    const Source source = source_with(text);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Span span = source.words_of_line(static_cast<std::uint32_t>(k + 1));
      EXPECT_EQ(source.text(span), lines[k]) << round << ": line " << k + 1;
      EXPECT_EQ(span.line, k + 1);
    }
    EXPECT_TRUE(source.text(source.words_of_line(9)).empty());
  }
}

class FaultBehindABeginning : public ProgramTest,
                              public ::testing::WithParamInterface<std::string> {};

// The fault of a block is told by its line: where a leader stood before the program, the place was
// behind the end of the text.
TEST_P(FaultBehindABeginning, HasItsPlace) {
  run(GetParam() + "; a comment that is longer than what follows\nG1 X10 Y10 ,A45 F100\n");
  EXPECT_EQ(error.code, "E4153");
  EXPECT_EQ(error.place.line, GetParam().ends_with("\n") ? 3 : 2);
  EXPECT_EQ(error.place.column, 1);
  EXPECT_EQ(error.source_line, "G1 X10 Y10 ,A45 F100");
}

INSTANTIATE_TEST_SUITE_P(Texts, FaultBehindABeginning,
                         ::testing::Values("", "\xEF\xBB\xBF", std::string(94, '\0'), "%\n"),
                         [](const auto& with) { return "number_" + std::to_string(with.index); });

}  // namespace
}  // namespace stanok::lang::testing
