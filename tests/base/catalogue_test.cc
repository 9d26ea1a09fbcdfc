#include "base/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

namespace stanok {
namespace {

TEST(Catalogue, IsSortedByCodeAndEveryCodeIsThereOnce) {
  const auto rows = catalogue();
  ASSERT_FALSE(rows.empty());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_LT(rows[i - 1].code, rows[i].code) << "row " << i;
  }
}

TEST(Catalogue, EveryCodeIsALetterAndFourDigitsOrThreeForEarlyWarnings) {
  const std::regex form("[EWA][0-9]{4}|W[0-9]{3}");
  for (const CatalogueRow& row : catalogue()) {
    EXPECT_TRUE(std::regex_match(std::string(row.code), form)) << row.code;
  }
}

TEST(Catalogue, EveryRowSaysWhatWhyAndHowToGoOn) {
  for (const CatalogueRow& row : catalogue()) {
    EXPECT_FALSE(row.title.empty()) << row.code;
    EXPECT_FALSE(row.remedy.empty()) << row.code;
    EXPECT_FALSE(row.go_on.empty()) << row.code;
    EXPECT_NE(row.title.back(), '.') << row.code << ": a title has no full stop";
  }
}

// E9xxx refuse a command of an operator: the machine goes on as it was.
TEST(Catalogue, WarningsAndRefusedCommandsStopNothing) {
  for (const CatalogueRow& row : catalogue()) {
    const bool stops_nothing = row.code.front() == 'W' || row.code.starts_with("E9");
    EXPECT_EQ(row.reaction == Reaction::warning, stops_nothing) << row.code;
  }
}

TEST(Catalogue, FindsEveryRowByItsCodeAndNoOther) {
  for (const CatalogueRow& row : catalogue()) EXPECT_EQ(find_in_catalogue(row.code), &row);
  EXPECT_EQ(find_in_catalogue("E0000"), nullptr);
  EXPECT_EQ(find_in_catalogue(""), nullptr);
}

}  // namespace
}  // namespace stanok
