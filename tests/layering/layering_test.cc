// The folders are the architecture: every #include is read against the DEPENDS lines of the top
// CMakeLists.txt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <regex>

#include "tests/layering/repository.h"
#include "tests/support/project_folders.h"
#include "tests/support/source_tree.h"

namespace stanok::testing {
namespace {

const std::filesystem::path layering =
    std::filesystem::path(stanok::testing::build_folder()) / "layering.txt";

// Folders that hold programs of their own and may include any library; no library may include them.
const std::set<std::string> leaves{"tests", "benchmarks", "programs"};

// The file named by an #include with quotes, or by one with brackets that names a generated
// message.
std::optional<std::string> included_file(const std::string& line) {
  static const std::regex quoted(R"(^\s*#\s*include\s*"([^"]+)\")");
  static const std::regex generated(R"(^\s*#\s*include\s*<(stanok_messages/[^>]+)>)");
  std::smatch match;
  if (std::regex_search(line, match, quoted) || std::regex_search(line, match, generated)) {
    return match[1].str();
  }
  return std::nullopt;
}

std::string folder_of(const std::string& file) {
  const std::string folder = file.substr(0, file.find('/'));
  return folder == "stanok_messages" ? "messages" : folder;
}

std::string listed(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// What is wrong with one #include, or nothing.
std::string complaint(const Layers& layers, const SourceFile& file, const std::string& included) {
  const std::string target = folder_of(included);
  if (included.find('/') == std::string::npos || included.starts_with(".")) {
    return "write includes from the root of the repository: \"folder/" + included + "\"";
  }
  if (!layers.contains(target) && !leaves.contains(target)) {
    return "'" + target + "' is no folder of the top CMakeLists.txt";
  }
  if (leaves.contains(file.folder)) return "";
  if (layers.at(file.folder).contains(target)) return "";
  return "'" + file.folder + "' must not include '" + target + "'; it may include " +
         listed(layers.at(file.folder)) + " (DEPENDS of stanok_library in the top CMakeLists.txt)";
}

TEST(Layering, EveryFolderOfSourcesIsALibraryOfTheBuild) {
  const Layers layers = read_layers(layering);
  std::set<std::string> strangers;
  for (const SourceFile& file : source_files(repository)) {
    if (!layers.contains(file.folder) && !leaves.contains(file.folder)) {
      strangers.insert(file.folder);
    }
  }
  EXPECT_TRUE(strangers.empty()) << "without a stanok_library line: " << listed(strangers);
}

TEST(Layering, EveryIncludeFollowsAnArrowOfTheBuild) {
  const Layers layers = read_layers(layering);
  ASSERT_FALSE(layers.empty()) << layering << " is empty";
  for (const SourceFile& file : source_files(repository)) {
    if (!layers.contains(file.folder) && !leaves.contains(file.folder)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const auto included = included_file(file.lines[i]);
      if (!included) continue;
      const std::string wrong = complaint(layers, file, *included);
      EXPECT_TRUE(wrong.empty()) << file.path << ":" << i + 1 << ": " << wrong;
    }
  }
}

TEST(Layering, TheArrowsHaveNoWayBack) {
  const Layers arrows = read_arrows(layering);
  const Layers layers = read_layers(layering);
  for (const auto& [folder, dependencies] : arrows) {
    for (const std::string& dependency : dependencies) {
      ASSERT_TRUE(layers.contains(dependency)) << folder << " depends on unknown " << dependency;
      EXPECT_FALSE(layers.at(dependency).contains(folder))
          << folder << " and " << dependency << " depend on each other";
    }
  }
}

TEST(Layering, ABreachIsFoundAndNamed) {
  const Layers layers{
      {"base", {"base"}}, {"lang", {"base", "lang"}}, {"motion", {"base", "motion"}}};
  const SourceFile file{"lang/tree/parser.cc", "lang", {}};
  EXPECT_EQ(complaint(layers, file, "base/ring.h"), "");
  EXPECT_THAT(complaint(layers, file, "motion/path.h"),
              ::testing::StartsWith("'lang' must not include 'motion'; it may include base, lang"));
  EXPECT_THAT(complaint(layers, file, "parser.h"), ::testing::HasSubstr("from the root"));
  EXPECT_THAT(complaint(layers, file, "../base/ring.h"), ::testing::HasSubstr("from the root"));
  EXPECT_THAT(complaint(layers, file, "utils/text.h"), ::testing::HasSubstr("no folder"));
  EXPECT_NE(complaint(layers, file, "tests/support/source_tree.h"), "");
}

TEST(Layering, GeneratedMessagesCountAsTheFolderOfTheirTypes) {
  EXPECT_EQ(included_file("#include <stanok_messages/setpoint_t.hpp>"),
            "stanok_messages/setpoint_t.hpp");
  EXPECT_EQ(folder_of("stanok_messages/setpoint_t.hpp"), "messages");
  EXPECT_EQ(included_file("#include <vector>"), std::nullopt);
}

}  // namespace
}  // namespace stanok::testing
