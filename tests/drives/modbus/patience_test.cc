// How soon a partner on the bus is asked again.
#include "drives/modbus/patience.h"

#include <gtest/gtest.h>

namespace stanok::drives {
namespace {

using std::chrono::milliseconds;

TEST(Patience, APartnerThatIsNotKnownHasAThirdOfTheTimeout) {
  const Patience patience(milliseconds{250});
  EXPECT_GT(patience.for_next_answer(), milliseconds{83});
  EXPECT_LT(patience.for_next_answer(), milliseconds{84});
}

TEST(Patience, AQuickPartnerIsAskedAgainSoon) {
  Patience patience(milliseconds{250});
  patience.note_answer(milliseconds{1});
  EXPECT_EQ(patience.for_next_answer(), std::chrono::microseconds{6250});
}

TEST(Patience, ASlowPartnerHasThreeTimesItsSlowestAnswer) {
  Patience patience(milliseconds{250});
  patience.note_answer(milliseconds{20});
  for (int i = 0; i < 5; ++i) patience.note_answer(milliseconds{1});
  EXPECT_GT(patience.for_next_answer(), milliseconds{50});
  EXPECT_LE(patience.for_next_answer(), milliseconds{60});
  for (int i = 0; i < 1000; ++i) patience.note_answer(milliseconds{1});
  EXPECT_EQ(patience.for_next_answer(), std::chrono::microseconds{6250});
}

// In silence the longer tries take most of the time.
TEST(Patience, ManyTriesFitIntoATimeout) {
  Patience patience(milliseconds{250});
  patience.note_answer(milliseconds{1});
  std::chrono::nanoseconds spent{0};
  int tries = 0;
  std::chrono::nanoseconds longest{0};
  while (spent < milliseconds{250}) {
    longest = std::max(longest, patience.for_next_answer());
    spent += patience.for_next_answer();
    patience.note_silence();
    ++tries;
  }
  EXPECT_GE(tries, 20);
  EXPECT_GT(longest, milliseconds{31}) << "a partner that became slow is heard again";
}

}  // namespace
}  // namespace stanok::drives
