// Sizes of classes, measured by universal-ctags over the code of the runtime.
//
// A class is what the keyword `class` declares, and a `struct` that has a method. A struct whose
// only functions are constructors, its destructor and operators is a plain record and may have as
// many fields as it needs. Methods are the functions declared in the body of a class, with
// constructors and operators; members are its data members but for static ones; headers and sources
// are the files in which the class or one of its methods is defined.
#include <gtest/gtest.h>
#include <stdio.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/layering/repository.h"
#include "tests/support/source_tree.h"
#include "tests/support/temporary_directory.h"

namespace stanok::testing {
namespace {

constexpr std::size_t methods_max = 40;
constexpr std::size_t members_max = 15;
constexpr std::size_t headers_max = 1;
constexpr std::size_t sources_max = 2;

// One line of ctags.
struct Tag {
  std::string kind;
  std::string scope;
  std::string name;
  std::string file;
  std::size_t line = 0;
  std::size_t end = 0;
  std::string properties;
  std::string bases;  // "A,B<int>"

  // Without the namespace of the project and the names that ctags gives to unnamed ones.
  [[nodiscard]] static std::string scoped_name(const std::string& text) {
    static const std::regex unneeded(R"(__anon\w+::|^stanok::)");
    return std::regex_replace(text, unneeded, "");
  }
  [[nodiscard]] std::string declares() const {
    return scoped_name(scope.empty() ? name : scope + "::" + name);
  }
  [[nodiscard]] bool is_class() const { return kind == "class" || kind == "struct"; }
};

struct Class {
  std::string file;
  std::size_t first_line = 0;
  std::size_t last_line = 0;
  bool is_record = false;  // as far as known: a struct without a method
  std::size_t methods = 0;
  std::size_t members = 0;
  std::string bases;
  std::set<std::string> headers;
  std::set<std::string> sources;
};
using Classes = std::map<std::string, Class>;

// What ctags finds in `files`, paths from `root`. They are handed over in a file: all sources
// together are longer than a command line may be.
std::vector<Tag> tags_of(const std::filesystem::path& root, const std::vector<std::string>& files) {
  const TemporaryDirectory folder;
  const std::filesystem::path list = folder.path() / "files";
  std::ofstream stream(list);
  for (const std::string& file : files) stream << file << '\n';
  stream.close();
  const std::string command =
      "cd '" + root.string() + "' && ctags --options=NONE --languages=C++ --langmap=C++:.h.cc " +
      "--kinds-C++=cspfm -I RT_SAFE --fields=+ei '--fields-C++=+{properties}' -x --_xformat=" +
      "'%{kind}|%{scope}|%{name}|%{input}|%{line}|%{end}|%{C++.properties}|%{inherits}' -L '" +
      list.string() + "'";
  std::vector<Tag> tags;
  FILE* output = ::popen(command.c_str(), "r");
  if (output == nullptr) return tags;
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = ::fread(buffer.data(), 1, buffer.size(), output)) {
    text.append(buffer.data(), count);
  }
  EXPECT_EQ(::pclose(output), 0) << "universal-ctags is wanted: tools/install-packages.sh test";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    // An operator may have the mark between the fields in its name: it is no field then.
    static const std::regex row(
        R"(([^|]*)\|([^|]*)\|(.*)\|([^|]*)\|(\d+)\|(\d*)\|([^|]*)\|([^|]*))");
    std::smatch field;
    if (!std::regex_match(line, field, row)) continue;
    const auto number = [&](std::size_t i) {
      return field[i].length() == 0 ? 0 : std::stoul(field[i]);
    };
    tags.push_back(
        {field[1], field[2], field[3], field[4], number(5), number(6), field[7], field[8]});
  }
  return tags;
}

// Constructors, destructors and operators do not make a record a class.
bool is_method_by_name(const Tag& tag) {
  const std::string owner = tag.scope.substr(tag.scope.rfind(':') + 1);
  return tag.name != owner && tag.name != "~" + owner && !tag.name.starts_with("operator");
}

void count(const Tag& tag, Class& owner) {
  if (tag.kind == "member") {
    owner.members += tag.properties.find("static") == std::string::npos ? 1 : 0;
    return;
  }
  if (tag.kind == "function") {
    (tag.file.ends_with(".h") ? owner.headers : owner.sources).insert(tag.file);
  }
  const bool is_in_body =
      tag.file == owner.file && tag.line >= owner.first_line && tag.line <= owner.last_line;
  if (!is_in_body) return;
  ++owner.methods;
  if (is_method_by_name(tag)) owner.is_record = false;
}

Classes classes_of(const std::vector<Tag>& tags) {
  Classes classes;
  for (const Tag& tag : tags) {
    if (!tag.is_class()) continue;
    Class& found = classes[tag.declares()];
    found = {.file = tag.file,
             .first_line = tag.line,
             .last_line = tag.end,
             .is_record = tag.kind == "struct",
             .bases = tag.bases,
             .headers = {},
             .sources = {}};
    (tag.file.ends_with(".h") ? found.headers : found.sources).insert(tag.file);
  }
  for (const Tag& tag : tags) {
    const auto owner = classes.find(Tag::scoped_name(tag.scope));
    if (!tag.is_class() && owner != classes.end()) count(tag, owner->second);
  }
  return classes;
}

// What is too large of a class, or nothing.
std::string excess(const Class& measured) {
  std::ostringstream text;
  const auto compare = [&](const char* what, std::size_t count, std::size_t count_max) {
    if (count > count_max) text << count << ' ' << what << ", not over " << count_max << "; ";
  };
  if (measured.is_record) return "";
  compare("methods", measured.methods, methods_max);
  compare("data members", measured.members, members_max);
  compare("headers", measured.headers.size(), headers_max);
  compare("sources", measured.sources.size(), sources_max);
  return text.str();
}

std::vector<std::string> files_of_the_runtime() {
  std::vector<std::string> files;
  for (const SourceFile& file : source_files(repository)) {
    if (file.folder != "tests" && file.folder != "benchmarks") files.push_back(file.path);
  }
  return files;
}

TEST(ClassSizes, NoClassIsLargerThanAReaderCanHoldInMind) {
  const Classes classes = classes_of(tags_of(repository, files_of_the_runtime()));
  EXPECT_GT(classes.size(), 500U);
  for (const auto& [name, measured] : classes) {
    EXPECT_EQ(excess(measured), "") << name << " (" << measured.file << "): divide it into classes";
  }
}

// The class of this name as it is seen within `scope`; nothing: of a library.
const Class* class_seen_from(const Classes& classes, std::string scope, const std::string& name) {
  while (true) {
    const std::size_t end = scope.rfind("::");
    const auto found =
        classes.find(end == std::string::npos ? name : scope.substr(0, end) + "::" + name);
    if (found != classes.end()) return &found->second;
    if (end == std::string::npos) return nullptr;
    scope.resize(end);
  }
}

// Data members with those of the classes that it is derived from: an object has them all.
std::size_t members_with_inherited(const Classes& classes, const std::string& name,
                                   const Class& measured) {
  std::size_t members = measured.members;
  std::istringstream bases(measured.bases);
  for (std::string base; std::getline(bases, base, ',');) {
    const std::string plain = base.substr(0, base.find('<'));
    const Class* const found = class_seen_from(classes, name, plain);
    if (found != nullptr && found != &measured)
      members += members_with_inherited(classes, name, *found);
  }
  return members;
}

// Those that were divided into a base and itself; they may only become smaller.
const std::map<std::string, std::size_t> larger_with_inherited{{"channels::Channel", 20},
                                                               {"lang::ActiveBlock", 23}};

TEST(ClassSizes, InheritedMembersCount) {
  const Classes classes = classes_of(tags_of(repository, files_of_the_runtime()));
  for (const auto& [name, measured] : classes) {
    if (measured.is_record || measured.bases.empty()) continue;
    const auto known = larger_with_inherited.find(name);
    const std::size_t most = known == larger_with_inherited.end() ? members_max : known->second;
    EXPECT_LE(members_with_inherited(classes, name, measured), most)
        << name << " (" << measured.file << ") has them with those it inherits";
  }
}

class ClassSizesOf : public ::testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    std::ofstream(folder_.path() / file) << "namespace stanok::motion {\n" << text << "}\n";
    files_.push_back(file);
  }
  [[nodiscard]] Classes classes() const { return classes_of(tags_of(folder_.path(), files_)); }

 private:
  TemporaryDirectory folder_;
  std::vector<std::string> files_;
};

TEST_F(ClassSizesOf, WhatIsDeclaredIsCounted) {
  write("queue.h",
        "class Queue {\n public:\n  Queue();\n  [[nodiscard]] int size() const RT_SAFE;\n"
        "  int twice() const { return 2 * size(); }\n"
        "  struct Entry { int a = 0, b = 0; };\n"
        " private:\n  static constexpr int size_max = 3;\n  int size_ = 0;\n"
        "  std::vector<double> values_{1.0};\n};\n");
  const Classes found = classes();
  ASSERT_TRUE(found.contains("motion::Queue"));
  EXPECT_EQ(found.at("motion::Queue").methods, 3U);
  EXPECT_EQ(found.at("motion::Queue").members, 2U);
  EXPECT_FALSE(found.at("motion::Queue").is_record);
  EXPECT_TRUE(found.at("motion::Queue::Entry").is_record);
}

TEST_F(ClassSizesOf, TooManyMethodsAndMembersAreFound) {
  std::string text = "struct Large {\n";
  for (int i = 0; i < 41; ++i) text += "  void method_" + std::to_string(i) + "(int);\n";
  for (int i = 0; i < 16; ++i) text += "  int member_" + std::to_string(i) + " = 0;\n";
  write("large.h", text + "};\n");
  EXPECT_EQ(excess(classes().at("motion::Large")),
            "41 methods, not over 40; 16 data members, not over 15; ");
}

TEST_F(ClassSizesOf, AnObjectHasTheMembersOfItsBases) {
  write("base.h", "struct Part {\n  int use();\n  int a = 0;\n  int b = 0;\n};\n");
  write("whole.h", "class Whole : public Part {\n  int more();\n  int c_ = 0;\n};\n");
  const Classes found = classes();
  EXPECT_EQ(members_with_inherited(found, "motion::Whole", found.at("motion::Whole")), 3U);
  EXPECT_EQ(members_with_inherited(found, "motion::Part", found.at("motion::Part")), 2U);
}

TEST_F(ClassSizesOf, ARecordMayHaveManyFields) {
  std::string fields;
  for (int i = 0; i < 30; ++i) fields += "  int field_" + std::to_string(i) + " = 0;\n";
  write("row.h", "struct Row {\n  Row();\n  bool operator==(const Row&) const = default;\n" +
                     fields + "};\nclass Closed {\n" + fields + "};\n");
  EXPECT_EQ(excess(classes().at("motion::Row")), "");
  EXPECT_EQ(excess(classes().at("motion::Closed")), "30 data members, not over 15; ");
}

TEST_F(ClassSizesOf, AClassCutOverManyFilesIsFound) {
  write("wide.h", "class Wide {\n  void a();\n  void b();\n  void c();\n  void d();\n};\n");
  write("wide_inline.h", "inline void Wide::d() {}\n");
  for (const char* part : {"a", "b", "c"}) {
    write("wide_" + std::string(part) + ".cc", "void Wide::" + std::string(part) + "() {}\n");
  }
  EXPECT_EQ(excess(classes().at("motion::Wide")), "2 headers, not over 1; 3 sources, not over 2; ");
  EXPECT_EQ(classes().at("motion::Wide").methods, 4U);
}

TEST_F(ClassSizesOf, AClassOfOneFileIsFoundInItsUnnamedNamespace) {
  write("local.cc", "namespace {\nclass Local {\n  int reads() const;\n  int line_ = 0;\n};\n}\n");
  EXPECT_EQ(classes().at("motion::Local").members, 1U);
  EXPECT_TRUE(classes().at("motion::Local").headers.empty());
}

}  // namespace
}  // namespace stanok::testing
