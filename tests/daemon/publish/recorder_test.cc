// The daemon's recorder: logs on demand, and the file that a fault leaves behind.
#include "daemon/publish/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "recording/read/log_contents.h"
#include "tests/daemon/fake_machine.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

class RecorderTest : public ::testing::Test {
 protected:
  void run(int cycles) {
    for (int n = 0; n < cycles; ++n) {
      output.cycle = ++cycle;
      recorder.on_output(output);
    }
  }
  void raise(const char* code) {
    channels::Event event;
    event.cycle = cycle;
    event.code = FixedText<8>(code);
    recorder.on_event(event);
  }
  std::vector<fs::path> files(const std::string& word) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder.path() / "log", none)) {
      if (entry.path().filename().string().find(word) != std::string::npos)
        found.push_back(entry.path());
    }
    return found;
  }

  // The file that the latest fault leaves behind is written beside the cycles.
  void wait_for_flight(const std::string& before = "") {
    while (recorder.status().flight_file == before) std::this_thread::yield();
  }

  stanok::testing::TemporaryDirectory folder;
  config::MachineFile file = two_channel_machine();
  Recorder recorder{file, "a compiler", {.lcm_url = {}, .log_directory = folder.path() / "log"}};
  channels::CycleOutput output = FakeMachine().newest_output();
  std::int64_t cycle = 0;
};

TEST_F(RecorderTest, BeginsANewLogWhenItsFolderIsRemoved) {
  ASSERT_TRUE(recorder.logs().start());
  run(10);
  fs::remove_all(folder.path() / "log");
  run(10'000);
  ASSERT_EQ(files("fake").size(), 1U);
  const auto log = recorder.logs().stop();
  ASSERT_TRUE(log);
  EXPECT_EQ(*log, files("fake").front());
  run(10);
  EXPECT_GT(fs::file_size(*log), 0U);
}

TEST_F(RecorderTest, SendsThePathThatAProgramWillTake) {
  ASSERT_TRUE(recorder.logs().start());
  run(10);
  recorder.show_path({1, "part.nc", {{{1.0, 2.0, 3.0}, true, false}}});
  run(10);
  const auto log = recorder.logs().stop();
  ASSERT_TRUE(log);
  run(10);
  const auto contents = recording::read_contents(*log);
  ASSERT_TRUE(contents);
  const bool has_path = std::ranges::any_of(
      contents->channels, [](const auto& channel) { return channel.first.ends_with("CH1_PATH"); });
  EXPECT_TRUE(has_path);
}

// On a disk that others fill and empty: the log ends before it is full, the operator hears of it,
// flight files wait too, and a new log begins when there is room.
TEST(RecorderOnAFullDisk, RestsSaysSoAndGoesOn) {
  const stanok::testing::TemporaryDirectory folder;
  config::MachineFile file = two_channel_machine();
  file.recorder.free_space_min_gb = 1.0;
  std::atomic<std::int64_t> free_bytes{10'000'000'000};
  LogDisk disk = disk_of_this_computer();
  disk.free_bytes = [&](const fs::path&) { return std::optional(free_bytes.load()); };
  Recorder recorder(file, "a compiler",
                    {.lcm_url = {},
                     .log_directory = folder.path(),
                     .logs_from_start = true,
                     .disk = disk,
                     .disk_period = std::chrono::milliseconds(1)});
  std::mutex mutex;
  std::vector<std::string> troubles;
  const auto count = [&] {
    const std::lock_guard lock(mutex);
    return troubles.size();
  };
  recorder.tell_trouble_to([&](const std::string& why) {
    const std::lock_guard lock(mutex);
    troubles.push_back(why);
  });
  channels::CycleOutput output = FakeMachine().newest_output();
  const auto run = [&](int cycles) {
    for (int n = 0; n < cycles; ++n) {
      ++output.cycle;
      recorder.on_output(output);
    }
  };
  run(300);
  const std::string first = recorder.status().log_file;
  free_bytes = 1'000'000'001;
  while (!recorder.status().log_rests) std::this_thread::yield();
  run(300);
  EXPECT_EQ(count(), 1U);
  const auto contents = recording::read_contents(first);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound() && !contents->is_cut());
  channels::Event fault;
  fault.cycle = output.cycle;
  fault.code = FixedText<8>("A1001");
  recorder.on_event(fault);
  run(2010);
  while (count() < 2) std::this_thread::yield();
  EXPECT_THAT(troubles.back(), ::testing::HasSubstr("flight recorder"));
  EXPECT_EQ(recorder.status().flight_file, "");
  free_bytes = 2'000'000'000;
  while (recorder.status().log_rests) std::this_thread::yield();
  run(300);
  EXPECT_NE(recorder.status().log_file, first);
  EXPECT_TRUE(fs::exists(recorder.status().log_file));
  EXPECT_EQ(recorder.status().log_error, "");
}

TEST_F(RecorderTest, BeginsAndEndsALogOnDemand) {
  run(10);
  EXPECT_FALSE(recorder.logs().stop()) << "there is none";
  const auto started = recorder.logs().start();
  ASSERT_TRUE(started && *started);
  EXPECT_EQ(recorder.status().log_file, (*started)->string());
  EXPECT_FALSE(recorder.logs().start()) << "there is one";
  run(500);
  EXPECT_EQ(recorder.logs().stop(), **started);
  run(500);
  const auto contents = recording::read_contents(**started);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound());
  EXPECT_EQ(contents->channels.at("STANOK_FAKE_CH1_SETPOINT").messages, 500);
  EXPECT_EQ(recorder.status().log_file, "");
}

// What is still in the buffer does not fit on the disk any more when the log is ended.
TEST_F(RecorderTest, SaysThatTheEndOfALogIsLost) {
  const auto started = recorder.logs().start();
  ASSERT_TRUE(started && *started);
  run(100);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{.rlim_cur = 16, .rlim_max = before.rlim_max};
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  ASSERT_TRUE(recorder.logs().stop());
  run(1);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
  EXPECT_THAT(recorder.status().log_error, ::testing::HasSubstr("File too large"));
}

TEST_F(RecorderTest, SaysWhyALogCannotBeBegun) {
  std::ofstream(folder.path() / "log") << "a file where the folder should be";
  const auto started = recorder.logs().start();
  ASSERT_TRUE(started);
  ASSERT_FALSE(*started);
  EXPECT_THAT(started->error().text, ::testing::HasSubstr("log"));
}

TEST_F(RecorderTest, WritesWhatLedToAFaultAndWhatFollowed) {
  run(1000);
  raise("W604");
  run(3000);
  EXPECT_THAT(files("flight"), ::testing::IsEmpty()) << "a warning";
  raise("A1001");
  run(1990);
  EXPECT_THAT(files("flight"), ::testing::IsEmpty()) << "what follows belongs to it";
  run(20);
  wait_for_flight();
  const auto written = files("flight");
  ASSERT_EQ(written.size(), 1u);
  EXPECT_EQ(recorder.status().flight_file, written.front().string());
  const auto contents = recording::read_contents(written.front());
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound());
  EXPECT_EQ(contents->channels.at("STANOK_FAKE_CH1_SETPOINT").cycle_last, 6000);
}

TEST_F(RecorderTest, KeepsTheNewestTenFlights) {
  for (int fault = 0; fault < 13; ++fault) {
    const std::string before = recorder.status().flight_file;
    raise("A1001");
    run(2100);
    wait_for_flight(before);
  }
  EXPECT_EQ(files("flight").size(), 10u);
}

// Also of a fault that came just before the end.
TEST_F(RecorderTest, WritesTheFlightOfAFaultBeforeItEnds) {
  {
    Recorder short_lived(file, "a compiler",
                         {.lcm_url = {}, .log_directory = folder.path() / "log"});
    output.cycle = 1;
    short_lived.on_output(output);
    channels::Event event;
    event.code = FixedText<8>("A1001");
    short_lived.on_event(event);
  }
  EXPECT_EQ(files("flight").size(), 1U);
}

}  // namespace
}  // namespace stanok::daemon
