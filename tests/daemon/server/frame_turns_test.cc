// Whose request is answered next.
#include "daemon/server/frame_turns.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace stanok::daemon {
namespace {

using std::chrono::milliseconds;

constexpr auto nothing = [] {};

TEST(FrameTurns, WhoWorksComesBeforeThoseWhoLookOn) {
  FrameTurns turns;
  for (int k = 0; k < 160; ++k) turns.add(k % 10, Precedence::looks_on, nothing);
  turns.charge(turns.next()->session, milliseconds(40));
  turns.add(77, Precedence::works, nothing);
  EXPECT_EQ(turns.next()->session, 77);
}

TEST(FrameTurns, WhoLooksOnHasATurnBehindEightOfThoseWhoWork) {
  FrameTurns turns;
  for (int k = 0; k < 27; ++k) turns.add(1, Precedence::works, nothing);
  for (int k = 0; k < 3; ++k) turns.add(2, Precedence::looks_on, nothing);
  std::map<int, int> count;
  for (int k = 0; k < 27; ++k) ++count[turns.next()->session];
  EXPECT_EQ(count[2], 3);
}

TEST(FrameTurns, CountWhatAnswersCostAndNotTheirNumber) {
  FrameTurns turns;
  std::map<int, int> count;
  for (int k = 0; k < 100; ++k) {
    turns.add(1, Precedence::looks_on, nothing);
    turns.add(2, Precedence::looks_on, nothing);
  }
  for (int k = 0; k < 110; ++k) {
    const int session = turns.next()->session;
    ++count[session];
    turns.charge(session, milliseconds(session == 1 ? 10 : 1));
  }
  EXPECT_NEAR(count[2], 10 * count[1], 10);
}

TEST(FrameTurns, NobodySavesUpBySilence) {
  FrameTurns turns;
  turns.add(1, Precedence::looks_on, nothing);
  turns.charge(turns.next()->session, milliseconds(1000));
  turns.add(1, Precedence::looks_on, nothing);
  static_cast<void>(turns.next());
  for (int k = 0; k < 10; ++k) {
    turns.add(1, Precedence::looks_on, nothing);
    turns.add(2, Precedence::looks_on, nothing);
  }
  int of_newcomer = 0;
  for (int k = 0; k < 10; ++k) {
    const int session = turns.next()->session;
    of_newcomer += session == 2 ? 1 : 0;
    turns.charge(session, milliseconds(10));
  }
  EXPECT_EQ(of_newcomer, 5);
}

TEST(FrameTurns, RequestsOfOneSessionKeepTheirOrder) {
  FrameTurns turns;
  std::vector<int> done;
  for (int k = 0; k < 20; ++k)
    turns.add(k % 2, Precedence::works, [&done, k] { done.push_back(k); });
  while (turns.has_waiting()) {
    auto turn = turns.next();
    turn->task();
    turns.charge(turn->session, milliseconds(turn->session));
  }
  for (int session = 0; session < 2; ++session) {
    int before = -1;
    for (const int k : done) {
      if (k % 2 != session) continue;
      EXPECT_GT(k, before);
      before = k;
    }
  }
  EXPECT_FALSE(turns.next());
}

}  // namespace
}  // namespace stanok::daemon
