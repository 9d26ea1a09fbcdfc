// Inventory: the programs beneath a root, for those who choose one.
#include "daemon/report/inventory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

TEST(ProgramList, NamesFilesBeneathTheRootAndFollowsNoLinks) {
  namespace fs = std::filesystem;
  const stanok::testing::TemporaryDirectory root;
  fs::create_directories(root.path() / "sub" / ".hidden");
  std::ofstream(root.path() / "b.nc") << "M30\n";
  std::ofstream(root.path() / "sub" / "a.nc") << "G0X1\nM30\n";
  std::ofstream(root.path() / "sub" / ".hidden" / "c.nc") << "x";
  fs::create_symlink("/etc/passwd", root.path() / "link.nc");
  fs::create_directory_symlink("/", root.path() / "all");
  const json list = program_list(root.path());
  ASSERT_EQ(list["programs"].size(), 2U);
  EXPECT_EQ(list["programs"][0]["name"], "b.nc");
  EXPECT_EQ(list["programs"][0]["bytes"], 4);
  EXPECT_EQ(list["programs"][1]["name"], "sub/a.nc");
  EXPECT_EQ(list["programs"][1]["bytes"], 9);
  // Of the Unix clock, to a second as some file systems have it.
  constexpr auto time = std::chrono::sys_seconds(std::chrono::seconds(1'700'000'000));
  fs::last_write_time(root.path() / "b.nc", std::chrono::file_clock::from_sys(time));
  EXPECT_NEAR(program_list(root.path())["programs"][0]["changed_s"].get<double>(), 1.7e9, 1.0);
  EXPECT_EQ(list["complete"], true);
  EXPECT_EQ(program_list(root.path(), 1)["complete"], false);
  EXPECT_TRUE(program_list("/nonexistent")["programs"].empty());
}

}  // namespace
}  // namespace stanok::daemon
