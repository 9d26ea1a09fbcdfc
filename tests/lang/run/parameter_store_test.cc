// The parameters of a run alone: numbers, names, R, and what calls exchange.
#include "lang/run/parameter_store.h"

#include <gtest/gtest.h>

#include "lang/run/block_state.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

struct FixedPlace : RunPlace {
  [[nodiscard]] WhereItRuns where() const override { return {{0, 17}, 2, {}}; }
};

std::shared_ptr<Program> program_with(const std::vector<std::string>& names) {
  auto program = std::make_shared<Program>();
  for (const std::string& name : names) program->named_parameters.add(name);
  return program;
}

class ParameterStoreTest : public ::testing::Test {
 protected:
  double number(double which) { return store.numbered(which, fault).value_or(-1.0); }

  const ChannelDescription channel = mill_xyzbc();
  MemoryTables tables;
  BlockState state{channel, tables};
  FixedPlace place;
  ParameterStore store{state.around, place};
  ValueFault fault;
};

TEST_F(ParameterStoreTest, NumbersBeginAsZeroInEachRun) {
  store.begin(program_with({}));
  EXPECT_TRUE(store.set_numbered(31.0, 4.5, fault));
  EXPECT_EQ(number(31.0), 4.5);
  store.begin(program_with({}));
  EXPECT_EQ(number(31.0), 0.0);
}

TEST_F(ParameterStoreTest, GlobalNamesAndRParametersLastFromRunToRun) {
  store.begin(program_with({"own", "_global"}));
  store.set_named(0, 1.0);
  store.set_named(1, 2.0);
  store.set_r_parameter(7, 3.0);
  store.begin(program_with({"other", "_global", "own"}));
  EXPECT_EQ(store.named("_global", fault), 2.0);
  EXPECT_EQ(store.r_parameter(7), 3.0);
  EXPECT_EQ(store.named("own", fault), std::nullopt);
  EXPECT_EQ(fault.code, "E3014");
}

TEST_F(ParameterStoreTest, ACallHasLocalsOfItsOwnAndGivesThemBack) {
  store.begin(program_with({"own", "_global"}));
  EXPECT_TRUE(store.set_numbered(1.0, 10.0, fault));
  EXPECT_TRUE(store.set_numbered(31.0, 11.0, fault));
  store.set_named(0, 12.0);
  store.set_named(1, 13.0);
  LocalParameters of_caller = store.exchange_locals(store.fresh_locals({}));
  EXPECT_EQ(number(1.0), 0.0);
  EXPECT_EQ(number(31.0), 11.0);
  EXPECT_FALSE(store.is_set(0));
  EXPECT_EQ(store.named("_global", fault), 13.0);
  store.exchange_locals(std::move(of_caller));
  EXPECT_EQ(number(1.0), 10.0);
  EXPECT_EQ(store.named("own", fault), 12.0);
}

TEST_F(ParameterStoreTest, WhatShowsTheRunIsReadFromItsPlace) {
  store.begin(program_with({}));
  EXPECT_EQ(store.named("_line", fault), 17.0);
  EXPECT_EQ(store.named("_call_level", fault), 2.0);
  EXPECT_EQ(store.named("_value_returned", fault), 0.0);
  store.set_returned_value(5.0);
  EXPECT_EQ(store.named("_value", fault), 5.0);
  EXPECT_EQ(store.named("_value_returned", fault), 1.0);
}

TEST_F(ParameterStoreTest, RefusesNumbersThatAreNoneOrShowTheMachine) {
  store.begin(program_with({}));
  EXPECT_EQ(store.numbered(1.5, fault), std::nullopt);
  EXPECT_EQ(fault.code, "E3010");
  EXPECT_EQ(store.numbered(5603.0, fault), std::nullopt);
  EXPECT_EQ(fault.code, "E3015");
  EXPECT_FALSE(store.set_numbered(5420.0, 1.0, fault)) << "the position";
  EXPECT_EQ(fault.code, "E3013");
  store.set_input_result(-1.0);
  EXPECT_EQ(number(5399.0), -1.0);
}

}  // namespace
}  // namespace stanok::lang::testing
