// How long who guesses waits, and for whom.
#include "web/access/login_delays.h"

#include <gtest/gtest.h>

#include <set>

#include "web/access/login_turns.h"

namespace stanok::web {
namespace {

using std::chrono::milliseconds;

constexpr LoginDelays::Time long_ago{std::chrono::hours(1)};

TEST(LoginDelays, DoubleWithEachFailureAndAreForgotten) {
  LoginDelays delays;
  const Claimant anna{"anna", "a"};
  for (const int wanted : {500, 1000, 2000, 4000, 8000, 16000, 16000, 16000}) {
    EXPECT_EQ(delays.note_failure(anna, long_ago), milliseconds(wanted));
    EXPECT_EQ(delays.next_try(anna, long_ago), long_ago + milliseconds(wanted));
  }
  EXPECT_EQ(delays.note_failure({"anna", "b"}, long_ago), milliseconds(500));
  const auto later = long_ago + LoginDelays::forgotten_after + std::chrono::seconds(1);
  EXPECT_EQ(delays.note_failure(anna, later), milliseconds(500));
  delays.note_success(anna);
  EXPECT_EQ(delays.next_try(anna, later), later);
  EXPECT_EQ(delays.note_failure(anna, later), milliseconds(500));
}

TEST(LoginDelays, OfOneNameAreNotThoseOfAnother) {
  LoginDelays delays;
  for (int k = 0; k < 5; ++k) EXPECT_GT(delays.note_failure({"anna", "a"}, long_ago).count(), 0);
  EXPECT_EQ(delays.next_try({"olga", "a"}, long_ago), long_ago);
  delays.note_success({"olga", "a"});
  EXPECT_EQ(delays.note_failure({"anna", "a"}, long_ago), milliseconds(16000));
}

TEST(LoginDelays, AreBoundedInNumber) {
  LoginDelays delays;
  for (std::size_t k = 0; k <= LoginDelays::claimants_max; ++k) {
    const auto now = long_ago + milliseconds(k);
    static_cast<void>(delays.note_failure({std::to_string(k), "a"}, now));
  }
  const auto now = long_ago + std::chrono::seconds(5);
  EXPECT_EQ(delays.next_try({"0", "a"}, now), now) << "failed longest ago";
  EXPECT_NE(delays.next_try({"1", "a"}, now), now);
}

TEST(LoginTurns, OneIsComparedAtATimeAndOfOneNameFromOnePlaceOneWaits) {
  LoginTurns turns;
  const Claimant anna{"anna", "a"};
  const auto first = turns.enter(anna);
  ASSERT_TRUE(first);
  EXPECT_FALSE(turns.enter(anna));
  const auto second = turns.enter({"boris", "a"});
  ASSERT_TRUE(second);
  EXPECT_EQ(turns.next(), first->ticket);
  EXPECT_EQ(turns.next(), std::nullopt) << "anna is being compared";
  EXPECT_FALSE(turns.enter(anna));
  turns.leave();
  EXPECT_TRUE(turns.enter(anna));
  EXPECT_EQ(turns.next(), second->ticket);
}

TEST(LoginTurns, WhoComesFromAnotherPlaceWaitsForOneOfEachPlaceAtMost) {
  LoginTurns turns;
  constexpr int places = 10;
  for (int k = 0; k < 100; ++k)
    ASSERT_TRUE(turns.enter({"guess " + std::to_string(k), "place " + std::to_string(k % places)}));
  const auto anna = turns.enter({"anna", "office"});
  ASSERT_TRUE(anna);
  int before = 0;
  while (turns.next() != anna->ticket) {
    turns.leave();
    ++before;
  }
  EXPECT_LE(before, places);
}

TEST(LoginTurns, WhereTooManyWaitTheFullestPlaceMakesRoom) {
  LoginTurns turns;
  LoginTurns::Ticket newest = 0;
  for (std::size_t k = 0; k < LoginTurns::waiting_max; ++k) {
    const auto entered = turns.enter({std::to_string(k), "tunnel"});
    ASSERT_TRUE(entered);
    EXPECT_FALSE(entered->pushed_out);
    newest = entered->ticket;
  }
  const auto anna = turns.enter({"anna", "office"});
  ASSERT_TRUE(anna);
  EXPECT_EQ(anna->pushed_out, newest);
  const auto one_more = turns.enter({"one more", "tunnel"});
  ASSERT_TRUE(one_more);
  EXPECT_EQ(one_more->pushed_out, one_more->ticket);
}

}  // namespace
}  // namespace stanok::web
