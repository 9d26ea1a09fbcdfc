// The situation of a channel and the table by which it changes.
#include "channels/cycle/run_state.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "tests/support/project_folders.h"

namespace stanok::channels {
namespace {

constexpr int change_count = static_cast<int>(Change::switch_ends) + 1;

void apply(RunState& state, std::initializer_list<Change> changes) {
  for (const Change change : changes) state.apply(change);
}

TEST(RunStateTest, BeginsOffAndIsReadyWithPowerAndAProgram) {
  RunState state;
  EXPECT_EQ(state.situation(), Situation::off);
  state.apply(Change::loaded);
  EXPECT_EQ(state.situation(), Situation::off);
  EXPECT_EQ(state.shown(), ChannelState::ready);
  state.apply(Change::power_on);
  EXPECT_EQ(state.situation(), Situation::ready);
  state.apply(Change::power_off);
  EXPECT_EQ(state.situation(), Situation::off);
}

TEST(RunStateTest, ARunIsHeldResumedAndOver) {
  RunState state;
  apply(state, {Change::power_on, Change::loaded, Change::run_begins});
  EXPECT_EQ(state.situation(), Situation::running);
  apply(state, {Change::held, Change::held});
  EXPECT_EQ(state.situation(), Situation::held);
  state.apply(Change::resumed);
  EXPECT_EQ(state.situation(), Situation::running);
  EXPECT_TRUE(state.is_running());
  state.apply(Change::run_ends);
  EXPECT_EQ(state.situation(), Situation::ready);
  EXPECT_FALSE(state.is_running());
}

TEST(RunStateTest, WhileItEndsItShowsWhatItDid) {
  RunState state;
  apply(state, {Change::power_on, Change::loaded, Change::run_begins, Change::held,
                Change::ending_begins});
  EXPECT_EQ(state.situation(), Situation::ending);
  EXPECT_EQ(state.shown(), ChannelState::held);
  EXPECT_TRUE(state.is_running());
  state.apply(Change::run_ends);
  EXPECT_EQ(state.situation(), Situation::ending);
  state.apply(Change::ending_ends);
  EXPECT_EQ(state.situation(), Situation::ready);
}

TEST(RunStateTest, AnAlarmDuringTheEndIsShownAndMayStay) {
  RunState state;
  apply(state, {Change::power_on, Change::loaded, Change::run_begins, Change::ending_begins,
                Change::alarm});
  EXPECT_EQ(state.shown(), ChannelState::alarm);
  apply(state, {Change::run_ends, Change::ending_ends_in_alarm});
  EXPECT_EQ(state.situation(), Situation::alarm);
  state.apply(Change::power_off);
  EXPECT_EQ(state.situation(), Situation::fault);
  state.apply(Change::power_on);
  EXPECT_EQ(state.situation(), Situation::alarm);
}

TEST(RunStateTest, MovesByHandWithinARunAreTheRuns) {
  RunState state;
  apply(state, {Change::power_on, Change::loaded, Change::hand_begins});
  EXPECT_EQ(state.situation(), Situation::by_hand);
  state.apply(Change::hand_ends);
  EXPECT_EQ(state.situation(), Situation::ready);
  apply(state, {Change::run_begins, Change::hand_begins});
  EXPECT_EQ(state.situation(), Situation::running);
  state.apply(Change::hand_ends);
  EXPECT_EQ(state.situation(), Situation::running);
}

// Whatever comes in whatever order: power decides between on and off, an end is left only as one,
// and what runs was begun.
TEST(RunStateTest, HoldsItsInvariantsUnderAnyChanges) {
  std::minstd_rand random(22);
  for (int round = 0; round < 200; ++round) {
    RunState state;
    for (int step = 0; step < 200; ++step) {
      const Situation before = state.situation();
      const auto change = static_cast<Change>(random() % static_cast<unsigned>(change_count));
      state.apply(change);
      const Situation now = state.situation();
      const bool needs_power =
          now == Situation::idle || now == Situation::ready || now == Situation::alarm;
      const bool needs_none = now == Situation::off || now == Situation::fault;
      EXPECT_TRUE(!needs_power || state.is_powered());
      EXPECT_TRUE(!needs_none || !state.is_powered());
      EXPECT_TRUE(now != Situation::ready || state.has_program());
      EXPECT_TRUE(now != Situation::idle || !state.has_program());
      if (before == Situation::ending && now != before) {
        EXPECT_TRUE(change == Change::ending_ends || change == Change::ending_ends_in_alarm);
      }
      if (now == Situation::running && before != now) {
        EXPECT_TRUE(change == Change::run_begins || change == Change::resumed);
      }
    }
  }
}

// The table of docs/developer/channels.md, row by row.
std::string table_for_documents() {
  std::ostringstream text;
  text << "| change | from | to |\n|---|---|---|\n";
  for (const Transition& row : transitions()) {
    text << "| `" << name_of(row.change) << "` |";
    std::string_view comma = " ";
    for (const Situation situation : situations) {
      if ((row.from >> static_cast<unsigned>(situation) & 1U) == 0) continue;
      text << comma << name_of(situation);
      comma = ", ";
    }
    text << " | " << name_of(row.to) << " |\n";
  }
  return text.str();
}

TEST(RunStateTest, TheDocumentPrintsTheTable) {
  std::ifstream file(stanok::testing::source_folder() + "/docs/developer/channels.md");
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(document.find(table_for_documents()), std::string::npos) << table_for_documents();
}

}  // namespace
}  // namespace stanok::channels
