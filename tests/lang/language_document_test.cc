// docs/language.md says the truth: its examples load or are rejected, its table of codes is the one
// of the interpreter. After a change of the code table write that part anew with
//   STANOK_WRITE_DOCS=1 build/dev/tests/lang_tests --gtest_filter='LanguageDocument.*'
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "lang/code_table.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

const std::string path = std::string(STANOK_SOURCE_DIR) + "/docs/language.md";
constexpr std::string_view codes_begin =
    "<!-- codes: written by a test, see tests/lang/language_document_test.cc -->\n";
constexpr std::string_view codes_end = "<!-- end of codes -->";

std::string read_document() {
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string letters_in(LetterSet set) {
  std::string text;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((set & letter_bit(letter)) != 0) text += std::string(text.empty() ? "" : " ") + letter;
  }
  return text;
}

std::string group_of(const Code& code) {
  if (code.group == Group::none) return "–";
  if (code.letter == 'M') return "M";
  return std::to_string(static_cast<int>(code.group) + 1);
}

std::string code_table_text() {
  std::string text = "\n| code | meaning | group | words |\n|---|---|---|---|\n";
  for (const Code& code : code_table()) {
    const std::string name = code_text(code.letter, code.number);
    const bool later = code.action == nullptr;
    std::string words = letters_in(code.words);
    if (code.axes != AxisWords::unused) words = "axes" + (words.empty() ? "" : " " + words);
    text += "| " + (later ? "*" + name + "*" : name) + " | " + std::string(code.title) + " | " +
            group_of(code) + " | " + words + " |\n";
  }
  return text + "\n";
}

class LanguageDocument : public ProgramTest {
 protected:
  struct Example {
    std::string text;
    bool loads;
    int line;
  };

  static std::vector<Example> examples() {
    std::vector<Example> list;
    std::istringstream stream(read_document());
    std::string line;
    bool inside = false;
    for (int number = 1; std::getline(stream, line); ++number) {
      if (!inside && (line == "```nc" || line == "```nc!")) {
        inside = true;
        list.push_back({"", line == "```nc", number});
      } else if (inside && line == "```") {
        inside = false;
      } else if (inside) {
        list.back().text += line + "\n";
      }
    }
    return list;
  }
};

TEST_F(LanguageDocument, HasExamplesThatLoadAndExamplesThatAreRejected) {
  const auto list = examples();
  EXPECT_GT(list.size(), 15u);
  for (const Example& example : list) {
    const auto errors = load_errors(example.text);
    EXPECT_EQ(errors.empty(), example.loads)
        << path << ":" << example.line << "\n"
        << (errors.empty() ? "loads" : to_text(errors.front()));
  }
}

TEST_F(LanguageDocument, HasTheCodesOfTheInterpreter) {
  std::string text = read_document();
  const std::size_t begin = text.find(codes_begin) + codes_begin.size();
  const std::size_t end = text.find(codes_end);
  ASSERT_LE(begin, end);
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) {
    std::ofstream(path) << text.substr(0, begin) + code_table_text() + text.substr(end);
    text = read_document();
  }
  EXPECT_EQ(text.substr(begin, text.find(codes_end) - begin), code_table_text())
      << "write it anew as described in this file";
}

}  // namespace
}  // namespace stanok::lang::testing
