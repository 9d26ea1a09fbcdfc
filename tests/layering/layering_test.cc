// The folders are the architecture: every #include is read against the DEPENDS lines of the top
// CMakeLists.txt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/layering/repository.h"
#include "tests/support/project_folders.h"
#include "tests/support/source_tree.h"

namespace stanok::testing {
namespace {

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

bool has_modules(const Layers& layers, const std::string& folder) {
  return std::any_of(layers.begin(), layers.end(),
                     [&](const auto& layer) { return layer.first.starts_with(folder + "/"); });
}

std::string listed(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// What is wrong with one #include, or nothing.
std::string complaint(const Layers& layers, const SourceFile& file, const std::string& included) {
  const std::string target = library_of(layers, included);
  const std::string library = library_of(layers, file.path);
  if (included.find('/') == std::string::npos || included.starts_with(".")) {
    return "write includes from the root of the repository: \"folder/" + included + "\"";
  }
  if (!layers.contains(target) && !leaves.contains(target)) {
    return "'" + target + "' is no folder of the top CMakeLists.txt";
  }
  if (leaves.contains(file.folder)) return "";
  if (layers.at(library).contains(target)) return "";
  return "'" + library + "' must not include '" + target + "'; it may include " +
         listed(layers.at(library)) + " (DEPENDS of stanok_library in the top CMakeLists.txt)";
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

// What stood beside modules could include all of them, and be included by those above only.
TEST(Layering, AFolderOfModulesHoldsNothingBesideThem) {
  const Layers layers = read_layers(layering);
  for (const SourceFile& file : source_files(repository)) {
    const std::string library = library_of(layers, file.path);
    EXPECT_FALSE(layers.contains(library) && has_modules(layers, library))
        << file.path << " belongs into a module of " << library << ": "
        << listed(layers.at(library));
  }
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

// Modules are in order by themselves; so are the folders that they lie in.
Layers reach_of_folders(const Layers& arrows) {
  const auto folder_of = [](const std::string& library) {
    return library.substr(0, library.find('/'));
  };
  Layers reach;
  for (const auto& [library, dependencies] : arrows) {
    std::set<std::string>& into = reach[folder_of(library)];
    for (const std::string& dependency : dependencies) into.insert(folder_of(dependency));
    into.erase(folder_of(library));
  }
  for (std::size_t round = 0; round < reach.size(); ++round) {
    for (auto& [folder, into] : reach) {
      const std::set<std::string> direct = into;
      for (const std::string& below : direct) into.insert(reach[below].begin(), reach[below].end());
    }
  }
  return reach;
}

TEST(Layering, TheFoldersHaveNoCircle) {
  for (const auto& [folder, into] : reach_of_folders(read_arrows(layering)))
    EXPECT_FALSE(into.contains(folder)) << folder << " leads back to itself by " << listed(into);
  const Layers circle = reach_of_folders(
      {{"web/machine", {}}, {"gateway/cell", {"web/machine"}}, {"web/cell", {"gateway/cell"}}});
  EXPECT_TRUE(circle.at("web").contains("web"));
}

// The folders in which there is a source or header of this name, without its ending, by top folder.
using Homes = std::map<std::pair<std::string, std::string>, std::set<std::filesystem::path>>;

Homes homes_of(const std::vector<SourceFile>& files) {
  Homes homes;
  for (const SourceFile& file : files) {
    const std::filesystem::path path = file.path;
    homes[{file.folder, path.stem().string()}].insert(path.parent_path());
  }
  return homes;
}

// Where a test should lie that lies elsewhere. One that is named after no source of its folder,
// such as that of a whole chain, lies where it fits.
std::optional<std::filesystem::path> home_of_test(const Homes& homes,
                                                  const std::filesystem::path& test) {
  constexpr std::string_view ending = "_test";
  const std::string stem = test.stem().string();
  if (!stem.ends_with(ending)) return std::nullopt;
  const std::filesystem::path folder = test.parent_path().lexically_relative("tests");
  const auto known =
      homes.find({folder.begin()->string(), stem.substr(0, stem.size() - ending.size())});
  if (known == homes.end() || known->second.contains(folder)) return std::nullopt;
  return "tests" / *known->second.begin();
}

TEST(Layering, ATestLiesInTheFolderOfItsSource) {
  const std::vector<SourceFile> files = source_files(repository);
  const Homes homes = homes_of(files);
  for (const SourceFile& file : files) {
    if (file.folder != "tests") continue;
    const auto home = home_of_test(homes, file.path);
    EXPECT_FALSE(home) << file.path << " belongs in " << *home;
  }
}

TEST(Layering, AMisplacedTestIsFound) {
  const Homes homes = homes_of({{"motion/path/pace.h", "motion", {}}});
  EXPECT_EQ(home_of_test(homes, "tests/motion/pace_test.cc"), "tests/motion/path");
  EXPECT_FALSE(home_of_test(homes, "tests/motion/path/pace_test.cc"));
  EXPECT_FALSE(home_of_test(homes, "tests/lang/pace_test.cc"));
  EXPECT_FALSE(home_of_test(homes, "tests/motion/chain_test.cc"));
}

// What asks a daemon over its socket may be built where no machine is known.
TEST(Layering, TheOperatorsClientKnowsTheProtocolAndNoMachine) {
  const std::set<std::string> known = {"base", "protocol/contract", "client/terminal",
                                       "client/operator"};
  EXPECT_EQ(read_layers(layering).at("client/operator"), known);
}

// What a command computes is a job, which the daemon and Python share with it.
TEST(Layering, NothingIncludesTheCommandLine) {
  const auto is_of_client = [](const std::string& library) {
    return library == "client" || library.starts_with("client/");
  };
  for (const auto& [library, dependencies] : read_layers(layering)) {
    if (is_of_client(library)) continue;
    EXPECT_TRUE(std::ranges::none_of(dependencies, is_of_client)) << library;
  }
}

TEST(Layering, ABreachIsFoundAndNamed) {
  const Layers layers{
      {"base", {"base"}}, {"lang", {"base", "lang"}}, {"motion", {"base", "motion"}}};
  const SourceFile file{"lang/tree/parser.cc", "lang", {}};
  EXPECT_EQ(complaint(layers, file, "base/ring.h"), "");
  EXPECT_THAT(complaint(layers, file, "motion/path/path.h"),
              ::testing::StartsWith("'lang' must not include 'motion'; it may include base, lang"));
  EXPECT_THAT(complaint(layers, file, "parser.h"), ::testing::HasSubstr("from the root"));
  EXPECT_THAT(complaint(layers, file, "../base/ring.h"), ::testing::HasSubstr("from the root"));
  EXPECT_THAT(complaint(layers, file, "utils/text.h"), ::testing::HasSubstr("no folder"));
  EXPECT_NE(complaint(layers, file, "tests/support/source_tree.h"), "");
}

// A module is known by what it depends on, not by its folder: nothing climbs within a folder.
TEST(Layering, AClimbBetweenModulesIsFoundAndNamed) {
  const Layers layers{{"base", {"base"}},
                      {"lang", {"base", "lang", "lang/text", "lang/words"}},
                      {"lang/text", {"base", "lang/text"}},
                      {"lang/words", {"base", "lang/text", "lang/words"}},
                      {"motion", {"base", "motion"}}};
  const SourceFile lower{"lang/text/source.cc", "lang", {}};
  const SourceFile upper{"lang/words/code_table.cc", "lang", {}};
  EXPECT_EQ(complaint(layers, upper, "lang/text/source.h"), "");
  EXPECT_EQ(complaint(layers, upper, "lang/words/code_table.h"), "");
  EXPECT_THAT(complaint(layers, lower, "lang/words/code_table.h"),
              ::testing::StartsWith("'lang/text' must not include 'lang/words'"));
  EXPECT_NE(complaint(layers, upper, "motion/path/path.h"), "");
  EXPECT_TRUE(has_modules(layers, "lang"));
  EXPECT_FALSE(has_modules(layers, "motion"));
  EXPECT_EQ(library_of(layers, "lang/loose.h"), "lang");
  EXPECT_EQ(library_of(layers, "lang/words/deeper/code_table.h"), "lang/words");
  EXPECT_EQ(library_of({{"lang/words/deeper", {}}}, "lang/words/deeper/code_table.h"),
            "lang/words/deeper");
}

TEST(Layering, GeneratedMessagesCountAsTheFolderOfTheirTypes) {
  EXPECT_EQ(included_file("#include <stanok_messages/setpoint_t.hpp>"),
            "stanok_messages/setpoint_t.hpp");
  EXPECT_EQ(library_of({}, "stanok_messages/setpoint_t.hpp"), "messages");
  EXPECT_EQ(included_file("#include <vector>"), std::nullopt);
}

}  // namespace
}  // namespace stanok::testing
