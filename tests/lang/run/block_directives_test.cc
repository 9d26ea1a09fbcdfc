// Directives alone: what they emit, and what they keep for an answer.
#include "lang/run/block_directives.h"

#include "tests/lang/run/run_parts.h"

namespace stanok::lang::testing {
namespace {

class BlockDirectivesTest : public ::testing::Test, protected RunParts {
 protected:
  void execute(const std::string& text) {
    load(text);
    EXPECT_TRUE(directives.execute(next_effect()));
  }

  ChannelRequests requests{vm, state, pending};
  BlockDirectives directives{vm, run, state, pending, requests};
};

TEST_F(BlockDirectivesTest, AMessageIsEmittedWithItsPlace) {
  execute("\nmsg (\"worn \" + \"out\");\n");
  Command command;
  state.queue.take(command);
  EXPECT_EQ(std::get<Message>(command.payload).text, "worn out");
  EXPECT_EQ(command.origin.line, 2u);
}

TEST_F(BlockDirectivesTest, AnOverhangIsInForceWithTheAnswerOnly) {
  state.modal.tool.active = 3;
  execute("#tool_overhang (35, X)\n");
  EXPECT_EQ(std::get<ProgramRequest>(emitted()).kind, RequestKind::sync);
  EXPECT_EQ(pending.overhang().value_mm, 35.0);
  EXPECT_EQ(state.modal.tool.overhang_axis, -1);
  directives.finish_overhang();
  EXPECT_EQ(state.modal.tool.overhang_axis, 0);
}

TEST_F(BlockDirectivesTest, TheWayOfTheToolIsModal) {
  execute("#orientation (vector)\n");
  EXPECT_EQ(state.modal.tool.turning, TurningWay::vector);
  EXPECT_TRUE(state.queue.empty());
}

TEST_F(BlockDirectivesTest, ForceControlNeedsItsSensor) {
  execute("#adaptive (off)\n");
  EXPECT_EQ(run.error().code, "E6060");
}

TEST_F(BlockDirectivesTest, ASavedStateIsRestoredWithTheAnswer) {
  state.modal = default_modal_state(channel.kind);
  execute("string saved = save_gvector (GV_MODAL);\n");
  const std::string text = text_of(vm.stack().pop());
  state.modal.set(Group::distance, g(91), 1);
  vm.stack().push(value_of(text));
  EXPECT_TRUE(directives.execute({Op::restore_gvector, 1, 0, 0}));
  EXPECT_EQ(state.modal.code(Group::distance), g(91));
  directives.finish_restoring();
  EXPECT_EQ(state.modal.code(Group::distance), g(90));
  EXPECT_EQ(vm.stack().pop_number(), 1.0);
}

}  // namespace
}  // namespace stanok::lang::testing
