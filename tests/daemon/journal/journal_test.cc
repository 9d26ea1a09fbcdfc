// Journal: what it was told is there at the next start, and a disk that takes nothing is told once.
#include "daemon/journal/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using namespace std::chrono_literals;

std::vector<std::string> kinds(const std::vector<json>& records) {
  std::vector<std::string> all;
  for (const json& record : records) all.push_back(record["kind"]);
  return all;
}

void wait_for(const std::function<bool()>& condition) {
  while (!condition()) std::this_thread::sleep_for(1ms);
}

TEST(Journal, WhatItWasToldIsThereAtTheNextStart) {
  const testing::TemporaryDirectory folder;
  std::string id;
  {
    Journal journal(folder.path());
    id = journal.id();
    journal.begin([] { return std::vector<json>{}; }, [](const std::string&) {});
    journal.add({{"kind", "action"}, {"method", "machine.on"}});
    EXPECT_FALSE(id.empty());
  }
  const Journal next(folder.path());
  EXPECT_EQ(next.id(), id);
  EXPECT_THAT(kinds(next.actions()), ::testing::ElementsAre("start", "action", "end"));
  for (const json& action : next.actions()) EXPECT_GT(action["at"], 1.7e9);
}

TEST(Journal, WhatNobodyBeginsLeavesNothingBehind) {
  const testing::TemporaryDirectory folder;
  {
    const Journal journal(folder.path());
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Journal, WhatCannotBeReadIsPutAside) {
  const testing::TemporaryDirectory folder;
  fs::create_directory(folder.path() / "journal.jsonl");
  std::atomic<int> faults{0};
  Journal journal(folder.path());
  journal.begin([] { return std::vector<json>{}; }, [&](const std::string&) { ++faults; });
  wait_for([&] { return fs::is_regular_file(folder.path() / "journal.jsonl"); });
  EXPECT_TRUE(fs::is_directory(folder.path() / "journal.jsonl.damaged"));
  EXPECT_EQ(faults, 0);
}

// Nothing that came meanwhile is lost when the disk takes it again.
TEST(Journal, ADiskThatTakesNothingIsToldOnceAndTriedAgain) {
  const testing::TemporaryDirectory parent;
  const fs::path folder = parent.path() / "state";
  {
    std::atomic<int> faults{0};
    std::atomic<int> looks{0};
    Journal journal(folder);
    journal.begin(
        [&] {
          ++looks;
          return std::vector<json>{};
        },
        [&](const std::string&) { ++faults; });
    wait_for([&] { return journal.fault().has_value(); });
    journal.add({{"kind", "action"}, {"method", "tool.set"}});
    const int seen = looks;
    wait_for([&] { return looks > seen + 3; });
    EXPECT_EQ(faults, 1);
    fs::create_directory(folder);
    wait_for([&] { return !journal.fault().has_value(); });
  }
  const Journal next(folder);
  EXPECT_THAT(kinds(next.actions()), ::testing::ElementsAre("start", "action", "end"));
}

// More than memory is kept for: what is remembered of it is there when the disk takes it again.
TEST(Journal, WhatADiskDidNotTakeForLongIsThereAsFarAsItIsRemembered) {
  const testing::TemporaryDirectory parent;
  const fs::path folder = parent.path() / "state";
  constexpr int records = 25'000;
  {
    Journal journal(folder);
    journal.begin([] { return std::vector<json>{}; }, [](const std::string&) {});
    for (int k = 0; k < records; ++k)
      journal.add({{"kind", "action"}, {"method", "n" + std::to_string(k)}});
    wait_for([&] { return journal.fault().has_value() && journal.actions().size() > 1; });
    journal.add({{"kind", "action"}, {"method", "last"}});
    wait_for([&] { return journal.actions().back()["method"] == "last"; });
    fs::create_directory(folder);
    wait_for([&] { return !journal.fault().has_value(); });
  }
  const Journal next(folder);
  const auto actions = next.actions();
  ASSERT_EQ(actions.size(), JournalContents::actions_max);
  EXPECT_EQ(actions[actions.size() - 2]["method"], "last");
  EXPECT_EQ(actions[actions.size() - 3]["method"], "n" + std::to_string(records - 1));
}

}  // namespace
}  // namespace stanok::daemon
