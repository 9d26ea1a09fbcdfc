// Rules of CONTRIBUTING.md that a machine can read: description of files, their size, unfinished
// marks, codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "base/catalogue.h"
#include "tests/layering/repository.h"
#include "tests/support/source_tree.h"

namespace stanok::testing {
namespace {

constexpr std::size_t description_within = 15;  // lines
constexpr std::size_t lines_max = 600;
constexpr std::size_t files_max = 40;  // of a folder

bool is_code_of_the_runtime(const SourceFile& file) {
  return file.folder != "tests" && file.folder != "benchmarks" &&
         !file.path.starts_with("base/catalogue");
}

// A comment line with at least three words.
bool describes(const std::string& line) {
  static const std::regex description(R"(^//(\s+\S+){3,})");
  return std::regex_search(line, description);
}

TEST(HouseRules, EveryHeaderSaysInItsFirstLinesWhatItIs) {
  for (const SourceFile& file : source_files(repository)) {
    if (!file.is_header()) continue;
    const auto end = file.lines.begin() +
                     static_cast<std::ptrdiff_t>(std::min(file.lines.size(), description_within));
    EXPECT_TRUE(std::any_of(file.lines.begin(), end, describes))
        << file.path << ": no description in the first " << description_within << " lines";
  }
}

TEST(HouseRules, EveryHeaderIsReadOnce) {
  for (const SourceFile& file : source_files(repository)) {
    if (!file.is_header()) continue;
    EXPECT_EQ(std::count(file.lines.begin(), file.lines.end(), "#pragma once"), 1) << file.path;
  }
}

TEST(HouseRules, NoFileIsLongerThanAReaderCanFollow) {
  for (const SourceFile& file : source_files(repository)) {
    EXPECT_LE(file.lines.size(), lines_max) << file.path;
  }
}

TEST(HouseRules, NoFolderHoldsMoreFilesThanAReaderCanSurvey) {
  std::map<std::string, std::size_t> files;
  for (const SourceFile& file : source_files(repository)) {
    ++files[file.path.substr(0, file.path.rfind('/'))];
  }
  for (const auto& [folder, count] : files) {
    EXPECT_LE(count, files_max) << folder << ": divide it into folders of their own";
  }
}

// A type of scheme is two files and one line in a list: who reads or uses schemes knows none by its
// name. Types for words of a program (G12.1) are named by their words.
TEST(HouseRules, NoFolderButKinematicsNamesATypeOfScheme) {
  const std::regex declaration(R"re(type_name = "(\w+_\w+)")re");
  std::set<std::string> types;
  for (const SourceFile& file : source_files(repository)) {
    const auto is_of_programs = [](const std::string& line) {
      return line.find("chosen_by = ChosenBy::program") != std::string::npos;
    };
    if (file.folder != "kinematics" || std::ranges::any_of(file.lines, is_of_programs)) continue;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (std::regex_search(line, match, declaration)) types.insert('"' + match[1].str() + '"');
    }
  }
  EXPECT_GE(types.size(), 3U);
  for (const SourceFile& file : source_files(repository)) {
    if (!is_code_of_the_runtime(file) || file.folder == "kinematics") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string& type : types) {
        EXPECT_EQ(file.lines[i].find(type), std::string::npos) << file.path << ':' << i + 1;
      }
    }
  }
}

TEST(HouseRules, NothingIsLeftUnfinished) {
  // Put together here so that this file does not contain the marks.
  const std::regex mark(std::string(R"(\b()") + "TO" + "DO|FIX" + "ME|XX" + "X|HA" + R"(CK)\b)");
  for (const SourceFile& file : source_files(repository)) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      EXPECT_FALSE(std::regex_search(file.lines[i], mark))
          << file.path << ":" << i + 1 << ": " << file.lines[i];
    }
  }
}

// Functions of which the bool is the value itself: it becomes a value of the language, a text.
const std::set<std::string> functions_of_a_bool{"config: kind_text", "lang: truth",
                                                "lang: value_of"};

// Functions of a text with a bool parameter, but for plain setters: allow_workpieces(bool allowed),
// set_owned(int axis, bool owned).
std::set<std::string> functions_with_bool_parameter(const std::string& text) {
  static const std::regex function(
      R"re((\w+)\(((?:[^(){};"]*,)?\s*(?:const )?bool \w+[^(){};:"]*)\))re");
  static const std::regex setter(R"((set|allow)(_\w+)?\((int \w+, )?bool \w+\))");
  std::set<std::string> names;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), function);
       match != std::sregex_iterator(); ++match) {
    if (!std::regex_match((*match)[0].str(), setter)) names.insert((*match)[1].str());
  }
  return names;
}

// A call reads `rows(channel, AlarmChoice::all)`, not `rows(channel, false)`.
TEST(HouseRules, NoCallSaysTrueOrFalseWithoutAName) {
  for (const SourceFile& file : source_files(repository)) {
    if (!is_code_of_the_runtime(file)) continue;
    std::string text;
    for (const std::string& line : file.lines) text += line.substr(0, line.find("//")) + "\n";
    for (const std::string& name : functions_with_bool_parameter(text)) {
      EXPECT_TRUE(functions_of_a_bool.contains(file.folder + ": " + name))
          << file.path << ": " << name << " has a bool parameter: use an enumeration";
    }
  }
}

TEST(HouseRules, ABoolParameterIsFound) {
  EXPECT_EQ(functions_with_bool_parameter("json rows(int channel,\n  bool all = true) const;\n"
                                          "void set_single_block(bool on);\n"
                                          "void set_owned(int axis, bool owned);\n"
                                          "void set_speed(double speed, bool at_once);\n"
                                          "bool is_idle(int k);\nauto each(bool (*claim)(int));\n"
                                          "refuse(\"a num, bool or string\", \"an axis\");\n"
                                          "for (const bool one : all) {}\n"
                                          "Terminal(bool is_terminal, int size);\n"),
            (std::set<std::string>{"Terminal", "rows", "set_speed"}));
}

// Casts to std::size_t: an array that is read by an index of its own type wants none. More than one
// in 1,000 lines of a folder are too many.
constexpr double casts_max = 1e-3;  // per line

std::size_t casts_to_size(const std::vector<std::string>& lines) {
  static const std::regex cast(R"(static_cast<(std::)?size_t>|\bsize_t\{\w|\(std::size_t\)\w)");
  std::size_t count = 0;
  for (const std::string& line : lines) {
    const std::string source = line.substr(0, line.find("//"));
    count += static_cast<std::size_t>(std::distance(
        std::sregex_iterator(source.begin(), source.end(), cast), std::sregex_iterator()));
  }
  return count;
}

TEST(HouseRules, IndicesAreNotCastAtEveryUse) {
  std::map<std::string, std::size_t> lines;
  std::map<std::string, std::size_t> casts;
  for (const SourceFile& file : source_files(repository)) {
    if (!is_code_of_the_runtime(file)) continue;
    lines[file.folder] += file.lines.size();
    casts[file.folder] += casts_to_size(file.lines);
  }
  for (const auto& [folder, count] : casts) {
    EXPECT_LE(static_cast<double>(count), casts_max * static_cast<double>(lines[folder]))
        << folder << ": " << count << " casts to std::size_t in " << lines[folder] << " lines";
  }
}

TEST(HouseRules, ACastToSizeIsFound) {
  EXPECT_EQ(casts_to_size({"a[static_cast<std::size_t>(i)] = b[static_cast<size_t>(j)];",
                           "f(std::size_t{count}, (std::size_t)k);  // static_cast<std::size_t>(0)",
                           "std::size_t count{};", "std::function<std::size_t(int)> size;"}),
            4U);
}

// Parsers that recurse are called where the depth of the text was measured (base/text_bounds.h).
TEST(HouseRules, TextsAreMeasuredBeforeTheyAreParsed) {
  const std::regex parser(R"((toml|json)::(parse|parse_file|accept|sax_parse|from_\w+)\()");
  for (const SourceFile& file : source_files(repository)) {
    const bool measures = file.path == "config/text/fault_list.cc" ||
                          file.path == "protocol/contract/json_rpc.cc" ||
                          file.path == "client/offline/library/record.cc" ||
                          file.path == "jobs/tools/json_members.cc";
    if (measures || file.path.starts_with("tests/")) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      EXPECT_FALSE(std::regex_search(file.lines[i], parser))
          << file.path << ":" << i + 1 << ": " << file.lines[i];
    }
  }
}

// JSON becomes text in protocol/contract/json_text.h and the words of `stanok` leave in
// client/terminal/output.cc, where bytes that are no UTF-8 are repaired. Nothing goes past them.
TEST(HouseRules, NothingIsWrittenPastTheRepairOfTexts) {
  const std::regex dump(R"(\.dump\()");
  const std::regex output(R"(std::(printf|fprintf|fputs|puts|fwrite|cout|cerr))");
  for (const SourceFile& file : source_files(repository)) {
    const bool is_judged = is_code_of_the_runtime(file) && file.folder != "programs";
    for (std::size_t i = 0; is_judged && i < file.lines.size(); ++i) {
      const std::string place = file.path + ":" + std::to_string(i + 1);
      EXPECT_FALSE(file.path != "protocol/contract/json_text.h" &&
                   std::regex_search(file.lines[i], dump))
          << place << ": use protocol::json_text";
      EXPECT_FALSE(file.folder == "client" && file.path != "client/terminal/output.cc" &&
                   std::regex_search(file.lines[i], output))
          << place << ": use client/terminal/output.h";
    }
  }
}

// Codes of the catalogue as string literals begin with them: "E4031", "E7001 file not found";
// comments do not count.
std::set<std::string> codes_in(const std::string& line) {
  static const std::regex code(R"re("([EA][0-9]{4}|W[0-9]{3,4})[" ])re");
  const std::string source = line.substr(0, line.find("//"));
  std::set<std::string> codes;
  for (auto match = std::sregex_iterator(source.begin(), source.end(), code);
       match != std::sregex_iterator(); ++match) {
    codes.insert((*match)[1].str());
  }
  return codes;
}

TEST(HouseRules, EveryCodeThatIsRaisedHasItsRowInTheCatalogue) {
  for (const SourceFile& file : source_files(repository)) {
    if (!is_code_of_the_runtime(file)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string& code : codes_in(file.lines[i])) {
        EXPECT_NE(find_in_catalogue(code), nullptr) << file.path << ":" << i + 1 << ": " << code;
      }
    }
  }
}

TEST(HouseRules, EveryRowOfTheCatalogueIsRaisedSomewhere) {
  std::set<std::string> raised;
  for (const SourceFile& file : source_files(repository)) {
    if (!is_code_of_the_runtime(file)) continue;
    for (const std::string& line : file.lines) raised.merge(codes_in(line));
  }
  for (const CatalogueRow& row : catalogue()) {
    EXPECT_TRUE(raised.contains(std::string(row.code))) << row.code << ": " << row.title;
  }
}

}  // namespace
}  // namespace stanok::testing
