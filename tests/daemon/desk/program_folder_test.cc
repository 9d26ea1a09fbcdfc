// Programs beneath the program root: versions, conflicts, and names that lead elsewhere.
#include "daemon/desk/program_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

class ProgramFolderTest : public ::testing::Test {
 protected:
  void put(const fs::path& name, const std::string& text) const {
    std::ofstream(root() / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string text_at(const fs::path& name) const {
    std::ostringstream text;
    text << std::ifstream(root() / name, std::ios::binary).rdbuf();
    return text.str();
  }
  [[nodiscard]] fs::path root() const { return temporary_.path() / "root"; }

  ProgramFolderTest() { fs::create_directories(root() / "sub"); }

  stanok::testing::TemporaryDirectory temporary_;
  ProgramFolder folder_{temporary_.path() / "root", {1000, "cp1251"}};
};

TEST_F(ProgramFolderTest, ATextIsReplacedByWhoKnowsItsVersion) {
  const auto first = folder_.write("sub/a.nc", "G0 X1\n", {});
  ASSERT_TRUE(first);
  EXPECT_EQ(text_at("sub/a.nc"), "G0 X1\n");
  EXPECT_EQ(folder_.read("sub/a.nc")->version, *first);
  const auto second = folder_.write("sub/a.nc", "G0 X2\n", {*first});
  ASSERT_TRUE(second);
  EXPECT_NE(*second, *first);
  const auto late = folder_.write("sub/a.nc", "G0 X3\n", {*first});
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().code, "E9019");
  EXPECT_EQ(text_at("sub/a.nc"), "G0 X2\n");
  EXPECT_TRUE(folder_.write("sub/a.nc", "G0 X4\n", {"any"}));
}

// What an editor gets, it can write back: nothing is lost on the way.
TEST_F(ProgramFolderTest, ATextInTheEncodingOfTheFolderIsReadAsUtf8) {
  put("a.nc", "(\xC4\xE5\xF2\xE0\xEB\xFC)\nM30\n");
  const std::string text = "(\u0414\u0435\u0442\u0430\u043B\u044C)\nM30\n";
  const auto found = folder_.read("a.nc");
  EXPECT_EQ(found->text, text);
  EXPECT_TRUE(folder_.write("a.nc", text + "%\n", {found->version}));
  EXPECT_EQ(text_at("a.nc"), text + "%\n");
  EXPECT_EQ(folder_.read("a.nc")->text, text + "%\n");
}

TEST_F(ProgramFolderTest, ANewTextReplacesNone) {
  put("a.nc", "M30\n");
  EXPECT_EQ(folder_.write("a.nc", "M2\n", {}).error().code, "E9019");
  EXPECT_EQ(folder_.write("b.nc", "M2\n", {"0"}).error().code, "E9019") << "it was removed";
  EXPECT_EQ(text_at("a.nc"), "M30\n");
}

TEST_F(ProgramFolderTest, RemovesWhatIsKnown) {
  put("a.nc", "M30\n");
  EXPECT_EQ(folder_.remove("a.nc", {})->code, "E9019");
  EXPECT_FALSE(folder_.remove("a.nc", {folder_.read("a.nc")->version}));
  EXPECT_FALSE(fs::exists(root() / "a.nc"));
  EXPECT_EQ(folder_.remove("a.nc", {"any"})->code, "E7001");
}

TEST_F(ProgramFolderTest, NothingOutsideOfTheRootHasAName) {
  std::ofstream(temporary_.path() / "secret") << "x";
  fs::create_symlink(temporary_.path() / "secret", root() / "link.nc");
  fs::create_directory_symlink(temporary_.path(), root() / "out");
  for (const char* name :
       {"../secret", "/etc/passwd", "sub/../../secret", "out/secret", "out/new.nc", "link.nc",
        "sub", "", "a\\b.nc", "c:a.nc", "a\nb.nc", ".hidden", "sub/.hidden.nc", "none/a.nc", "."}) {
    EXPECT_FALSE(folder_.write(name, "M30\n", {"any"})) << name;
    if (std::string(name) != ".hidden") {
      EXPECT_TRUE(folder_.remove(name, {"any"})) << name;
      EXPECT_FALSE(folder_.read(name)) << name;
    }
  }
  std::ifstream secret(temporary_.path() / "secret");
  EXPECT_EQ(secret.get(), 'x');
  EXPECT_FALSE(fs::exists(temporary_.path() / "new.nc"));
}

TEST_F(ProgramFolderTest, WhatIsTooLongIsRefused) {
  EXPECT_EQ(folder_.write("a.nc", std::string(1001, ' '), {}).error().code, "E8004");
  EXPECT_FALSE(fs::exists(root() / "a.nc"));
}

// Its characters were replaced when it was read: what is written back would be another text.
TEST_F(ProgramFolderTest, ATextThatIsNoUtf8IsNotOverwrittenUnasked) {
  const ProgramFolder unknown(root(), {1000, ""});
  put("a.nc", "(\xCF\xF0\xE8\xE2\xE5\xF2)\nM30\n");
  const auto version = unknown.read("a.nc")->version;
  EXPECT_EQ(unknown.write("a.nc", "M30\n", {version}).error().code, "E9020");
  EXPECT_TRUE(unknown.write("a.nc", "M30\n", {"any"}));
}

TEST_F(ProgramFolderTest, AWriteThatFailsLeavesTheTextAsItWas) {
  put("sub/a.nc", "M30\n");
  fs::create_directory(root() / "sub" / ".a.nc.new");  // the place of the new text is taken
  const auto version = folder_.read("sub/a.nc")->version;
  EXPECT_EQ(folder_.write("sub/a.nc", "M2\n", {version}).error().code, "E9020");
  EXPECT_EQ(text_at("sub/a.nc"), "M30\n");
}

}  // namespace
}  // namespace stanok::daemon
