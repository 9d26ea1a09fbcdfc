// Control files: to the letter there and back, and one row for every key and kind of mistake.
#include "process/grinding/control_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

using ::testing::HasSubstr;

// The text with one thing replaced; the thing must be there.
std::string figure_9_with(const std::string& what, const std::string& other) {
  std::string text(petrakov::figure_9);
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), other);
}

TEST(ControlFile, OfThePaperSaysWhatItsFigureSays) {
  const auto file = read_control_text(petrakov::figure_9, "cycle.txt");
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->process, petrakov::sheet());
  EXPECT_EQ(file->law, petrakov::table());
}

TEST(ControlFile, IsWrittenBackToTheLetter) {
  for (const std::string& text :
       {std::string(petrakov::figure_9), figure_9_with("30.0 -", "030.00\t-"),
        figure_9_with("0.0700 0.0233\n", "+7.0e-2   .0233 ; finishing\r\n"),
        figure_9_with("0.0200 0.0097\n", "\n0.0200 0.0097\n\n"),
        "\xEF\xBB\xBF" + std::string(petrakov::figure_9)}) {
    const auto file = read_control_text(text, "cycle.txt");
    ASSERT_TRUE(file.has_value()) << file.error().front().message;
    EXPECT_EQ(control_text(*file), text);
  }
}

TEST(ControlFile, KeepsLabelsAndDecimalsWhenItsTableIsReplaced) {
  auto file = read_control_text(petrakov::figure_9, "cycle.txt");
  ASSERT_TRUE(file.has_value());
  file->process.width_mm = 25.25;
  file->law = {{0.3, 0.0312}, {0.08, 0.0312}, {0.08, 0.0038}, {-0.005, 0.0038}};
  const std::string text = control_text(*file);
  EXPECT_THAT(text, HasSubstr("30.0 - радиус детали\n25.25 - ширина заготовки\n"));
  EXPECT_THAT(text, HasSubstr("\n3 - количество точек переключения\n0.3000 0.0312\n"
                              "0.0800 0.0312\n0.0800 0.0038\n-0.0050 0.0038 } данные УП\n    \n"));
  const auto again = read_control_text(text, "cycle.txt");
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->law, file->law);
}

TEST(ControlFile, ANewOneHasTheFormOfThePaper) {
  const std::string text = control_text({petrakov::sheet(), petrakov::table(), {}});
  EXPECT_EQ("\n" + text + "    \n", petrakov::figure_9);
}

struct Mistake {
  const char* name;
  std::string text;
  int line;
  int column;
  const char* code;
  std::vector<std::string> named;  // key, value, expected range
};

class ControlFileMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(ControlFileMistake, IsNamedWithItsPlaceAndWhatIsExpected) {
  const Mistake& mistake = GetParam();
  const auto file = read_control_text(mistake.text, "cycle.txt");
  ASSERT_FALSE(file.has_value());
  const Diagnostic& diagnostic = file.error().front();
  EXPECT_EQ(diagnostic.code, mistake.code);
  EXPECT_EQ(diagnostic.place.file, "cycle.txt");
  EXPECT_EQ(diagnostic.place.line, mistake.line) << to_text(diagnostic);
  EXPECT_EQ(diagnostic.place.column, mistake.column) << to_text(diagnostic);
  for (const std::string& word : mistake.named) EXPECT_THAT(diagnostic.message, HasSubstr(word));
}

// One number of the sheet replaced by `value`.
Mistake sheet_mistake(const char* name, const std::string& line_begin, const std::string& value,
                      int line, std::vector<std::string> named) {
  const std::size_t blank = line_begin.find(' ');
  const std::string rest = blank == std::string::npos ? "" : line_begin.substr(blank);
  return {name,    figure_9_with("\n" + line_begin, "\n" + value + rest),
          line,    1,
          "E9102", std::move(named)};
}

std::vector<Mistake> sheet_mistakes() {
  return {
      sheet_mistake("RadiusNegative", "30.0 - радиус", "-30.0", 2,
                    {"part_radius is -30", "0.5 to"}),
      sheet_mistake("RadiusInMetres", "30.0 - радиус", "0.03", 2, {"0.03 m would be 30 mm"}),
      sheet_mistake("WidthZero", "20.0 -", "0", 3, {"width is 0", "0.5 to 1000 mm"}),
      sheet_mistake("WheelInMetres", "200.0 -", "0.2", 4, {"wheel_radius", "0.2 m would be 200"}),
      sheet_mistake("StiffnessInNewtonPerMillimetre", "25000000.0 -", "25000.0", 5,
                    {"stiffness is 25000", "N/m", "25000 N/mm would be 25000000 N/m"}),
      sheet_mistake("MassNegative", "32.0 -", "-32", 6, {"mass is -32", "0.1 to 5000 kg"}),
      sheet_mistake("DampingZero", "50911.7 -", "0.0", 7, {"damping is 0", "N s/m"}),
      sheet_mistake("SpeedInTurnsPerSecondOfZero", "120.0 -", "0", 8,
                    {"part_speed is 0", "rev/min"}),
      sheet_mistake("ForceFactorNegative", "3.600 -", "-3.6", 9, {"force_factor is -3.6"}),
      sheet_mistake("ExponentZero", "0.560 -", "0", 10, {"force_exponent is 0", "0.1 to 1"}),
      sheet_mistake("ExponentAboveOne", "0.560 -", "1.56", 10, {"force_exponent is 1.56"}),
      sheet_mistake("DeflectionInMicrometres", "0.010", "10", 11,
                    {"deflection_max is 10", "10 um would be 0.01 mm"}),
      sheet_mistake("CriticalAllowanceNegative", "0.090", "-0.09", 12,
                    {"critical_allowance is -0.09"}),
      sheet_mistake("CriticalAllowanceAboveTheAllowance", "0.090", "0.31", 12,
                    {"critical_allowance is 0.31", "at most the allowance, 0.3 mm"}),
      sheet_mistake("EndRemovalZero", "0.050 }", "0", 13, {"removal_end is 0"}),
      sheet_mistake("EndRemovalAboveTheGreatest", "0.050 }", "0.5", 13,
                    {"removal_end is 0.5", "0.4082"}),
      sheet_mistake("IntervalsZero", "11 -", "0", 14, {"0 intervals", "from 1"}),
      sheet_mistake("IntervalsBroken", "11 -", "1.5", 14, {"1.5 intervals", "whole number"}),
  };
}

std::vector<Mistake> table_mistakes() {
  const auto with = figure_9_with;
  return {
      {"XRises",
       with("0.0893 0.0294", "0.2700 0.0294"),
       18,
       1,
       "E9102",
       {"X 0.2700 mm rises from 0.2602"}},
      {"AllowanceNegative",
       with("0.3000 0.0400", "-0.3000 0.0400"),
       15,
       1,
       "E9102",
       {"-0.3000", "above 0 to 10 mm"}},
      {"AllowanceInMicrometres",
       with("0.3000 0.0400", "300.0 0.0400"),
       15,
       1,
       "E9102",
       {"300.0", "above 0 to 10 mm"}},
      {"FeedZero",
       with("0.0700 0.0177", "0.0700 0.0"),
       21,
       8,
       "E9102",
       {"feed 0.0 mm/s", "above 0"}},
      {"FeedNegative", with("0.0700 0.0177", "0.0700 -0.0177"), 21, 8, "E9102", {"feed -0.0177"}},
      {"FeedInMillimetresPerMinute",
       with("0.3000 0.0400", "0.3000 2.4"),
       15,
       8,
       "E9102",
       {"2.4 mm/min would be 0.04"}},
      {"NotANumber",
       with("0.0700 0.0177", "0.0700 nan"),
       21,
       8,
       "E9101",
       {"'nan' is not a number"}},
      {"Infinite", with("0.0700 0.0177", "inf 0.0177"), 21, 1, "E9101", {"'inf' is not a number"}},
      {"DecimalComma",
       with("30.0 -", "30,0 -"),
       2,
       1,
       "E9101",
       {"'30,0' is not a number", "point and not a comma"}},
      {"NumberMissing", with("20.0 - ширина", "- ширина"), 3, 1, "E9101", {"expected width"}},
      {"FeedMissing", with("0.0700 0.0177", "0.0700"), 21, 7, "E9101", {"row 7 of 12"}},
      {"RowMissing", with("0.0700 0.0177\n", ""), 26, 5, "E9101", {"row 12 of 12", "ends here"}},
      {"RowTooMany",
       with("0.0700 0.0177\n", "0.0700 0.0177\n0.0600 0.0177\n"),
       27,
       1,
       "E9101",
       {"11 intervals", "end of the file"}},
      {"Empty", "", 0, 0, "E9101", {"expected part_radius"}},
  };
}

const auto named = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Sheet, ControlFileMistake, ::testing::ValuesIn(sheet_mistakes()), named);
INSTANTIATE_TEST_SUITE_P(Table, ControlFileMistake, ::testing::ValuesIn(table_mistakes()), named);

// Bytes changed, taken out and doubled at random: a text is refused with a place inside of it, or
// it comes back to the letter.
TEST(ControlFile, IsRefusedOrComesBackToTheLetterHoweverItIsDamaged) {
  constexpr std::string_view bytes = "0123456789.,-+eE \t\r\n}nanif\xD0\0";
  std::mt19937 random(31);
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
  };
  int accepted = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::string text(petrakov::figure_9);
    for (std::size_t damage = 1 + below(3); damage > 0; --damage) {
      const std::size_t place = below(text.size());
      const std::size_t kind = below(3);
      if (kind == 0) text[place] = bytes[below(bytes.size())];
      if (kind == 1) text.erase(place, 1 + below(4));
      if (kind == 2) text.insert(place, text.substr(place, 1 + below(30)));
    }
    const auto file = read_control_text(text, "cycle.txt");
    if (file) {
      ++accepted;
      ASSERT_EQ(control_text(*file), text) << "seed 31, trial " << trial;
      continue;
    }
    const auto lines = static_cast<int>(std::ranges::count(text, '\n')) + 1;
    ASSERT_FALSE(file.error().empty());
    for (const Diagnostic& diagnostic : file.error()) {
      ASSERT_GE(diagnostic.place.line, 1) << "seed 31, trial " << trial;
      ASSERT_LE(diagnostic.place.line, lines) << "seed 31, trial " << trial;
      ASSERT_FALSE(diagnostic.message.empty());
    }
  }
  EXPECT_GT(accepted, 1000);  // labels, and digits within their ranges
}

TEST(ControlFileMistakes, AreAllShownAtOnce) {
  std::string text = figure_9_with("30.0 -", "-30.0 -");
  text.replace(text.find("0.560"), 5, "0.000");
  const auto file = read_control_text(text, "cycle.txt");
  ASSERT_FALSE(file.has_value());
  EXPECT_EQ(file.error().size(), 2U);
}

}  // namespace
}  // namespace stanok::process
