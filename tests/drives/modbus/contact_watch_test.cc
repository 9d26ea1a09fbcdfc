// ContactWatch: when contact with a drive ends and when it is back.
#include "drives/modbus/contact_watch.h"

#include <gtest/gtest.h>

namespace stanok::drives {
namespace {

using std::chrono::milliseconds;

constexpr BusTime watched_poll = milliseconds{10};
constexpr BusTime watched_timeout = milliseconds{250};

TEST(ContactWatch, ContactEndsWhenNobodyAnswersForLongerThanTheTimeOut) {
  ContactWatch contact(watched_poll, watched_timeout);
  contact.note_answer(milliseconds{100});
  EXPECT_FALSE(contact.is_exhausted(milliseconds{350}));
  EXPECT_TRUE(contact.is_exhausted(milliseconds{351}));
  EXPECT_FALSE(contact.is_lost()) << "who watches decides";
}

// 3 for each bad exchange, 1 back for each good one, up to 200: 50 of each come to 100, 100 to 200.
TEST(ContactWatch, ContactEndsWhenHalfOfTheExchangesFail) {
  ContactWatch contact(watched_poll, watched_timeout);
  int pairs = 0;
  while (!contact.is_exhausted(BusTime{0}) && pairs < 1000) {
    contact.note_failure(ExchangeError::timeout);
    if (!contact.is_exhausted(BusTime{0})) contact.note_answer(BusTime{0});
    ++pairs;
  }
  EXPECT_EQ(pairs, 100);
  EXPECT_EQ(contact.error_count(), 100U);
  EXPECT_EQ(contact.errors()[ExchangeError::timeout], 100U);
}

// One and a half time-outs are 37.5 polls: 375 / 10, cut off.
TEST(ContactWatch, ContactIsBackAfterTheAnswersOfOneAndAHalfTimeOuts) {
  ContactWatch contact(watched_poll, watched_timeout);
  contact.lose();
  int answers = 0;
  while (contact.is_lost() && answers < 1000) {
    contact.note_answer(BusTime{0});
    ++answers;
  }
  EXPECT_EQ(answers, 37);
}

TEST(ContactWatch, KnowsWhetherItAnsweredTheLastTime) {
  ContactWatch contact(watched_poll, watched_timeout);
  EXPECT_TRUE(contact.is_answering());
  contact.note_failure(ExchangeError::mangled);
  EXPECT_FALSE(contact.is_answering());
  contact.note_answer(milliseconds{20});
  EXPECT_TRUE(contact.is_answering());
  EXPECT_EQ(contact.answered_at(), milliseconds{20});
}

}  // namespace
}  // namespace stanok::drives
