// Subscriptions: a snapshot, then patches that lead from one to the next.
#include "daemon/desk/subscription.h"

#include <gtest/gtest.h>

#include <random>

namespace stanok::daemon {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

const Subscription::Time begin = Subscription::Time{} + 1h;

TEST(Subscription, SendsEverythingFirstAndChangesAfterwards) {
  Subscription subscription(json::array({"channels"}), 10.0, 0);
  const auto first = subscription.status({{"a", 1}, {"b", {{"c", 2}, {"d", 3}}}}, begin);
  ASSERT_TRUE(first);
  EXPECT_EQ((*first)["full"], true);
  EXPECT_EQ((*first)["seq"], 1);
  const auto second = subscription.status({{"a", 1}, {"b", {{"c", 5}, {"d", 3}}}}, begin + 1s);
  ASSERT_TRUE(second);
  EXPECT_EQ((*second)["full"], false);
  EXPECT_EQ((*second)["seq"], 2);
  EXPECT_EQ((*second)["state"], json::parse(R"({"b":{"c":5}})"));
}

TEST(Subscription, IsSilentWhileNothingChanges) {
  Subscription subscription(json::array({"machine"}), 10.0, 0);
  ASSERT_TRUE(subscription.status({{"a", 1}}, begin));
  EXPECT_FALSE(subscription.status({{"a", 1}}, begin + 1s));
}

TEST(Subscription, KeepsItsRate) {
  Subscription subscription(json::array({"drives"}), 4.0, 0);
  EXPECT_TRUE(subscription.is_due(begin));
  static_cast<void>(subscription.status({{"a", 1}}, begin));
  EXPECT_FALSE(subscription.is_due(begin + 249ms));
  EXPECT_TRUE(subscription.is_due(begin + 250ms));
}

TEST(Subscription, OfEventsOnlyHasNoStatus) {
  const Subscription subscription(json::array({"events"}), 10.0, 0);
  EXPECT_TRUE(subscription.wants("events"));
  EXPECT_FALSE(subscription.is_due(begin));
  EXPECT_FALSE(Subscription().is_due(begin));
}

json random_object(std::mt19937& random, int depth) {
  json object = json::object();
  for (auto members = random() % 5; members > 0; --members) {
    const std::string name(1, static_cast<char>('a' + random() % 6));
    if (depth > 0 && random() % 3 == 0) {
      object[name] = random_object(random, depth - 1);
    } else {
      object[name] = random() % 4;
    }
  }
  return object;
}

// Property: a client that applies the patches (RFC 7396) always has the state of the server.
TEST(MergePatch, LeadsFromAnyStateToAnyOther) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    std::mt19937 random(seed);
    json state = random_object(random, 3);
    const json wanted = random_object(random, 3);
    state.merge_patch(merge_patch_between(state, wanted));
    EXPECT_EQ(state, wanted) << "seed " << seed;
  }
}

}  // namespace
}  // namespace stanok::daemon
