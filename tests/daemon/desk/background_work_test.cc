// Work for clients in a thread of its own: answered in `tick`, cancelled, bounded, and its faults.
#include "daemon/desk/background_work.h"

#include <gtest/gtest.h>

#include <latch>
#include <stdexcept>

#include "tests/support/no_allocation.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

struct Asked {
  std::vector<CommandResult> answers;
  [[nodiscard]] Answer taker() {
    return [this](const CommandResult& answer) { answers.push_back(answer); };
  }
  void wait_for(BackgroundWork& work, std::size_t count) const {
    while (answers.size() < count) {
      work.tick();
      std::this_thread::yield();
    }
  }
};

TEST(BackgroundWork, AnswersInTheOrderOfAsking) {
  BackgroundWork work(BackgroundWork::Urgency::usual);
  Asked asked;
  for (int k = 0; k < 5; ++k)
    work.submit(1, [k](const std::stop_token&) -> CommandResult { return json(k); }, asked.taker());
  asked.wait_for(work, 5);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(*asked.answers[static_cast<std::size_t>(k)], json(k));
}

TEST(BackgroundWork, AFaultCostsItsAnswerOnly) {
  BackgroundWork work(BackgroundWork::Urgency::batch);
  Asked asked;
  work.submit(
      1, [](const std::stop_token&) -> CommandResult { throw std::runtime_error("broken"); },
      asked.taker());
  work.submit(1, [](const std::stop_token&) -> CommandResult { return json(1); }, asked.taker());
  asked.wait_for(work, 2);
  EXPECT_EQ(asked.answers[0].error().message, "broken");
  EXPECT_TRUE(asked.answers[1]);
}

// Of everything that the thread does, nothing needs memory but the work.
TEST(BackgroundWork, WhereMemoryEndsTheAnswerSaysSo) {
  BackgroundWork work(BackgroundWork::Urgency::usual);
  Asked asked;
  asked.answers.reserve(3);
  const auto takes_memory = [](const std::stop_token&) -> CommandResult {
    return json(std::string(1000, 'x'));
  };
  const std::runtime_error fault("a fault with a text that is too long for any place");
  const auto fails_at_length = [&](const std::stop_token&) -> CommandResult { throw fault; };
  const auto takes_none = [](const std::stop_token&) -> CommandResult { return json(7); };
  {
    const stanok::testing::NoMemoryElsewhere short_of_memory;
    work.submit(1, takes_memory, asked.taker());
    work.submit(1, fails_at_length, asked.taker());
    work.submit(1, takes_none, asked.taker());
    asked.wait_for(work, 3);
  }
  EXPECT_EQ(asked.answers[0].error().message, "out of memory");
  EXPECT_EQ(asked.answers[1].error().message, "out of memory");
  EXPECT_EQ(*asked.answers[2], json(7));
}

TEST(BackgroundWork, WhatIsCancelledIsAnswered) {
  BackgroundWork work(BackgroundWork::Urgency::usual);
  Asked asked;
  std::latch begun(1);
  work.submit(
      1,
      [&begun](const std::stop_token& stop) -> CommandResult {
        begun.count_down();
        while (!stop.stop_requested()) std::this_thread::yield();
        return json();
      },
      asked.taker());
  work.submit(1, [](const std::stop_token&) -> CommandResult { return json(); }, asked.taker());
  begun.wait();
  work.cancel(2);
  work.cancel(1);
  asked.wait_for(work, 2);
  for (const CommandResult& answer : asked.answers) EXPECT_EQ(answer.error().code, "E9017");
}

TEST(BackgroundWork, RefusesWhoAsksForTooMuchAndEndsWithWorkUnderWay) {
  BackgroundWork work(BackgroundWork::Urgency::usual);
  Asked asked;
  std::latch begun(1);
  work.submit(
      1,
      [&begun](const std::stop_token& stop) -> CommandResult {
        begun.count_down();
        while (!stop.stop_requested()) std::this_thread::yield();
        return json();
      },
      asked.taker());
  begun.wait();
  const auto nothing = [](const std::stop_token&) -> CommandResult { return json(); };
  for (int k = 0; k < BackgroundWork::of_session_max; ++k) work.submit(1, nothing, asked.taker());
  EXPECT_TRUE(asked.answers.empty());
  work.submit(1, nothing, asked.taker());
  ASSERT_EQ(asked.answers.size(), 1U);
  EXPECT_EQ(asked.answers[0].error().code, "E9007");
}

}  // namespace
}  // namespace stanok::daemon
