// Loads that a reset overtakes: the compilation ends, and the program before stays.
#include <gtest/gtest.h>

#include <functional>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

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
    ask(OperatorAction::program_load, "before.nc");
    run(20);
    ASSERT_EQ(output.channels[0].state, ChannelState::ready);
  }
  void ask(OperatorAction action, const std::string& text = "") {
    OperatorEvent event;
    event.command = command_of({.action = action, .text = std::string_view(text)}).value();
    event.channel = 1;
    CycleInputs inputs;
    inputs.events = {&event, 1};
    machine.cycle(inputs, output);
  }
  void run(int cycles) {
    for (int n = 0; n < cycles; ++n) {
      while (machine.prepare(0) != Progress::blocked) {
      }
      machine.cycle({}, output);
    }
  }
  // Runs what the channel has, to where it ends.
  double end_of_run() {
    ask(OperatorAction::program_start);
    run(2000);
    return output.channels[0].axes[0].position;
  }

  MachineConfig config = testing::two_channel_machine();
  WatchedFiles files;
  Machine machine{config, files, {.on_at_start = true, .stops_go_on = true}};
  CycleOutput output;
};

TEST_F(LoadEnd, OfACompilationIsTheReset) {
  files.on_read = [this] { ask(OperatorAction::program_reset); };
  ask(OperatorAction::program_load, "next.nc");
  run(20);
  files.on_read = {};
  EXPECT_EQ(output.channels[0].state, ChannelState::ready);
  ASSERT_FALSE(machine.load_diagnostics().empty());
  EXPECT_EQ(machine.load_diagnostics().back().diagnostic.code, "E6072");
  EXPECT_EQ(end_of_run(), 1.0);
  ask(OperatorAction::program_load, "next.nc");
  run(20);
  EXPECT_EQ(end_of_run(), 2.0) << "the next load is not ended";
}

// The program is compiled, and the channel is reset before it takes it.
TEST_F(LoadEnd, OvertakenByAResetLeavesTheProgramBefore) {
  ask(OperatorAction::program_load, "next.nc");
  while (machine.prepare(0) != Progress::blocked) {
  }
  ask(OperatorAction::program_reset);
  run(20);
  ASSERT_EQ(output.channels[0].state, ChannelState::ready);
  EXPECT_EQ(end_of_run(), 1.0);
}

TEST_F(LoadEnd, ComesWhenTheMachineGivesUp) {
  bool ends = true;
  Machine other{config, files, {.on_at_start = true, .gives_up = [&ends] { return ends; }}};
  OperatorEvent event;
  event.command = commands::ProgramLoad{ShortText("next.nc")};
  event.channel = 1;
  CycleInputs inputs;
  inputs.events = {&event, 1};
  other.cycle(inputs, output);
  static_cast<void>(other.prepare(0));
  ASSERT_EQ(other.load_diagnostics().size(), 1U);
  EXPECT_EQ(other.load_diagnostics()[0].diagnostic.code, "E6072");
}

}  // namespace
}  // namespace stanok::channels
