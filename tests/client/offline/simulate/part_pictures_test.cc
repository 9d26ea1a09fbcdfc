// The real `stanok simulate FOLDER --pictures`: what each program leaves of its blank.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/client/stanok_program.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A blank of that length in X, and a way through it.
std::string part(const std::string& length) {
  return "#workpiece (0, 0.5, 0, " + length +
         ", 20, 10, 10, 10, 10)\nG1 X0 Y0 Z5 F3000\nZ-2\nX5\nM30\n";
}
const std::string png_signature = "\x89PNG\r\n\x1a\n";  // PNG, 5.2

std::string bytes_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class PartPicturesOfALibrary : public ::testing::Test {
 protected:
  PartPicturesOfALibrary() {
    write("programs/one.nc", part("20"));
    write("programs/sub/one.nc", part("30"));
    write("programs/none.nc", "G1 X1 F3000\nM30\n");
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name)) << text;
  }
  [[nodiscard]] int simulate(const std::string& words) const {
    const std::string line = stanok_program + " simulate " + words + " --machine " +
                             testing::source_folder() + "/config/machines/mill3.toml >" +
                             path("data.out") + " 2>" + path("messages.out") + " </dev/null";
    const int status = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(status)) << line;
    return WEXITSTATUS(status);
  }

  testing::TemporaryDirectory folder_;
};

TEST_F(PartPicturesOfALibrary, AreThoseOfEachProgramAlone) {
  const std::string several = path("programs") + " --json --pictures " + path("pictures");
  ASSERT_EQ(simulate(several), 0) << bytes_in(path("messages.out"));
  const json told = json::parse(bytes_in(path("data.out")));
  ASSERT_EQ(told.at("files").size(), 3U);
  for (const std::string name : {"one.nc", "sub/one.nc"}) {
    ASSERT_EQ(simulate(path("programs/" + name) + " --picture " + path("alone.png")), 0);
    const std::string picture = bytes_in(path("pictures/" + name + ".png"));
    EXPECT_TRUE(picture.starts_with(png_signature)) << name;
    EXPECT_TRUE(picture == bytes_in(path("alone.png"))) << name;
  }
  EXPECT_TRUE(bytes_in(path("pictures/one.nc.png")) != bytes_in(path("pictures/sub/one.nc.png")));
  EXPECT_FALSE(fs::exists(path("pictures/none.nc.png")));
  for (const json& file : told.at("files")) {
    const bool has_blank = file.at("file") != path("programs/none.nc");
    ASSERT_EQ(file.contains("pictures"), has_blank) << file;
    if (!has_blank) continue;
    EXPECT_TRUE(fs::exists(file.at("pictures").at(0).get<std::string>()));
  }
}

TEST_F(PartPicturesOfALibrary, AreTheSameFromTheCacheAndBySeveral) {
  const std::string words = path("programs") + " --cache " + path("cache") + " --pictures ";
  ASSERT_EQ(simulate(words + path("fresh") + " --jobs 2"), 0);
  ASSERT_EQ(simulate(words + path("kept")), 0);
  EXPECT_EQ(bytes_in(path("messages.out")), "cache: 3 of 3 results\n");
  for (const std::string name : {"one.nc.png", "sub/one.nc.png"})
    EXPECT_TRUE(bytes_in(path("fresh/" + name)) == bytes_in(path("kept/" + name))) << name;
  // Without pictures a result is another one, whichever was there first.
  ASSERT_EQ(simulate(path("programs") + " --cache " + path("cache")), 0);
  EXPECT_EQ(bytes_in(path("messages.out")), "cache: 0 of 3 results\n");
}

TEST_F(PartPicturesOfALibrary, AreRefusedWhereTwoWouldBeOne) {
  write("others/one.nc", part("20"));
  const std::string words =
      path("programs") + " " + path("others") + " --pictures " + path("pictures");
  EXPECT_EQ(simulate(words), 2);
  EXPECT_NE(bytes_in(path("messages.out")).find("name a folder above both"), std::string::npos);
  EXPECT_EQ(simulate(path("programs/one.nc") + " --pictures " + path("pictures")), 2);
}

TEST_F(PartPicturesOfALibrary, ThatCannotBeWrittenAreAFault) {
  write("taken", "a file, no folder");
  EXPECT_EQ(simulate(path("programs") + " --pictures " + path("taken")), 1);
  EXPECT_NE(bytes_in(path("messages.out")).find("E9204"), std::string::npos);
}

}  // namespace
}  // namespace stanok::client
