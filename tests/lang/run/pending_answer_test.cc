// What becomes of an answer: nothing is executed here.
#include "lang/run/pending_answer.h"

#include <gtest/gtest.h>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

Answer refused(std::string text) {
  Answer answer;
  answer.ok = false;
  answer.text = std::move(text);
  return answer;
}

Answer number(double value) {
  Answer answer;
  answer.number = value;
  return answer;
}

TEST(PendingAnswer, IsOwedFromTheDeliveryToTheAnswer) {
  PendingAnswer pending;
  EXPECT_FALSE(pending.accept()) << "an answer that nobody waits for";
  pending.deliver({});
  EXPECT_TRUE(pending.owed());
  EXPECT_TRUE(pending.accept());
  EXPECT_FALSE(pending.accept());
}

TEST(PendingAnswer, AUseHoldsForOneAnswer) {
  PendingAnswer pending;
  pending.expect(AnswerUse::push_truth);
  EXPECT_EQ(pending.take({}).pushed->number, 1.0);
  EXPECT_FALSE(pending.take({}).pushed.has_value());
}

TEST(PendingAnswer, BlocksSayByTheirRequestWhatTheAnswerIsFor) {
  PendingAnswer pending;
  ProgramRequest request;
  request.kind = RequestKind::input_wait;
  pending.deliver(request);
  EXPECT_EQ(pending.take({}).use, AnswerUse::input_result);
  request.kind = RequestKind::probe_result;
  pending.deliver(request);
  EXPECT_EQ(pending.take({}).use, AnswerUse::probe);
  request.statement = true;
  pending.deliver(request);
  EXPECT_EQ(pending.take({}).use, AnswerUse::probe_or_alarm);
}

TEST(PendingAnswer, NumbersAreGivenInTheirUnit) {
  PendingAnswer pending;
  pending.expect_number(25.4);
  EXPECT_EQ(pending.take(number(50.8)).pushed->number, 2.0);
}

// A length that was refused in inches must not divide the next number.
TEST(PendingAnswer, TheUnitOfARefusedNumberIsForgotten) {
  PendingAnswer pending;
  pending.expect_number(25.4);
  EXPECT_TRUE(pending.take(refused("no such page")).refusal.has_value());
  pending.reset();
  pending.expect_number(1.0);
  EXPECT_EQ(pending.take(number(50.8)).pushed->number, 50.8);
}

TEST(PendingAnswer, ARefusalHasTheCodeOfItsReasonAndItsNotes) {
  PendingAnswer pending;
  const auto outcome = pending.take(refused("E7001 file not found: a.nc\nlooked in /x\nand in /y"));
  ASSERT_TRUE(outcome.refusal.has_value());
  EXPECT_EQ(outcome.refusal->code, "E7001");
  EXPECT_EQ(outcome.refusal->message, "file not found: a.nc");
  ASSERT_EQ(outcome.refusal->notes.size(), 2u);
  EXPECT_EQ(outcome.refusal->notes[1].text, "and in /y");
  EXPECT_EQ(pending.take(refused("")).refusal->code, "E5010");
}

TEST(PendingAnswer, AFalseResultOfAStatementIsNotLost) {
  PendingAnswer pending;
  pending.expect_statement({"E6034", "channel_load"});
  const auto outcome = pending.take(refused("it is running"));
  EXPECT_EQ(outcome.pushed->number, 0.0);
  ASSERT_TRUE(outcome.refusal.has_value());
  EXPECT_EQ(outcome.refusal->code, "E6034");
  EXPECT_EQ(pending.channel_error(), "it is running");
}

TEST(PendingAnswer, ACallThatWasAnErrorEndsTheRunWhateverItsForm) {
  PendingAnswer pending;
  pending.expect(AnswerUse::push_truth);
  Answer answer = refused("E6032 not now");
  answer.raises = true;
  const auto outcome = pending.take(answer);
  EXPECT_FALSE(outcome.pushed.has_value());
  EXPECT_EQ(outcome.refusal->code, "E6032");
}

TEST(PendingAnswer, KeepsWhatIsToBeDoneWithTheAnswer) {
  PendingAnswer pending;
  ToolOverhang overhang;
  overhang.value_mm = 35.0;
  pending.expect_overhang(overhang);
  EXPECT_EQ(pending.take({}).use, AnswerUse::overhang);
  EXPECT_EQ(pending.overhang().value_mm, 35.0);
  pending.expect_restoring({{}, true});
  EXPECT_EQ(pending.take({}).use, AnswerUse::restore_state);
  EXPECT_TRUE(pending.restoring().is_statement);
}

class RefusedTable : public ProgramTest {};

// The same in two runs of one interpreter.
TEST_F(RefusedTable, InInchesLeavesTheNumbersOfTheNextProgramAlone) {
  answering = [](const ProgramRequest& request) {
    Answer answer = number(50.8);
    answer.ok = request.kind != RequestKind::offset_table_read;
    return answer;
  };
  run("G20\nnum zero = gettable_zs (1, 1, X);\nM30\n");
  EXPECT_EQ(error.code, "E6032");
  files.texts["next.nc"] =
      "num feed = $ovr_feed;\nif (feed == 50.8) { msg (\"the same\"); }\nM30\n";
  const auto next = compile("next.nc", files, &channel, warnings);
  ASSERT_TRUE(next);
  error = {};
  interpreter->start(*next, start_B);
  drain();
  EXPECT_EQ(error.code, "");
  ASSERT_EQ(all<Message>().size(), 1u);
  EXPECT_EQ(all<Message>()[0].text, "the same");
}

}  // namespace
}  // namespace stanok::lang::testing
