// LogRetention: what is kept within its bounds, on a clock and a disk of the test's own.
#include "daemon/publish/log_retention.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "daemon/publish/log_files.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

constexpr std::int64_t mb = 1'000'000;

class LogRetentionTest : public ::testing::Test {
 protected:
  // Sparse: it has the size, and takes no room.
  void write(const std::string& name, std::int64_t bytes, std::chrono::seconds age) {
    const fs::path file = folder.path() / name;
    std::ofstream(file).put('x');
    fs::resize_file(file, static_cast<std::uintmax_t>(bytes));
    fs::last_write_time(file, std::chrono::file_clock::from_sys(now - age));
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      found.push_back(entry.path().filename().string());
    return found;
  }
  [[nodiscard]] std::int64_t bytes() const {
    std::int64_t sum = 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (entry.is_regular_file()) sum += static_cast<std::int64_t>(entry.file_size());
    }
    return sum;
  }
  // What others leave of the disk, less the logs.
  LogDisk disk() {
    return {
        .now = [this] { return now; },
        .free_bytes = [this](const fs::path&) { return std::optional(left_by_others - bytes()); }};
  }
  LogRetention retention() { return {folder.path(), "mill", limits, disk()}; }

  stanok::testing::TemporaryDirectory folder;
  std::chrono::system_clock::time_point now =
      std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  LogLimits limits;
  std::int64_t left_by_others = 1'000'000 * mb;
};

TEST(LogFileName, IsOfThisMachineOrNone) {
  const auto is_ours = [](const char* name) { return log_file_name_of(name, "mill").has_value(); };
  EXPECT_TRUE(is_ours("mill-20260101-120000.lcm"));
  EXPECT_TRUE(is_ours("mill-20260101-120000-2.lcm"));
  EXPECT_TRUE(is_ours("mill-20260101-120000.12.lcm"));
  EXPECT_TRUE(is_ours("mill-20260101-120000-3.12.lcm"));
  EXPECT_TRUE(is_ours("mill-flight-20260101-120000.lcm"));
  for (const char* other :
       {"mill-20260101-120000.txt", "mill-20260101-120000.lcm.gz", "mill-20260101.lcm", "mill.lcm",
        "mill2-20260101-120000.lcm", "mill-measurements.csv", "mill-first part.lcm", "mill-.lcm",
        "mill-20260101-120000-.lcm", "mill-20260101-120000.x.lcm", "lathe-20260101-120000.lcm", "",
        "mill-20260101-120000-9999999999999.lcm", "amill-20260101-120000.lcm"})
    EXPECT_FALSE(is_ours(other)) << other;
  const auto piece = log_file_name_of("mill-20260101-120000-2.7.lcm", "mill");
  ASSERT_TRUE(piece);
  EXPECT_EQ(piece->log, "mill-20260101-120000-2");
  EXPECT_EQ(piece->piece, 7);
}

TEST_F(LogRetentionTest, RemovesTheOldestUntilAllKeepWithinTheirSize) {
  limits.bytes_max = 100 * mb;
  write("mill-20260101-000000.lcm", 40 * mb, 40h);
  write("mill-20260101-000000.2.lcm", 40 * mb, 30h);
  write("mill-20260103-000000.lcm", 40 * mb, 20h);
  write("mill-flight-20260104-000000.lcm", 15 * mb, 50h);
  write("lathe-20260101-000000.lcm", 900 * mb, 90h);
  write("mill-measurements.csv", 900 * mb, 90h);
  const KeptLogs kept = retention().tidy({});
  EXPECT_THAT(names(),
              UnorderedElementsAre("mill-20260101-000000.2.lcm", "mill-20260103-000000.lcm",
                                   "mill-flight-20260104-000000.lcm", "lathe-20260101-000000.lcm",
                                   "mill-measurements.csv"));
  EXPECT_EQ(kept.bytes, 95 * mb);
  EXPECT_EQ(kept.files, 3);
  EXPECT_EQ(kept.no_room, "");
}

TEST_F(LogRetentionTest, RemovesWhatIsTooOldWhateverItsSize) {
  limits.age_max = 24h;
  write("mill-20260101-000000.lcm", 1, 25h);
  write("mill-20260102-000000.lcm", 1, 23h);
  write("mill-flight-20260101-000000.lcm", 1, 25h);
  retention().tidy({});
  EXPECT_THAT(names(), UnorderedElementsAre("mill-20260102-000000.lcm"));
}

TEST_F(LogRetentionTest, NeverRemovesThePieceThatIsBeingWritten) {
  limits.bytes_max = 10 * mb;
  limits.age_max = 1h;
  write("mill-20260101-000000.lcm", 40 * mb, 40h);
  write("mill-20260101-000000.2.lcm", 40 * mb, 30h);
  write("mill-20260101-000000.10.lcm", 40 * mb, 20h);
  const KeptLogs kept = retention().tidy(folder.path() / "mill-20260101-000000.lcm");
  EXPECT_THAT(names(), UnorderedElementsAre("mill-20260101-000000.10.lcm"));
  EXPECT_THAT(kept.no_room, HasSubstr("logs_max_gb"));
}

TEST_F(LogRetentionTest, TheNewestFlightFileGoesLast) {
  limits.bytes_max = 50 * mb;
  write("mill-flight-20260101-000000.lcm", 20 * mb, 60h);
  write("mill-flight-20260102-000000.lcm", 20 * mb, 50h);
  write("mill-20260103-000000.lcm", 20 * mb, 40h);
  write("mill-20260104-000000.lcm", 20 * mb, 30h);
  LogRetention kept = retention();
  kept.tidy({});
  EXPECT_THAT(names(),
              UnorderedElementsAre("mill-flight-20260102-000000.lcm", "mill-20260104-000000.lcm"));
  EXPECT_EQ(kept.tidy({}, 30 * mb).no_room, "");
  EXPECT_THAT(names(), UnorderedElementsAre("mill-flight-20260102-000000.lcm"));
  EXPECT_EQ(kept.tidy({}, 50 * mb).no_room, "");
  EXPECT_THAT(names(), UnorderedElementsAre());
  EXPECT_NE(kept.tidy({}, 51 * mb).no_room, "");
}

TEST_F(LogRetentionTest, LeavesTheReservedSpaceFreeAndRestsWhereItCannot) {
  limits.free_bytes_min = 100 * mb;
  limits.bytes_between_looks = 10 * mb;
  write("mill-20260101-000000.lcm", 30 * mb, 40h);
  write("mill-20260102-000000.lcm", 30 * mb, 30h);
  left_by_others = 150 * mb;
  LogRetention kept = retention();
  EXPECT_EQ(kept.tidy({}).no_room, "");
  EXPECT_THAT(names(), UnorderedElementsAre("mill-20260102-000000.lcm"));
  left_by_others = 105 * mb;
  EXPECT_THAT(kept.tidy({}).no_room, HasSubstr("free_space_min_gb"));
  EXPECT_THAT(names(), UnorderedElementsAre());
  left_by_others = 119 * mb;
  EXPECT_NE(kept.tidy({}).no_room, "") << "it goes on with some room more";
  left_by_others = 120 * mb;
  EXPECT_EQ(kept.tidy({}).no_room, "");
  left_by_others = 111 * mb;
  EXPECT_EQ(kept.tidy({}).no_room, "");
}

TEST_F(LogRetentionTest, FollowsNoLinks) {
  limits.bytes_max = 1;
  write("elsewhere", 10, 1h);
  fs::create_symlink(folder.path() / "elsewhere", folder.path() / "mill-20260101-000000.lcm");
  fs::create_directory(folder.path() / "mill-20260102-000000.lcm");
  EXPECT_EQ(retention().tidy({}).files, 0);
  EXPECT_EQ(names().size(), 3U);
}

TEST_F(LogRetentionTest, AFolderThatIsNotThereHasTheSpaceOfItsDisk) {
  limits.free_bytes_min = 1;
  LogRetention kept(folder.path() / "not" / "yet", "mill", limits);
  const KeptLogs found = kept.tidy({});
  EXPECT_TRUE(found.free_bytes);
  EXPECT_EQ(found.no_room, "");
}

// A year of a machine that writes 10 MB/s for 8 h a day beside others who fill the disk now and
// then.
TEST_F(LogRetentionTest, AYearOfLogsKeepsWithinAllBounds) {
  config::RecorderConfig config;
  config.logs_max_gb = 20.0;
  config.logs_max_days = 30.0;
  config.free_space_min_gb = 2.0;
  limits = log_limits_of(config);
  const std::int64_t piece_max = limits.piece_bytes_max;
  ASSERT_EQ(piece_max, 1024 * mb);
  LogRetention kept = retention();
  std::int64_t most = 0;
  for (int hour = 0; hour < 365 * 8; ++hour) {
    now += 1h;
    left_by_others = (hour % 100 < 50 ? 100'000 : 12'000) * mb;
    write("mill-20260101-000000." + std::to_string(hour + 1) + ".lcm", piece_max, 0s);
    const KeptLogs after = kept.tidy(folder.path() / "mill-20260101-000000.lcm");
    ASSERT_EQ(after.no_room, "");
    ASSERT_LE(after.bytes, limits.bytes_max);
    ASSERT_GE(*after.free_bytes, limits.free_bytes_min);
    ASSERT_EQ(after.bytes, bytes());
    most = std::max(most, after.bytes);
  }
  EXPECT_GT(most, 18'000 * mb);
}

TEST(LogFilesThatRest, GoOnWhenThereIsRoom) {
  const stanok::testing::TemporaryDirectory folder;
  std::vector<std::string> troubles;
  LogFiles logs(folder.path(), "mill", 0, [&](const std::string& why) { troubles.push_back(why); });
  ASSERT_TRUE(logs.start());
  logs.turn(0);
  logs.set_room("no room");
  logs.turn(1);
  EXPECT_TRUE(logs.status().rests);
  EXPECT_EQ(logs.status().error, "no room");
  logs.set_room("still none");
  EXPECT_EQ(troubles, std::vector<std::string>{"logging is paused: no room"}) << "once";
  EXPECT_FALSE(logs.start()) << "it rests, and is not over";
  logs.set_room("");
  logs.turn(2);
  EXPECT_FALSE(logs.status().rests);
  EXPECT_EQ(logs.status().error, "");
  ASSERT_TRUE(logs.stop());
  logs.turn(3);
  logs.set_room("none");
  EXPECT_EQ(troubles.size(), 1U) << "nothing was to be written";
  const auto refused = logs.start();
  ASSERT_TRUE(refused && !*refused);
  EXPECT_EQ(refused->error().text, "none");
  logs.set_room("");
  EXPECT_EQ(logs.status().file, "") << "an operator begins logs";
}

TEST(LogFilesThatRest, EndForGoodWhenAnOperatorEndsThem) {
  const stanok::testing::TemporaryDirectory folder;
  LogFiles logs(folder.path(), "mill", 0, [](const std::string&) {});
  logs.set_room("none");
  logs.begin(0);
  EXPECT_TRUE(logs.status().rests);
  EXPECT_TRUE(logs.stop());
  logs.set_room("");
  EXPECT_FALSE(logs.status().rests);
  EXPECT_EQ(logs.status().file, "");
}

}  // namespace
}  // namespace stanok::daemon
