// One version: the one of the build files is the one that programs tell.
#include "protocol/contract/version.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/project_folders.h"

namespace stanok::protocol {
namespace {

TEST(Version, IsTheOneOfTheProject) {
  std::ifstream file(stanok::testing::source_folder() + "/CMakeLists.txt");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("project(stanok VERSION " + std::string(version) + " "),
            std::string::npos);
}

}  // namespace
}  // namespace stanok::protocol
