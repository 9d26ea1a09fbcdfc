#include "client/offline/library/cache_hygiene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using std::chrono::hours;

class CacheHygiene : public ::testing::Test {
 protected:
  static std::string name_of_entry(char digit) { return std::string(62, digit); }

  // A file of so many bytes that was used so long ago.
  void put(const std::string& name, std::size_t bytes, hours ago) const {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << std::string(bytes, 'x');
    fs::last_write_time(file, now_ - ago);
  }
  [[nodiscard]] std::set<std::string> leaving(const CacheRoom& room) const {
    std::set<std::string> names;
    for (const CacheEntry& entry : entries_without_room(cache_entries(folder_.path()), room, now_))
      names.insert(entry.file.filename().string());
    return names;
  }

  testing::TemporaryDirectory folder_;
  fs::file_time_type now_ = fs::file_time_type::clock::now();
};

TEST_F(CacheHygiene, WhatWasNotUsedForTooLongLeaves) {
  put("ab/" + name_of_entry('1'), 10, hours(1));
  put("ab/" + name_of_entry('2'), 10, hours(49));
  EXPECT_EQ(leaving({.unused_max = hours(48)}), (std::set<std::string>{name_of_entry('2')}));
}

TEST_F(CacheHygiene, TheOldestLeaveUntilTheRestFits) {
  put("ab/" + name_of_entry('1'), 100, hours(3));
  put("cd/" + name_of_entry('2'), 100, hours(2));
  put("ef/" + name_of_entry('3'), 100, hours(1));
  EXPECT_EQ(leaving({.bytes_max = 300}), std::set<std::string>{});
  EXPECT_EQ(leaving({.bytes_max = 299}), (std::set<std::string>{name_of_entry('1')}));
  EXPECT_EQ(leaving({.bytes_max = 100}),
            (std::set<std::string>{name_of_entry('1'), name_of_entry('2')}));
}

TEST_F(CacheHygiene, RemaindersOfADayLeaveAndYoungOnesStay) {
  put("ab/" + name_of_entry('1') + ".host.12", 10, hours(1));
  put("ab/" + name_of_entry('2') + ".host.12", 10, hours(25));
  EXPECT_EQ(leaving({.bytes_max = 0}), (std::set<std::string>{name_of_entry('2') + ".host.12"}));
}

TEST_F(CacheHygiene, FilesOfOthersAreNotSeen) {
  put("ab/part.nc", 10, hours(99));
  put("programs/" + name_of_entry('1'), 10, hours(99));
  put(name_of_entry('2'), 10, hours(99));
  put("ab/" + name_of_entry('3') + "4", 10, hours(99));
  EXPECT_TRUE(cache_entries(folder_.path()).empty());
}

TEST_F(CacheHygiene, AUseIsNotedOnceADay) {
  put("ab/" + name_of_entry('1'), 10, hours(23));
  put("ab/" + name_of_entry('2'), 10, hours(25));
  for (const char digit : {'1', '2'}) note_use(folder_.path() / "ab" / name_of_entry(digit));
  const auto used = [&](char digit) {
    return fs::last_write_time(folder_.path() / "ab" / name_of_entry(digit));
  };
  EXPECT_EQ(used('1'), now_ - hours(23));
  EXPECT_GE(used('2'), now_);
}

TEST_F(CacheHygiene, TimesAndSizesAreRead) {
  EXPECT_EQ(time_in("30d"), std::chrono::seconds(2'592'000));
  EXPECT_EQ(time_in("90m"), std::chrono::seconds(5'400));
  EXPECT_EQ(bytes_in_size("2G"), 2'147'483'648U);
  EXPECT_EQ(bytes_in_size("64k"), 65'536U);
  EXPECT_EQ(bytes_in_size("1000"), 1'000U);
  for (const char* wrong : {"", "d", "3", "3x", "-1d", "99999999999999999999d", "9999999999999d"})
    EXPECT_FALSE(time_in(wrong)) << wrong;
  for (const char* wrong : {"", "G", "2GB", "-1", "99999999999T"})
    EXPECT_FALSE(bytes_in_size(wrong)) << wrong;
}

}  // namespace
}  // namespace stanok::client
