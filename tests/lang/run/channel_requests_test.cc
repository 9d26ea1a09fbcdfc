// What instructions ask, and what is noted about the answer.
#include "lang/run/channel_requests.h"

#include "tests/lang/run/run_parts.h"

namespace stanok::lang::testing {
namespace {

class ChannelRequestsTest : public ::testing::Test, protected RunParts {
 protected:
  // The request of the first statement of `text`.
  ProgramRequest asked(const std::string& text) {
    load(text);
    EXPECT_TRUE(requests.execute(next_effect()));
    EXPECT_FALSE(run.failed()) << run.error().message;
    const Payload payload = emitted();
    const auto* const request = std::get_if<ProgramRequest>(&payload);
    EXPECT_NE(request, nullptr);
    return request != nullptr ? *request : ProgramRequest{};
  }

  ChannelRequests requests{vm, state, pending};
};

TEST_F(ChannelRequestsTest, AStatementWantsItsResultTrue) {
  const ProgramRequest request = asked("channel_stop (2);\n");
  EXPECT_EQ(request.channel, 2);
  EXPECT_TRUE(request.statement);
  Answer no;
  no.ok = false;
  EXPECT_TRUE(pending.take(no).refusal.has_value());
}

TEST_F(ChannelRequestsTest, AnExpressionTakesItsResultAsAValue) {
  EXPECT_FALSE(asked("bool good = channel_stop (2);\n").statement);
  Answer no;
  no.ok = false;
  const auto outcome = pending.take(no);
  EXPECT_FALSE(outcome.refusal.has_value());
  EXPECT_EQ(outcome.pushed->number, 0.0);
}

TEST_F(ChannelRequestsTest, TheOwnChannelIsRefusedWhereItCannotBeNamed) {
  load("num own = 1;\nchannel_stop (own);\n");
  EXPECT_TRUE(requests.execute(next_effect()));
  EXPECT_EQ(run.error().code, "E6031");
  EXPECT_TRUE(state.queue.empty());
}

TEST_F(ChannelRequestsTest, MarksTravelInTheQueueAndWaitsAreAsked) {
  EXPECT_EQ(asked("mark_wait (3, 2);\n").kind, RequestKind::mark_wait);
  load("mark_set (3);\n");
  EXPECT_TRUE(requests.execute(next_effect()));
  EXPECT_EQ(std::get<MarkCommand>(emitted()).id, 3);
}

TEST_F(ChannelRequestsTest, TheEndOfTheProgramIsToldBeforeItFails) {
  const ProgramRequest request = asked("terminate (1234, \"worn out\");\n");
  EXPECT_EQ(request.kind, RequestKind::terminate);
  EXPECT_EQ(request.number, 1234);
  EXPECT_EQ(pending.take({}).use, AnswerUse::fail_run);
  EXPECT_EQ(pending.end().code, "U1234");
  EXPECT_EQ(pending.end().message, "worn out");
}

TEST_F(ChannelRequestsTest, OtherInstructionsAreNotItsOwn) {
  load("M30\n");
  EXPECT_FALSE(requests.execute(next_effect()));
}

}  // namespace
}  // namespace stanok::lang::testing
