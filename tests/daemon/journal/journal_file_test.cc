// JournalFile: what was appended is there, wherever the file ends and whatever stands behind it.
#include "daemon/journal/journal_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::IsEmpty;

class JournalFileTest : public ::testing::Test {
 protected:
  std::string text() const {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  void put(const std::string& bytes) const {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  }

  testing::TemporaryDirectory folder;
  fs::path path = folder.path() / "journal.jsonl";
  std::vector<json> three{{{"kind", "a"}, {"text", "line\nbreak and \x01"}},
                          {{"kind", "b"}, {"number", 2}},
                          {{"kind", "c"}}};
};

TEST_F(JournalFileTest, WhereThereIsNoneNothingIsRead) {
  const auto told = JournalFile(path).read();
  EXPECT_THAT(told.records, IsEmpty());
  EXPECT_EQ(told.fault, "");
}

// A power failure may leave any part of the bytes behind.
TEST_F(JournalFileTest, CutOffAnywhereItHasAllRecordsBeforeTheCut) {
  ASSERT_FALSE(JournalFile(path).append(three));
  const std::string whole = text();
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    put(whole.substr(0, length));
    const auto ends =
        std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length), '\n');
    const bool is_cut_before_end = length < whole.size() && whole[length] == '\n';
    JournalFile file(path);
    auto told = file.read();
    ASSERT_EQ(told.records.size(), static_cast<std::size_t>(ends) + (is_cut_before_end ? 1 : 0))
        << length;
    EXPECT_EQ(told.damaged, 0U);
    ASSERT_FALSE(file.append({{{"kind", "next"}}}));
    told = file.read();
    ASSERT_FALSE(told.records.empty());
    EXPECT_EQ(told.records.back()["kind"], "next") << length;
  }
}

TEST_F(JournalFileTest, AFlippedBitCostsOneRecord) {
  ASSERT_FALSE(JournalFile(path).append(three));
  const std::string whole = text();
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    put(damaged);
    const auto told = JournalFile(path).read();
    EXPECT_GE(told.records.size(), whole[place] == '\n' ? 1U : 2U) << place;
    EXPECT_LT(told.records.size(), three.size()) << place;
  }
}

TEST_F(JournalFileTest, AnotherOneTakesItsPlaceAtOnce) {
  JournalFile file(path);
  ASSERT_FALSE(file.append(three));
  ASSERT_FALSE(file.replace({{{"kind", "short"}}}));
  ASSERT_FALSE(file.append({{{"kind", "behind"}}}));
  const auto told = file.read();
  ASSERT_EQ(told.records.size(), 2U);
  EXPECT_EQ(told.records.back()["kind"], "behind");
  EXPECT_EQ(file.bytes(), static_cast<std::int64_t>(fs::file_size(path)));
}

TEST_F(JournalFileTest, WithoutAFolderItSaysSoAndGoesOnWhenThereIsOne) {
  JournalFile file(folder.path() / "none" / "journal.jsonl");
  const auto fault = file.append(three);
  ASSERT_TRUE(fault);
  EXPECT_THAT(*fault, ::testing::HasSubstr("No such file"));
  fs::create_directory(folder.path() / "none");
  EXPECT_FALSE(file.append(three));
  EXPECT_EQ(file.read().records, three);
}

}  // namespace
}  // namespace stanok::daemon
