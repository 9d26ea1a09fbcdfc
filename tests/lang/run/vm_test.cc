// The machine alone: code written by hand, no text, no block.
#include "lang/run/vm.h"

#include <gtest/gtest.h>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class VmTest : public ::testing::Test {
 protected:
  // A machine before the first instruction of `code`.
  void load(std::vector<Instruction> code, std::vector<double> numbers, std::uint32_t slots = 0) {
    auto program = std::make_shared<Program>();
    auto file = std::make_unique<CompiledFile>(source_of("main.nc", "text\n"));
    file->spans.assign(code.size(), Span{0, 4, 1});
    file->code = std::move(code);
    file->numbers = std::move(numbers);
    file->file_slots = slots;
    program->files.push_back(std::move(file));
    vm.begin(std::move(program));
    run.begin();
  }
  // Executes everything before the instruction that the machine hands back.
  const Instruction* run_on() {
    for (int steps = 0; steps < 1000 && run.running(); ++steps) {
      if (const Instruction* const other = vm.step()) return other;
    }
    return nullptr;
  }

  const ChannelDescription channel = mill_xyzbc();
  const ChannelWords words{channel};
  CommandQueue queue;
  RunStage run{queue};
  Vm vm{words, run};
};

constexpr auto add = static_cast<std::uint16_t>(Operation::add);
constexpr auto divide = static_cast<std::uint16_t>(Operation::divide);

TEST_F(VmTest, ComputesOnTheStackAndHandsBackWhatIsNotItsOwn) {
  load({{Op::push_number, 0, 0, 0},
        {Op::push_number, 0, 0, 1},
        {Op::compute, 0, add, 0},
        {Op::end_of_text, 0, 0, 0}},
       {40.0, 2.0});
  const Instruction* const other = run_on();
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(other->op, Op::end_of_text);
  EXPECT_EQ(vm.stack().pop_number(), 42.0);
  EXPECT_EQ(vm.stack().height(), 0u);
}

TEST_F(VmTest, ComputesAheadUpToTheBoundAndUpToWhatHasAnEffect) {
  load({{Op::push_number, 0, 0, 0},
        {Op::store_file, 0, 0, 0},
        {Op::jump, 0, 0, 3},
        {Op::end_of_text, 0, 0, 0}},
       {7.0}, 1);
  EXPECT_EQ(vm.compute_ahead(1), 1);
  EXPECT_EQ(vm.compute_ahead(100), 2);
  EXPECT_EQ(vm.compute_ahead(100), 0);
  EXPECT_EQ(vm.step()->op, Op::end_of_text);
}

TEST_F(VmTest, JumpsOverWhatIsSkippedOnlyAtTheLevelThatIsOn) {
  const std::vector<Instruction> code{
      {Op::jump_if_skipped, 3, 0, 2}, {Op::push_number, 0, 0, 0}, {Op::end_of_text, 0, 0, 0}};
  load(code, {1.0});
  vm.set_block_skip(1U << 2);
  run_on();
  EXPECT_EQ(vm.stack().height(), 1u);
  load(code, {1.0});
  vm.set_block_skip(1U << 3);
  run_on();
  EXPECT_EQ(vm.stack().height(), 0u);
}

TEST_F(VmTest, FailsWithTheSpanOfTheInstruction) {
  load({{Op::push_number, 0, 0, 0}, {Op::push_number, 0, 0, 1}, {Op::compute, 0, divide, 0}},
       {1.0, 0.0});
  queue.emit(ProgramStop{});
  run_on();
  EXPECT_TRUE(run.failed());
  EXPECT_EQ(run.error().place.line, 1u);
  EXPECT_TRUE(run.error().stack.empty());
  EXPECT_TRUE(queue.empty()) << "the commands of what failed are dropped";
}

TEST_F(VmTest, CallsHaveSlotsOfTheirOwnThatAreGoneWhenTheyAreLeft) {
  load({{Op::end_of_text, 0, 0, 0}}, {}, 1);
  vm.stack().push(value_of(1.0));
  CallFrame frame = vm.frame_at_top(0);
  FunctionCode function;
  function.signature.name = "half";
  function.slots = 3;
  frame.function = &function;
  frame.position = 1;
  vm.add_slots(function);
  vm.enter(std::move(frame));
  EXPECT_EQ(vm.where().call_level, 1);
  EXPECT_EQ(vm.frame().slots, 1u);
  vm.stack().push(value_of(2.0));
  vm.leave();
  EXPECT_EQ(vm.where().call_level, 0);
  EXPECT_EQ(vm.stack().height(), 1u);
  EXPECT_EQ(vm.frame_at_top(0).slots, 1u);
}

TEST_F(VmTest, RefusesTheSixtyFifthNestedCall) {
  load({{Op::end_of_text, 0, 0, 0}}, {});
  vm.step();
  for (std::size_t i = 0; i < 64; ++i) {
    ASSERT_TRUE(vm.check_call_depth());
    CallFrame frame = vm.frame_at_top(0);
    frame.position = 1;
    vm.enter(std::move(frame));
  }
  EXPECT_FALSE(vm.check_call_depth());
  EXPECT_EQ(run.error().code, "E8001");
  EXPECT_EQ(run.error().stack.size(), 64u);
}

// Arrays of 64 MiB together: the next one is refused, and the memory of one that is gone is free.
TEST(ArrayInstructions, KeepTheirLedgerWithinItsLimit) {
  ValueStack stack;
  ArrayInstructions arrays(stack);
  ValueFault fault;
  const auto make = [&] {
    stack.push(value_of(1'000'000.0));
    return arrays.execute({Op::new_array, 1, 0, 0}, fault);
  };
  int made = 0;
  while (make()) ++made;
  EXPECT_EQ(made, static_cast<int>((64U << 20U) / (1'000'000 * sizeof(Value))));
  EXPECT_EQ(fault.code, "E8002");
  stack.pop();
  EXPECT_TRUE(make());
  stack.clear();
  EXPECT_EQ(arrays.bytes(), 0u);
}

TEST(ArrayInstructions, RefuseAnIndexOutsideTheArrayAndSayWhichAreValid) {
  ValueStack stack;
  ArrayInstructions arrays(stack);
  ValueFault fault;
  stack.push(value_of(3.0));
  ASSERT_TRUE(arrays.execute({Op::new_array, 1, 0, 0}, fault));
  stack.push(value_of(3.0));
  EXPECT_FALSE(arrays.execute({Op::element, 1, 0, 0}, fault));
  EXPECT_EQ(fault.code, "E3011");
  EXPECT_EQ(fault.label, "index 3; valid indices are 0 to 2");
}

}  // namespace
}  // namespace stanok::lang::testing
