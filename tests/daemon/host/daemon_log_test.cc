// What the daemon says: nobody waits for a reader, what is dropped is counted and told, and the end
// does not wait for a reader either.
#include "daemon/host/daemon_log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "daemon/host/signals.h"

namespace stanok::daemon {
namespace {

// A pipe, and the logger that was there before.
class DaemonLogTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ignore_harmless_signals();
    level_before = spdlog::get_level();
    logger_before = spdlog::default_logger();
    ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    ASSERT_EQ(::fcntl(ends[0], F_SETFL, O_NONBLOCK), 0);
  }
  void TearDown() override {
    spdlog::set_default_logger(logger_before);
    spdlog::set_level(level_before);
    if (ends[0] >= 0) ::close(ends[0]);
  }
  // What can be read now.
  std::string read() {
    std::string text;
    std::array<char, 4096> bytes{};
    for (ssize_t count = 0; (count = ::read(ends[0], bytes.data(), bytes.size())) > 0;)
      text.append(bytes.data(), static_cast<std::size_t>(count));
    return text;
  }
  void open_log() {
    log.emplace(ends[1]);
    spdlog::set_level(spdlog::level::info);
  }

  std::array<int, 2> ends{-1, -1};
  spdlog::level::level_enum level_before = spdlog::level::info;
  std::shared_ptr<spdlog::logger> logger_before;
  std::optional<DaemonLog> log;
};

TEST_F(DaemonLogTest, WritesEveryLineInOrderBeforeItEnds) {
  open_log();
  for (int k = 0; k < 100; ++k) spdlog::info("line {}", k);
  log.reset();
  const std::string text = read();
  std::size_t place = 0;
  for (int k = 0; k < 100; ++k) {
    place = text.find("line " + std::to_string(k) + "\n", place);
    ASSERT_NE(place, std::string::npos) << "line " << k << " is missing";
  }
}

// Many times what the pipe and the queue hold: each call returns, or the test would never end.
TEST_F(DaemonLogTest, WhoSaysSomethingNeverWaitsForAReaderAndWhatIsLostIsTold) {
  constexpr int lines = 20'000;
  const std::size_t lost_before = log_lines_lost();
  open_log();
  for (int k = 0; k < lines; ++k) spdlog::info("line {} {}", k, std::string(100, 'x'));
  std::string text;
  while (text.find("line 19999 ") == std::string::npos) text += read();
  EXPECT_NE(text.find(" lines are missing here"), std::string::npos);
  const auto written = static_cast<std::size_t>(std::count(text.begin(), text.end(), 'x')) / 100;
  EXPECT_EQ(written + log_lines_lost() - lost_before, static_cast<std::size_t>(lines));
}

TEST_F(DaemonLogTest, TheEndDoesNotWaitForAReader) {
  open_log();
  for (int k = 0; k < 5'000; ++k) spdlog::info("line {} {}", k, std::string(100, 'x'));
  log.reset();
  spdlog::info("said when nobody writes any more");
  // Lets the thread that was left behind go on, and end with the reader gone.
  ::close(ends[0]);
  ends[0] = -1;
}

}  // namespace
}  // namespace stanok::daemon
