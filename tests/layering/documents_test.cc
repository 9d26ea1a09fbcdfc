// What a machine can judge of the documents: width of lines, words that no manual uses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/layering/repository.h"

namespace stanok::testing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t width_max = 120;  // characters; prose is wrapped at 100

std::vector<fs::path> documents() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(repository)) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  for (const auto& entry : fs::recursive_directory_iterator(repository / "docs")) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

// Of UTF-8.
std::size_t characters(const std::string& line) {
  return static_cast<std::size_t>(std::ranges::count_if(
      line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Without what cannot be broken: code, links, pictures.
std::string breakable(const std::string& line) {
  std::string rest;
  bool is_code = false;
  int brackets = 0;
  for (const char c : line) {
    if (c == '`') is_code = !is_code;
    if (c == '[' || c == '(') ++brackets;
    if (!is_code && brackets == 0 && c != '`') rest += c;
    if ((c == ']' || c == ')') && brackets > 0) --brackets;
  }
  return rest;
}

struct Prose {
  std::string place;  // file:line
  std::string line;
};

// Lines outside of code, tables, comments and formulas, and of what a test writes.
std::vector<Prose> prose_of(const fs::path& document) {
  std::vector<Prose> prose;
  std::ifstream stream(document);
  bool is_code = false;
  bool is_written = false;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string text = line.substr(std::min(line.size(), line.find_first_not_of(' ')));
    if (text.starts_with("```")) is_code = !is_code;
    if (text.starts_with("<!--")) is_written = text.find("written by a test") != std::string::npos;
    const bool is_formula = line.starts_with("    ");
    const bool is_other = text.starts_with("|") || text.starts_with("<") || text.starts_with("![");
    if (is_code || is_written || is_formula || is_other) continue;
    prose.push_back(
        {fs::relative(document, repository).string() + ":" + std::to_string(number), line});
  }
  return prose;
}

TEST(Documents, LinesOfProseFitAScreen) {
  for (const fs::path& document : documents()) {
    for (const Prose& prose : prose_of(document)) {
      const bool is_wide = characters(prose.line) > width_max;
      EXPECT_FALSE(is_wide && breakable(prose.line).size() > width_max / 3)
          << prose.place << ": " << characters(prose.line) << " characters; wrap it at 100";
    }
  }
}

TEST(Documents, AWideLineIsFoundAndALongLinkIsNot) {
  EXPECT_EQ(breakable("see [the page](../operator/panel.md) and `stanok check a.nc` now"),
            "see  and  now");
  EXPECT_EQ(characters("Ø 5 µm"), 6U);
}

// Words that readers of manuals stumble over; each had its better one in the last revision.
TEST(Documents, SpeakTheEnglishOfAManual) {
  constexpr auto avoided = std::to_array<const char*>(
      {" anew", "codes in force", "who knows ", "comes about", "comes to be", "of its own accord",
       "wear of length", "wear of radius", "the other way round", "line by hand", "makes out of"});
  for (const fs::path& document : documents()) {
    if (document.string().find("/adr/") != std::string::npos) continue;
    for (const Prose& prose : prose_of(document)) {
      for (const char* const words : avoided)
        EXPECT_EQ(prose.line.find(words), std::string::npos)
            << prose.place << ": '" << words << "'";
    }
  }
}

// Recipes list the files that they change, as `git diff --stat` does. One that the recipe makes is
// named in its text, too.
TEST(Documents, RecipesNameFilesThatExist) {
  std::ifstream stream(repository / "docs" / "developer" / "how-to-add.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  static const std::regex listed(R"(^ (\S+)\s+\|\s+\d+ [+-]+$)");
  std::size_t files = 0;
  for (const std::string& line : lines) {
    std::smatch match;
    if (!std::regex_match(line, match, listed) || match[1].str().starts_with("...")) continue;
    ++files;
    const std::string file = match[1];
    const std::string stem = fs::path(file).stem().string();
    const auto mentions = std::ranges::count_if(
        lines, [&](const std::string& other) { return other.find(stem) != std::string::npos; });
    EXPECT_TRUE(fs::exists(repository / file) || mentions > 1) << file << " does not exist";
  }
  EXPECT_GT(files, 40U);
}

}  // namespace
}  // namespace stanok::testing
