// docs/reference/language.md and docs/tutorial/programming.md say the truth: their examples load or
// are rejected, the tables of codes, functions and system variables are those of the interpreter.
// After a change of one of them write these parts anew with
//   STANOK_WRITE_DOCS=1 build/dev/tests/lang_tests --gtest_filter='LanguageDocument.*'
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "lang/feed_law/feed_law_words.h"
#include "lang/text/limits.h"
#include "lang/tree/builtin.h"
#include "lang/words/code_table.h"
#include "lang/words/unsupported_word.h"
#include "tests/lang/program_support.h"
#include "tests/support/project_folders.h"

namespace stanok::lang::testing {
namespace {

const std::string path = stanok::testing::source_folder() + "/docs/reference/language.md";

// A part between its two marks is written by this test.
struct WrittenPart {
  std::string name;
  std::string text;

  [[nodiscard]] std::string begin() const {
    return "<!-- " + name + ": written by a test, see tests/lang/language_document_test.cc -->\n";
  }
  [[nodiscard]] std::string end() const { return "<!-- end of " + name + " -->"; }
};

std::string read_document(const std::string& file = path) {
  std::ifstream stream(file);
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
    const bool later = code.action == CodeAction::unsupported;
    std::string words = letters_in(code.words);
    if (code.axes != AxisWords::unused) words = "axes" + (words.empty() ? "" : " " + words);
    text += "| " + (later ? "*" + name + "*" : name) + " | " + std::string(code.title) + " | " +
            group_of(code) + " | " + words + " |\n";
  }
  return text + "\n";
}

// The word for one letter of Builtin::arguments.
std::string argument_name(char letter) {
  switch (letter) {
    case 'n':
      return "num";
    case 'b':
      return "bool";
    case 's':
      return "string";
    case 'a':
      return "axis";
    case 'x':
      return "axis or name";
    case 'p':
      return "name or num";
    default:
      return "...";
  }
}

std::string signature_of(const Builtin& function) {
  std::string text;
  const std::size_t required =
      function.arguments.size() - static_cast<std::size_t>(function.optional_arguments);
  for (std::size_t i = 0; i < function.arguments.size(); ++i) {
    if (i == required) text += i == 0 ? "[" : " [";
    if (i > 0) text += ", ";
    text += argument_name(function.arguments[i]);
  }
  if (function.optional_arguments > 0) text += "]";
  return std::string(function.name) + " (" + text + ")";
}

std::string function_table_text() {
  std::string text = "\n| function | result |\n|---|---|\n";
  for (const Builtin& function : builtins()) {
    text +=
        "| `" + signature_of(function) + "` | " + std::string(type_name(function.result)) + " |\n";
  }
  return text + "\n";
}

std::string variable_table_text() {
  std::string text = "\n| variable | type | known |\n|---|---|---|\n";
  for (const SystemVariable& variable : system_variables()) {
    const std::string index = variable.index == Type::axis     ? "[axis]"
                              : variable.index == Type::number ? "[num]"
                                                               : "";
    text += "| `$" + std::string(variable.name) + index + "` | " +
            std::string(type_name(variable.result)) + " | " +
            (variable.of_machine ? "when the axes stand" : "at once") + " |\n";
  }
  return text + "\n";
}

std::string limit_table_text() {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"bytes of a block | E1007", std::to_string(limits::block_bytes)},
      {"KiB of a statement, or of its head before a body | E1007",
       std::to_string(limits::statement_bytes >> 10)},
      {"braces and O-lines inside each other, brackets and parentheses inside each other | E2030",
       std::to_string(limits::nesting)},
      {"operators in an expression, `else if` of one `if` | E2031",
       std::to_string(limits::operators)},
      {"characters of a name | E3003", std::to_string(limits::name_characters)},
      {"bytes of a string | E3009", std::to_string(limits::string_bytes)},
      {"arguments of an O-line call | E3005", std::to_string(limits::o_call_arguments)},
      {"calls inside each other, of all kinds together | E8001",
       std::to_string(limits::call_depth)},
      {"elements of an array | E3017", std::to_string(limits::array_elements)},
      {"MiB of all arrays of a run, with their strings | E8002",
       std::to_string(limits::run_array_bytes >> 20)},
      {"files of a program | E8003", std::to_string(limits::files)},
      {"statements of a program beside plain blocks | E8002", std::to_string(limits::statements)},
      {"steps of a modulated feed law, one way | E4337", std::to_string(limits::feed_law_steps)},
      {"points of a curve of feeds | E4345", std::to_string(limits::feed_law_points)},
      {"errors shown of a file |", std::to_string(limits::diagnostics)}};
  std::string text = "\n| what | beyond it | at most |\n|---|---|---|\n";
  for (const auto& [what, most] : rows) text += "| " + what + " | " + most + " |\n";
  return text + "\n";
}

std::string law_table_text() {
  std::string text = "\n| law | addresses | as a directive |\n|---|---|---|\n";
  for (const LawForm& form : law_forms()) {
    std::string addresses;
    std::string arguments;
    for (const LawAddress address : form.must()) {
      addresses += (addresses.empty() ? "" : " ") + std::string(name_of(address));
      arguments += ", " + std::string(name_of(address));
    }
    for (const LawAddress address : enum_values<LawAddress>()) {
      if ((form.may >> place_of(address) & 1U) == 0) continue;
      addresses += " [" + std::string(name_of(address)) + "]";
    }
    text += "| " + std::string(form.law) + " | `" + addresses + "` | ";
    text += form.directive.empty() ? "–"
                                   : "`#feedlaw (" + std::string(form.directive) + arguments + ")`";
    text += " |\n";
  }
  return text + "\n";
}

std::string later_table_text() {
  std::string text = "\n| not yet | would be | what works |\n|---|---|---|\n";
  for (const UnsupportedWord& row : unsupported_words()) {
    text += "| `" + std::string(row.word) + "` | " + std::string(row.meaning) + " | " +
            std::string(row.instead) + " |\n";
  }
  return text + "\n";
}

std::vector<WrittenPart> written_parts() {
  return {{"codes", code_table_text()},
          {"functions", function_table_text()},
          {"system variables", variable_table_text()},
          {"limits", limit_table_text()},
          {"feed laws", law_table_text()},
          {"later words", later_table_text()}};
}

class LanguageDocument : public ProgramTest {
 protected:
  // Tools of any number; the channel that the first comment of an example names.
  void prepare_machine_of(const std::string& text) {
    for (int number = 1; number <= 20; ++number) {
      tables.tools[number] = {number, {0.0, 0.0, 100.0}, 3.0};
    }
    channel = text.starts_with("// master") ? master_channel() : mill_xyzbc();
    if (text.starts_with("// lathe")) {
      channel.kind = ChannelKind::lathe;
      channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
    }
  }

  struct Example {
    std::string text;
    bool loads;
    int line;
  };

  static std::vector<Example> examples(const std::string& file) {
    std::vector<Example> list;
    std::istringstream stream(read_document(file));
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
  const auto list = examples(path);
  EXPECT_GT(list.size(), 15u);
  for (const Example& example : list) {
    const auto errors = load_errors(example.text);
    EXPECT_EQ(errors.empty(), example.loads)
        << path << ":" << example.line << "\n"
        << (errors.empty() ? "loads" : to_text(errors.front()));
  }
}

TEST_F(LanguageDocument, SaysOfWhatIsNotYetWhatWorks) {
  for (const UnsupportedWord& row : unsupported_words()) {
    const std::string word(row.word);
    for (const char* kind : {"", "// lathe\n"}) {
      prepare_machine_of(kind);
      const auto errors = load_errors(kind + word + "\nM30\n");
      if (*kind == 0 && errors.at(0).code == "E4009") continue;  // a code of lathes
      ASSERT_EQ(errors.at(0).code, "E2090") << word;
      EXPECT_EQ(errors.at(0).help.at(0), row.instead) << word;
      break;
    }
  }
}

TEST_F(LanguageDocument, HasTheTablesOfTheInterpreter) {
  for (const WrittenPart& part : written_parts()) {
    std::string text = read_document();
    const std::size_t begin = text.find(part.begin()) + part.begin().size();
    const std::size_t end = text.find(part.end());
    ASSERT_LE(begin, end) << part.name;
    if (std::getenv("STANOK_WRITE_DOCS") != nullptr) {
      std::ofstream(path) << text.substr(0, begin) + part.text + text.substr(end);
      text = read_document();
    }
    EXPECT_EQ(text.substr(begin, text.find(part.end()) - begin), part.text)
        << part.name << ": write it anew as described in this file";
  }
}

// The guide shows the text of errors: what it prints is what the program before it gives.
TEST_F(LanguageDocument, GuideHasExamplesThatRunAndTheErrorsOfThoseThatDoNot) {
  const std::string guide = stanok::testing::source_folder() + "/docs/tutorial/programming.md";
  const std::string text = read_document(guide);
  const auto list = examples(guide);
  EXPECT_GT(list.size(), 15u);
  for (const Example& example : list) {
    prepare_machine_of(example.text);
    const std::string code = error_code(example.text);
    EXPECT_EQ(code.empty(), example.loads) << guide << ":" << example.line << "\n"
                                           << to_text(error);
    if (code.empty()) continue;
    const std::string shown = "error[" + code + "]: " + error.message;
    EXPECT_NE(text.find(shown), std::string::npos) << guide << ":" << example.line << "\n" << shown;
  }
}

}  // namespace
}  // namespace stanok::lang::testing
