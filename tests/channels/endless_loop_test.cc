// Programs that never come to a block: reset ends them, however little the preparation gets to do.
#include <gtest/gtest.h>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

// A channel runs its text with one step of preparation a cycle, as a thread would that is nearly
// starved.
class EndlessLoop : public ::testing::TestWithParam<const char*> {
 protected:
  void cycle(OperatorAction action, const std::string& text = "") {
    OperatorEvent event;
    event.command = command_of({.action = action, .text = std::string_view(text)}).value();
    event.channel = 1;
    CycleInputs inputs;
    inputs.events = {&event, 1};
    machine.cycle(inputs, output);
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) {
      static_cast<void>(machine.prepare(0));
      machine.cycle({}, output);
    }
  }

  MachineConfig config = testing::two_channel_machine();
  testing::MemoryFiles files;
  Machine machine{config, files, {.on_at_start = true, .stops_go_on = true}};
  CycleOutput output;
};

TEST_P(EndlessLoop, EndsWithin100CyclesOfAReset) {
  files.texts["p.nc"] = GetParam();
  cycle(OperatorAction::program_run, "p.nc");
  cycles(1000);
  ASSERT_EQ(output.channels[0].state, ChannelState::running);
  cycle(OperatorAction::program_reset);
  cycles(100);
  EXPECT_EQ(output.channels[0].state, ChannelState::ready);
  EXPECT_FALSE(output.channels[0].running);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, EndlessLoop,
    ::testing::Values("while (true) { }\nM30\n",
                      "num count = 0;\nwhile (true) { count += 1; }\nM30\n",
                      "O100 while [1 EQ 1]\n#1 = [#1 + 1]\nO100 endwhile\nM30\n",
                      "for (;;) { string name = \"a\" + \"b\"; }\nM30\n",
                      "do { msg (\"again\"); } while (true);\nM30\n",
                      "while (true) { sync (); }\nM30\n"));

}  // namespace
}  // namespace stanok::channels
