// Loads that a reset overtakes: the compilation ends, and the program before stays.
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/machine/stepped_machine.h"

namespace stanok::channels {
namespace {

// Programs in memory; `on_read` is called when one is read.
class WatchedFiles final : public lang::Files {
 public:
  testing::MemoryFiles files;
  std::function<void()> on_read;

  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override {
    auto text = files.read(name, from);
    if (on_read) on_read();
    return text;
  }
};

class LoadEnd : public ::testing::Test {
 protected:
  void SetUp() override {
    files.files.texts["before.nc"] = "G1 X1 F6000\nM30\n";
    files.files.texts["next.nc"] = "G1 X2 F6000\nM30\n";
    bench.ask(OperatorAction::program_load, "before.nc");
    run(20);
    ASSERT_EQ(bench.channel().state, ChannelState::ready);
  }
  void run(int cycles) {
    for (int n = 0; n < cycles; ++n) {
      while (machine.prepare(0) != Progress::blocked) {
      }
      bench.cycle();
    }
  }
  // Runs what the channel has, to where it ends.
  double end_of_run() {
    bench.ask(OperatorAction::program_start);
    run(2000);
    return bench.channel().axes[0].position;
  }

  WatchedFiles files;
  testing::SteppedMachine bench{files};
  Machine& machine = bench.machine;
};

TEST_F(LoadEnd, OfACompilationIsTheReset) {
  files.on_read = [this] { bench.ask(OperatorAction::program_reset); };
  bench.ask(OperatorAction::program_load, "next.nc");
  run(20);
  files.on_read = {};
  EXPECT_EQ(bench.channel().state, ChannelState::ready);
  ASSERT_FALSE(machine.load_diagnostics().empty());
  EXPECT_EQ(machine.load_diagnostics().back().diagnostic.code, "E6072");
  EXPECT_EQ(end_of_run(), 1.0);
  bench.ask(OperatorAction::program_load, "next.nc");
  run(20);
  EXPECT_EQ(end_of_run(), 2.0) << "the next load is not ended";
}

// The program is compiled, and the channel is reset before it takes it.
TEST_F(LoadEnd, OvertakenByAResetLeavesTheProgramBefore) {
  bench.ask(OperatorAction::program_load, "next.nc");
  while (machine.prepare(0) != Progress::blocked) {
  }
  bench.ask(OperatorAction::program_reset);
  run(20);
  ASSERT_EQ(bench.channel().state, ChannelState::ready);
  EXPECT_EQ(end_of_run(), 1.0);
}

TEST_F(LoadEnd, ComesWhenTheMachineGivesUp) {
  bool ends = true;
  Machine other{bench.config, files, {.on_at_start = true, .gives_up = [&ends] { return ends; }}};
  OperatorEvent event;
  event.command = commands::ProgramLoad{ShortText("next.nc")};
  event.channel = 1;
  CycleInputs inputs;
  inputs.events = {&event, 1};
  other.cycle(inputs, bench.output);
  static_cast<void>(other.prepare(0));
  ASSERT_EQ(other.load_diagnostics().size(), 1U);
  EXPECT_EQ(other.load_diagnostics()[0].diagnostic.code, "E6072");
}

}  // namespace
}  // namespace stanok::channels
