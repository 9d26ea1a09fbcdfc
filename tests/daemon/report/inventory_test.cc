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
  EXPECT_EQ(list["programs"],
            json::parse(R"([{"name":"b.nc","bytes":4},{"name":"sub/a.nc","bytes":9}])"));
  EXPECT_EQ(list["complete"], true);
  EXPECT_EQ(program_list(root.path(), 1)["complete"], false);
  EXPECT_TRUE(program_list("/nonexistent")["programs"].empty());
}

}  // namespace
}  // namespace stanok::daemon
