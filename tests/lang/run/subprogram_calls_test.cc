// Calls and returns on a machine alone: no block is executed.
#include "lang/run/subprogram_calls.h"

#include "tests/lang/run/run_parts.h"

namespace stanok::lang::testing {
namespace {

class SubprogramCallsTest : public ::testing::Test, protected RunParts {
 protected:
  SubprogramCalls calls{vm, state, parameters};
};

TEST_F(SubprogramCallsTest, AFunctionTakesItsArgumentsAndLeavesItsResult) {
  load("num twice (num value) { return value + value; }\nnum four = twice (2);\n");
  ASSERT_TRUE(calls.execute(next_effect()));
  EXPECT_EQ(vm.where().call_level, 1);
  ASSERT_TRUE(calls.execute(next_effect()));
  EXPECT_EQ(vm.where().call_level, 0);
  EXPECT_EQ(vm.stack().top().number, 4.0);
}

TEST_F(SubprogramCallsTest, AnOSubprogramHasLocalsOfItsOwn) {
  load("O100 sub\nO100 endsub [7]\nO100 call [5]\n");
  ValueFault fault;
  ASSERT_TRUE(parameters.set_numbered(1.0, 99.0, fault));
  ASSERT_TRUE(calls.execute(next_effect()));
  EXPECT_EQ(parameters.numbered(1.0, fault), 5.0);
  ASSERT_TRUE(calls.execute(next_effect()));
  EXPECT_EQ(parameters.numbered(1.0, fault), 99.0);
  EXPECT_EQ(parameters.named("_value", fault), 7.0);
}

TEST_F(SubprogramCallsTest, RepeatsRunFromTheEntryAgain) {
  load("M98 P200 L2\nM30\nO200\nM99\n");
  state.words = {};
  state.words.letters = letter_bit('P') | letter_bit('L');
  state.words.values['P'] = 200.0;
  state.words.values['L'] = 2.0;
  calls.call_numbered(m(98));
  ASSERT_FALSE(run.failed()) << run.error().message;
  EXPECT_EQ(vm.where().call_level, 1);
  EXPECT_EQ(calls.leave_subprogram(), SubprogramCalls::Left::subprogram);
  EXPECT_EQ(vm.where().call_level, 1);
  EXPECT_EQ(vm.frame().position, vm.frame().entry);
  EXPECT_EQ(calls.leave_subprogram(), SubprogramCalls::Left::subprogram);
  EXPECT_EQ(vm.where().call_level, 0);
  EXPECT_EQ(calls.leave_subprogram(), SubprogramCalls::Left::main_program);
}

TEST_F(SubprogramCallsTest, ACallIntoNothingFailsTheRun) {
  load("M30\n");
  state.words = {};
  state.words.letters = letter_bit('P');
  state.words.values['P'] = 300.0;
  calls.call_numbered(m(98));
  EXPECT_EQ(run.error().code, "E7005");
}

TEST_F(SubprogramCallsTest, AnArgumentOutsideAMacroIsAFault) {
  load("num depth = arg (\"X\");\n");
  ASSERT_TRUE(calls.execute(next_effect()));
  EXPECT_EQ(run.error().code, "E3019");
}

}  // namespace
}  // namespace stanok::lang::testing
