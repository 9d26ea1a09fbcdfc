// Nothing of the language is without a program that shows it: every supported G and M code is in a
// program of programs/conformance, every code of the language's diagnostics is expected by such a
// program or named in a test.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "base/catalogue.h"
#include "lang/text/source.h"
#include "lang/words/code_table.h"
#include "tests/support/project_folders.h"

namespace stanok::lang::testing {
namespace {

namespace fs = std::filesystem;

const fs::path root = stanok::testing::source_folder();

std::vector<std::string> texts_below(const fs::path& folder, const std::string& ending) {
  std::vector<std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.path().filename().string().ends_with(ending)) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

void collect(const std::string& text, const std::regex& form, std::set<std::string>& found) {
  for (std::sregex_iterator match(text.begin(), text.end(), form), end; match != end; ++match) {
    found.insert((*match)[1].str());
  }
}

// "G2", "G43.4" of the words of ISO blocks; comments and strings are left out.
std::set<std::string> codes_of_conformance_programs() {
  const std::regex left_out(R"(\([^)]*\)|;[^\n]*|//[^\n]*|"[^"\n]*")");
  const std::regex word(R"((?:^|[^A-Z0-9_.#<])([GM][0-9]+(?:\.[0-9])?)(?![0-9.]))");
  std::set<std::string> found;
  for (const std::string& program : texts_below(root / "programs" / "conformance", ".nc")) {
    std::string text = std::regex_replace(program, left_out, " ");
    std::transform(text.begin(), text.end(), text.begin(), upper_case);
    // Words that stand against each other share no character between them.
    collect(std::regex_replace(text, std::regex("([0-9.])([GM])"), "$1 $2"), word, found);
  }
  std::set<std::string> codes;
  for (const std::string& code : found) {
    codes.insert(std::regex_replace(code, std::regex("^([GM])0+(?=[0-9])"), "$1"));
  }
  return codes;
}

std::set<std::string> diagnostics_raised() {
  std::set<std::string> codes;
  const std::regex expected("; expect (?:error [0-9]+:[0-9]+|warning) ([EW][0-9]+)");
  for (const std::string& program : texts_below(root / "programs" / "conformance", ".nc")) {
    collect(program, expected, codes);
  }
  const std::regex named("\"([EW][0-9]{3,4})\"");
  for (const std::string& test : texts_below(root / "tests", "_test.cc")) {
    collect(test, named, codes);
  }
  return codes;
}

bool belongs_to_language(std::string_view code) {
  return code.front() == 'W' || (code.front() == 'E' && (code[1] <= '5' || code[1] == '8'));
}

TEST(Coverage, EverySupportedCodeIsInAConformanceProgram) {
  const auto shown = codes_of_conformance_programs();
  for (const Code& row : code_table()) {
    if (row.action == CodeAction::unsupported) continue;
    const std::string code = code_text(row.letter, row.number);
    EXPECT_TRUE(shown.contains(code)) << code << " (" << row.title << ") is in no program";
  }
}

TEST(Coverage, EveryDiagnosticOfTheLanguageIsRaisedByAProgramOrATest) {
  const auto raised = diagnostics_raised();
  for (const CatalogueRow& row : catalogue()) {
    if (!belongs_to_language(row.code)) continue;
    EXPECT_TRUE(raised.contains(std::string(row.code))) << row.code << " (" << row.title << ")";
  }
}

}  // namespace
}  // namespace stanok::lang::testing
