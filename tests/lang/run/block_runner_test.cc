// Blocks into commands, alone: plain lines are put before the runner, nobody calls or jumps.
#include "lang/run/block_runner.h"

#include <gtest/gtest.h>

#include "lang/run/value_instructions.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class BlockRunnerTest : public ::testing::Test {
 protected:
  // A run that stands before the first line of `text`.
  void load(const std::string& text) {
    auto program = std::make_shared<Program>();
    program->files.push_back(std::make_unique<CompiledFile>(source_of("main.nc", text)));
    CompiledFile& file = *program->files.front();
    file.code.push_back({Op::end_of_text, 0, 0, 0});
    file.spans.push_back({0, 0, 1});
    parameters.begin(program);
    vm.begin(program);
    const Source& source = vm.file().source;
    const char* const first = source.text().data();
    vm.plain() = {first, first + source.end(), 1, {}};
    blocks.reset();
    blocks.begin({});
    run.begin();
  }

  const ChannelDescription channel = mill_xyzbc();
  MemoryTables tables;
  BlockState state{channel, tables};
  RunStage run{state.queue};
  Vm vm{state.channel_words, run};
  ParameterStore parameters{state.around, vm};
  BlockRunner blocks{state, vm, run, parameters};
  Command command;
};

using LineResult = BlockRunner::LineResult;

TEST_F(BlockRunnerTest, AMoveIsMadeWithoutTheQueue) {
  load("G0 X12.5\n");
  ASSERT_EQ(blocks.take_line(command), LineResult::command);
  EXPECT_EQ(std::get<Move>(command.payload).end[0], 12.5);
  EXPECT_EQ(command.origin.line, 1u);
  EXPECT_EQ(state.blocks, 1u);
  EXPECT_TRUE(state.queue.empty());
}

TEST_F(BlockRunnerTest, WhatABlockDoesToTheProgramIsOnlySaid) {
  load("M98 P7\n");
  ASSERT_EQ(blocks.take_line(command), LineResult::block);
  blocks.begin_block();
  const BlockFlow flow = blocks.execute();
  EXPECT_EQ(flow.kind, Flow::call_numbered);
  EXPECT_EQ(flow.code, m(98));
  EXPECT_EQ(vm.frames().size(), 1u);
}

TEST_F(BlockRunnerTest, ALineOfSettingsMakesNoBlock) {
  load("#31=2.5\nG0 X#31\n");
  EXPECT_EQ(blocks.take_line(command), LineResult::nothing);
  EXPECT_EQ(state.blocks, 0u);
  ASSERT_EQ(blocks.take_line(command), LineResult::command);
  EXPECT_EQ(std::get<Move>(command.payload).end[0], 2.5);
}

TEST_F(BlockRunnerTest, AFaultNamesTheWordAndTheBlockCanBePassed) {
  load("G1 X10\n");
  ASSERT_EQ(blocks.take_line(command), LineResult::block);
  blocks.begin_block();
  EXPECT_EQ(blocks.execute().kind, Flow::next);
  ASSERT_TRUE(run.failed());
  EXPECT_EQ(run.error().code, "E4020") << "no feed";
  EXPECT_EQ(run.error().place.line, 1u);
  EXPECT_EQ(blocks.pass_fault(), Passed::known_position);
  EXPECT_TRUE(run.running());
  EXPECT_EQ(state.modal.position_W[0], 10.0);
  EXPECT_TRUE(state.modal.feed.known) << "asked for once";
}

TEST_F(BlockRunnerTest, CompensationStandsBetweenBlocksAndDelivery) {
  load("G41.1 D6 G1 X10 F100\n");
  EXPECT_FALSE(blocks.compensating());
  ASSERT_EQ(blocks.take_line(command), LineResult::block);
  blocks.begin_block();
  static_cast<void>(blocks.execute());
  EXPECT_FALSE(run.failed()) << run.error().message;
  EXPECT_TRUE(blocks.compensating());
}

TEST_F(BlockRunnerTest, WhatTheProbeFoundIsInProgrammedCoordinates) {
  load("\n");
  tables.offsets[1] = {1.0, 2.0, 3.0};
  blocks.begin({});
  Answer answer;
  answer.probe_B = {11.0, 12.0, 13.0};
  blocks.take_probe_answer(answer);
  EXPECT_TRUE(state.probe.found);
  EXPECT_EQ(state.probe.position[2], 10.0);
}

TEST_F(BlockRunnerTest, SystemValuesAreReadFromItsState) {
  load("G0 X3\n");
  ASSERT_EQ(blocks.take_line(command), LineResult::command);
  ValueFault fault;
  EXPECT_EQ(system_value(state, "prog_pos", 0.0, fault), 3.0);
  EXPECT_EQ(system_value(state, "g", 1.0, fault), 0.0);
  EXPECT_EQ(system_value(state, "g", 99.0, fault), std::nullopt);
  EXPECT_EQ(fault.code, "E3011");
}

}  // namespace
}  // namespace stanok::lang::testing
