// SessionList: who has a place, and who makes room.
#include "daemon/server/session_list.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/connect_pair.hpp>
#include <vector>

namespace stanok::daemon {
namespace {

class SessionListTest : public ::testing::Test {
 protected:
  std::shared_ptr<Session> connect(protocol::Role role) {
    Session::Socket ours(io);
    clients.emplace_back(io);
    boost::asio::local::connect_pair(ours, clients.back());
    auto session = std::make_shared<Session>(std::move(ours), sessions.next_id());
    session->note_role(role);
    sessions.add(session);
    sessions.count_places();
    return session;
  }

  boost::asio::io_context io;
  std::vector<Session::Socket> clients;
  SessionList sessions;
};

TEST_F(SessionListTest, CountsThoseWhoHaveAPlace) {
  const auto first = connect(protocol::Role::machine_operator);
  const auto second = connect(protocol::Role::observer);
  EXPECT_EQ(sessions.places_taken(), 2U);
  second->turn_away("E9008", "there are too many clients", {});
  sessions.count_places();
  EXPECT_EQ(sessions.places_taken(), 1U);
  EXPECT_EQ(sessions.size(), 2U) << "it is still listened to";
  sessions.forget(second->id());
  EXPECT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions.all().front(), first);
}

TEST_F(SessionListTest, TheOldestObserverMakesRoom) {
  const auto machine_operator = connect(protocol::Role::machine_operator);
  EXPECT_FALSE(sessions.make_room()) << "an operator makes room for nobody";
  const auto older = connect(protocol::Role::observer);
  const auto younger = connect(protocol::Role::observer);
  EXPECT_TRUE(sessions.make_room());
  EXPECT_FALSE(older->has_place());
  EXPECT_TRUE(younger->has_place());
  EXPECT_TRUE(machine_operator->has_place());
}

TEST_F(SessionListTest, WhoWasTurnedAwayFirstGoesFirst) {
  const auto now = std::chrono::steady_clock::now();
  EXPECT_FALSE(sessions.end_oldest_turned_away(now));
  const auto stays = connect(protocol::Role::observer);
  const auto first = connect(protocol::Role::observer);
  const auto second = connect(protocol::Role::observer);
  second->turn_away("E9008", "there are too many clients", {});
  first->turn_away("E9008", "there are too many clients", {});
  std::vector<int> ended;
  for (const auto& session : sessions.all())
    session->start([](Session&, const protocol::TextFrame&) {},
                   [&](int id) {
                     ended.push_back(id);
                     sessions.forget(id);
                   });
  EXPECT_FALSE(sessions.end_oldest_turned_away(now)) << "it may be about to send a stop";
  EXPECT_TRUE(sessions.end_oldest_turned_away(now + std::chrono::seconds(1)));
  io.poll();
  EXPECT_EQ(ended, std::vector<int>{first->id()});
}

TEST_F(SessionListTest, IdsAreNeverGivenTwice) {
  const auto first = connect(protocol::Role::observer);
  sessions.forget(first->id());
  EXPECT_GT(connect(protocol::Role::observer)->id(), first->id());
}

}  // namespace
}  // namespace stanok::daemon
