// Sessions behind their file, on a clock that is set meanwhile.
#include "web/access/session_file.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"
#include "web/access/private_file.h"

namespace stanok::web {
namespace {

using std::chrono::hours;
using std::chrono::steady_clock;
using std::chrono::system_clock;

constexpr steady_clock::time_point begun_at{hours(1000)};
constexpr system_clock::time_point wall{hours(500000)};

class SessionFile : public ::testing::Test {
 protected:
  void write(const Sessions& sessions) {
    write_private_file(file_, text_of(sessions.kept(begun_at, wall)));
  }
  // In a process whose steady clock begins elsewhere.
  Sessions read(system_clock::time_point wall_now) {
    Sessions sessions;
    sessions.restore(sessions_from_file(file_), other_start, wall_now);
    return sessions;
  }

  static constexpr steady_clock::time_point other_start{hours(1)};
  testing::TemporaryDirectory folder_;
  std::filesystem::path file_ = folder_.path() / "sessions";
};

TEST_F(SessionFile, BringsBackWhoWasLetIn) {
  Sessions sessions;
  const Identity anna{
      .name = "Анна \"A\"", .role = protocol::Role::programmer, .password_hash = "$a"};
  const std::string secret = sessions.begin(anna, begun_at).secret;
  write(sessions);
  const auto found = read(wall).find(secret, other_start);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->identity.name, anna.name);
  EXPECT_EQ(found->identity.role, anna.role);
  EXPECT_EQ(found->identity.password_hash, anna.password_hash);
}

TEST_F(SessionFile, KeepsTheTimeThatIsLeft) {
  Sessions sessions;
  const std::string secret =
      sessions
          .begin({.name = "anna", .role = protocol::Role::observer, .password_hash = {}},
                 begun_at - hours(5))
          .secret;
  write(sessions);
  const auto left = Sessions::idle_max - hours(5);
  EXPECT_TRUE(read(wall).find(secret, other_start + left - hours(1)));
  EXPECT_FALSE(read(wall).find(secret, other_start + left + hours(1)));
  EXPECT_FALSE(read(wall + left + hours(1)).find(secret, other_start));
}

// No session lives longer than `age_max` behind a start, whatever the clock said.
TEST_F(SessionFile, AClockThatWasSetBackMakesNoSessionYoungerThanNew) {
  Sessions sessions;
  const std::string secret =
      sessions
          .begin({.name = "anna", .role = protocol::Role::observer, .password_hash = {}}, begun_at)
          .secret;
  write(sessions);
  EXPECT_TRUE(read(wall - hours(10000)).find(secret, other_start));
  EXPECT_FALSE(read(wall - hours(10000)).find(secret, other_start + Sessions::idle_max + hours(1)));
}

}  // namespace
}  // namespace stanok::web
