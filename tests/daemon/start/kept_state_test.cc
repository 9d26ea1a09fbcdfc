// What a daemon finds again after its end: tables, and where its axes stood.
#include "daemon/start/kept_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>

#include "config/files/tables_file.h"
#include "daemon/host/durable_file.h"
#include "daemon/host/state_directory.h"
#include "tests/daemon/fake_machine.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

class KeptStateTest : public ::testing::Test {
 protected:
  KeptStateTest() {
    machine.change([this](FakeMachine& fake) {
      now = fake.output;
      now.channels[0].axes[0].position = 12.5;
      now.channels[0].axes[1].position = -0.1;
    });
  }
  void show(const channels::CycleOutput& output) {
    machine.change([&](FakeMachine& fake) { fake.output = output; });
  }
  [[nodiscard]] channels::MachineConfig found() const {
    channels::MachineConfig config = two_channel_machine().machine;
    load_state(folder.path(), config);
    return config;
  }

  stanok::testing::TemporaryDirectory folder;
  FakeMachine machine;
  channels::CycleOutput now;
};

TEST_F(KeptStateTest, AnEmptyDirectoryLeavesTheMachineFile) {
  EXPECT_EQ(found().axes[0].start, 0.0);
  EXPECT_TRUE(found().tables.offsets.empty());
}

TEST_F(KeptStateTest, AxesStartWhereTheyStood) {
  {
    const KeptState kept(folder.path(), machine, [](std::string_view, const std::string&) {});
    show(now);
  }
  EXPECT_EQ(found().axes[0].start, 12.5);
  EXPECT_EQ(found().axes[1].start, -0.1);
}

TEST_F(KeptStateTest, EveryBitOfAPositionIsKept) {
  std::mt19937_64 random(8);
  for (int n = 0; n < 200; ++n) {
    const double position =
        std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 60) - 110);
    show(channels::CycleOutput{});
    now.channels[0].axes[0].position = position;
    {
      const KeptState kept(folder.path(), machine, [](std::string_view, const std::string&) {});
      show(now);
    }
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found().axes[0].start),
              std::bit_cast<std::uint64_t>(position));
  }
}

TEST_F(KeptStateTest, ToolsKeepTheirValuesAndHaveTheShapesOfTheMachineFile) {
  {
    const KeptState kept(folder.path(), machine, [](std::string_view, const std::string&) {});
    machine.change([](FakeMachine& fake) {
      channels::ToolEdge worn;
      worn.number = 7;
      worn.name = "old";
      worn.length = 81.25;
      worn.wear_radius = -0.02;
      fake.tables_now.tools = {worn};
    });
  }
  channels::MachineConfig config = two_channel_machine().machine;
  channels::ToolEdge drill;
  drill.number = 7;
  drill.name = "drill 8";
  drill.kind = "drill";
  drill.length = 90.0;
  drill.point_angle = 140.0;
  channels::ToolEdge added;
  added.number = 120;
  added.length = 33.0;
  config.tables.tools = {drill, added};
  load_state(folder.path(), config);
  ASSERT_EQ(config.tables.tools.size(), 2U);
  EXPECT_EQ(config.tables.tools[0].name, "drill 8");
  EXPECT_EQ(config.tables.tools[0].kind, "drill");
  EXPECT_EQ(config.tables.tools[0].point_angle, 140.0);
  EXPECT_EQ(config.tables.tools[0].length, 81.25);
  EXPECT_EQ(config.tables.tools[0].wear_radius, -0.02);
  EXPECT_EQ(config.tables.tools[1].length, 33.0);
}

TEST_F(KeptStateTest, APositionOutsideOfItsAxisIsNotTaken) {
  {
    const KeptState kept(folder.path(), machine, [](std::string_view, const std::string&) {});
    show(now);
  }
  channels::MachineConfig shorter = two_channel_machine().machine;
  shorter.axes[0].limits.position_max = 12.0;
  load_state(folder.path(), shorter);
  EXPECT_EQ(shorter.axes[0].start, 0.0);
  EXPECT_EQ(shorter.axes[1].start, -0.1);
}

TEST_F(KeptStateTest, DamagedPositionsAreRefusedWithARemedy) {
  std::ofstream(folder.path() / "positions.toml") << "[position]\nX2 = 1.0\n";
  try {
    static_cast<void>(found());
    FAIL() << "taken";
  } catch (const StateDirectoryError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("positions.toml"));
  }
}

// Written ten times a second they would wear the disk out.
constexpr DurableKind tables_kind{.name = "tables", .version = 1};

// #500 to #999 of one pass of a program: all have its number.
channels::TablesConfig tables_with_variables(double pass) {
  channels::TablesConfig tables;
  for (int number = lang::kept_variable_first; number <= lang::kept_variable_last; ++number)
    tables.variables[1][number] = pass;
  return tables;
}

// What a killed process leaves to its parent: the pass that was on disk for certain.
class SharedCount {
 public:
  SharedCount()
      : value_(static_cast<std::atomic<int>*>(::mmap(nullptr, sizeof(std::atomic<int>),
                                                     PROT_READ | PROT_WRITE,
                                                     MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}
  ~SharedCount() { ::munmap(value_, sizeof(std::atomic<int>)); }
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  std::atomic<int>& operator*() { return *value_; }

 private:
  std::atomic<int>* value_;
};

int kills_wanted() {
  const char* const text = std::getenv("STANOK_KILLS");
  return text == nullptr ? 50 : std::atoi(text);
}

// The writer is killed at random after its first write: all variables are those of one pass, and
// none is older than what was written when it was killed.
TEST_F(KeptStateTest, CommonVariablesSurviveAKillAtAnyWrite) {
  std::mt19937 random(17);
  SharedCount written;
  for (int trial = 0, trials = kills_wanted(); trial < trials; ++trial) {
    SCOPED_TRACE(trial);
    const int before = *written;
    const ::pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int pass = before + 1;; ++pass) {
        const std::string text = config::to_toml(tables_with_variables(pass));
        if (write_durably(folder.path() / "tables.toml", tables_kind, text)) ::_exit(1);
        *written = pass;
      }
    }
    int status = 0;
    while (*written == before && ::waitpid(child, &status, WNOHANG) == 0) ::usleep(100);
    ::usleep(static_cast<::useconds_t>(random() % 8000));
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const auto tables = found().tables;
    const auto variables = tables.variables.find(1);
    ASSERT_NE(variables, tables.variables.end());
    const double pass = variables->second.at(lang::kept_variable_first);
    EXPECT_GE(pass, *written);
    EXPECT_LE(pass, *written + 1);
    EXPECT_EQ(tables.variables, tables_with_variables(pass).variables);
  }
  EXPECT_GE(*written, kills_wanted());
}

TEST_F(KeptStateTest, MovingAxesAreWrittenEveryTenSeconds) {
  channels::MachineConfig config = two_channel_machine().machine;
  config.cycle_us = 1000;
  PositionSnapshot snapshot(config);
  const std::string at_start = snapshot(channels::CycleOutput{});
  now.cycle = 1;
  now.channels[0].moving = true;
  EXPECT_EQ(snapshot(now), at_start);
  now.cycle = 9'999;
  EXPECT_EQ(snapshot(now), at_start);
  now.cycle = 10'000;
  const std::string after = snapshot(now);
  EXPECT_NE(after, at_start);
  now.channels[0].axes[0].position = 13.0;
  now.cycle = 10'500;
  EXPECT_EQ(snapshot(now), after);
  now.channels[0].moving = false;
  EXPECT_THAT(snapshot(now), ::testing::HasSubstr("13.0"));
}

}  // namespace
}  // namespace stanok::daemon
