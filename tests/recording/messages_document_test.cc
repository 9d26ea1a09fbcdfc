// docs/reference/messages.md lists every field of every message as messages/*.lcm defines it. To
// write it anew:
//   STANOK_WRITE_DOCS=1 build/dev/tests/recording_tests --gtest_filter='MessagesDocument.*'
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/project_folders.h"

namespace stanok::recording {
namespace {

namespace fs = std::filesystem;

std::string file_text(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool begins_every_message(const std::string& field) {
  return field == "utime" || field == "cycle" || field == "seq";
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

// One table; `undescribed` gets the fields that have no comment.
std::string section_of(const fs::path& definition, std::vector<std::string>& undescribed) {
  static const std::regex field(R"(^  (\w+) (\w+)((?:\[\w+\])*);\s*(?://\s*(.*))?$)");
  static const std::regex comment(R"(^\s*//\s?(.*)$)");
  static const std::regex further(R"(^ {8,}//\s?(.*)$)");
  const std::string type = definition.stem().string();
  std::string about;
  std::string rows;
  std::ifstream lines(definition);
  bool is_inside = false;
  std::smatch parts;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("struct")) is_inside = true;
    if (!is_inside && std::regex_match(line, parts, comment)) {
      about += (about.empty() ? "" : " ") + parts[1].str();
    } else if (std::regex_match(line, parts, field)) {
      if (begins_every_message(parts[2])) continue;
      if (parts[4].str().empty()) undescribed.push_back(type + "." + parts[2].str());
      rows += "| `" + parts[2].str() + parts[3].str() + "` | " + parts[1].str() + " | " +
              cell(parts[4]) + " |\n";
    } else if (std::regex_match(line, parts, further)) {
      rows.insert(rows.size() - 3, " " + cell(parts[1]));
    } else if (is_inside && std::regex_match(line, parts, comment)) {
      rows += "| | | *" + cell(parts[1]) + "* |\n";
    }
  }
  return "### `" + type + "`\n\n" + about + "\n\n| field | type | meaning |\n|---|---|---|\n" +
         rows + "\n";
}

TEST(MessagesDocument, ListsEveryFieldOfEveryMessage) {
  std::vector<fs::path> definitions;
  for (const auto& entry : fs::directory_iterator(stanok::testing::source_folder() + "/messages"))
    if (entry.path().extension() == ".lcm") definitions.push_back(entry.path());
  std::sort(definitions.begin(), definitions.end());
  std::vector<std::string> undescribed;
  std::string wanted = "\n";
  for (const fs::path& definition : definitions) wanted += section_of(definition, undescribed);
  EXPECT_EQ(undescribed, std::vector<std::string>{});

  const std::string path = stanok::testing::source_folder() + "/docs/reference/messages.md";
  const std::string begin_mark =
      "<!-- fields: written by a test, see tests/recording/messages_document_test.cc -->\n";
  const std::string end_mark = "<!-- end of fields -->";
  std::string manual = file_text(path);
  const std::size_t begin = manual.find(begin_mark);
  const std::size_t end = manual.find(end_mark);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) {
    std::ofstream(path) << manual.substr(0, begin) + begin_mark + wanted + manual.substr(end);
    manual = file_text(path);
  }
  const std::size_t text = begin + begin_mark.size();
  EXPECT_EQ(manual.substr(text, manual.find(end_mark) - text), wanted)
      << "docs/reference/messages.md: write the tables anew as described in this file";
}

}  // namespace
}  // namespace stanok::recording
