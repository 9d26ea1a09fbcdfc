// Who is let in, for how long, and what the server remembers of it.
#include "web/access/sessions.h"

#include <gtest/gtest.h>

#include "web/access/one_time_links.h"

namespace stanok::web {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Clock::time_point start{std::chrono::hours(1000)};

Identity identity(std::string name) {
  return {.name = std::move(name), .role = protocol::Role::observer, .password_hash = {}};
}

TEST(SecretText, IsAlwaysAnotherOneAndMayStandInAnAddress) {
  const std::string secret = new_secret();
  EXPECT_EQ(secret.size(), 43U);  // 256 bits, six a character
  EXPECT_EQ(secret.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                     "0123456789-_"),
            std::string::npos);
  EXPECT_NE(new_secret(), secret);
  EXPECT_EQ(hash_of(secret), hash_of(secret));
  EXPECT_NE(hash_of(secret), hash_of(secret + 'x'));
}

TEST(OneTimeLinks, OpenOnceAndForAnHour) {
  OneTimeLinks links;
  const std::string first = links.issue(start);
  const std::string second = links.issue(start);
  EXPECT_TRUE(links.use_up(first, start));
  EXPECT_FALSE(links.use_up(first, start));
  EXPECT_FALSE(links.use_up(second, start + OneTimeLinks::valid_for + std::chrono::seconds(1)));
}

TEST(OneTimeLinks, TheOldestIsForgottenFirst) {
  OneTimeLinks links;
  const std::string oldest = links.issue(start);
  std::string newest;
  for (std::size_t k = 0; k < OneTimeLinks::links_max; ++k) newest = links.issue(start);
  EXPECT_FALSE(links.use_up(oldest, start));
  EXPECT_TRUE(links.use_up(newest, start));
}

TEST(Sessions, EndWhenNobodyUsesThemAndAtACertainAge) {
  Sessions sessions;
  const std::string secret = sessions.begin(identity("anna"), start).secret;
  EXPECT_EQ(sessions.find(secret, start)->identity.name, "anna");
  EXPECT_FALSE(sessions.find(secret + 'x', start));
  auto now = start;
  while (now + Sessions::idle_max < start + Sessions::age_max) {
    now += Sessions::idle_max;
    EXPECT_TRUE(sessions.find(secret, now));
  }
  EXPECT_FALSE(sessions.find(secret, start + Sessions::age_max + std::chrono::seconds(1)));

  const std::string other = sessions.begin(identity("boris"), start).secret;
  EXPECT_FALSE(sessions.find(other, start + Sessions::idle_max + std::chrono::seconds(1)));
}

TEST(Sessions, AnOpenPageIsUse) {
  Sessions sessions;
  const std::string secret = sessions.begin(identity("anna"), start).secret;
  const std::uint64_t id = sessions.find(secret, start)->id;
  auto now = start;
  for (int k = 0; k < 3; ++k) {
    now += Sessions::idle_max - std::chrono::seconds(1);
    sessions.note_use({id}, now);
    EXPECT_TRUE(sessions.end_where([](const WebSession&) { return false; }, now).empty());
  }
  EXPECT_TRUE(sessions.find(secret, now));
}

TEST(Sessions, AreEndedByWhatTheyAreOf) {
  Sessions sessions;
  const std::string anna = sessions.begin(identity("anna"), start).secret;
  const std::string boris = sessions.begin(identity("boris"), start).secret;
  const auto ended = sessions.end_where(
      [](const WebSession& session) { return session.identity.name == "anna"; }, start);
  EXPECT_EQ(ended.size(), 1U);
  EXPECT_FALSE(sessions.find(anna, start));
  EXPECT_TRUE(sessions.find(boris, start));
}

TEST(Sessions, WhoHasBeenAwayLongestMakesRoom) {
  Sessions sessions;
  const std::string away = sessions.begin(identity("anna"), start).secret;
  const std::uint64_t away_id = sessions.find(away, start)->id;
  const std::string here = sessions.begin(identity("boris"), start).secret;
  std::optional<std::uint64_t> ended;
  auto now = start;
  for (std::size_t k = 2; k <= Sessions::sessions_max; ++k) {
    now += std::chrono::milliseconds(1);
    ASSERT_TRUE(sessions.find(here, now));
    ended = sessions.begin(identity("carl"), now).ended;
    EXPECT_EQ(ended.has_value(), k == Sessions::sessions_max);
  }
  EXPECT_EQ(ended, away_id) << "its pages are to be closed";
  EXPECT_FALSE(sessions.find(away, now));
  EXPECT_TRUE(sessions.find(here, now));
}

}  // namespace
}  // namespace stanok::web
