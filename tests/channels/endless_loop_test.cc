// Programs that never come to a block: reset ends them, however little the preparation gets to do.
#include <gtest/gtest.h>

#include "tests/support/machine/stepped_machine.h"

namespace stanok::channels {
namespace {

// A channel runs its text with one step of preparation a cycle, as a thread would that is nearly
// starved.
class EndlessLoop : public ::testing::TestWithParam<const char*> {
 protected:
  void cycles(int count) {
    for (int n = 0; n < count; ++n) {
      static_cast<void>(bench.machine.prepare(0));
      bench.cycle();
    }
  }

  testing::MemoryFiles files;
  testing::SteppedMachine bench{files};
};

TEST_P(EndlessLoop, EndsWithin100CyclesOfAReset) {
  files.texts["p.nc"] = GetParam();
  bench.ask(OperatorAction::program_run, "p.nc");
  cycles(1000);
  ASSERT_EQ(bench.channel().state, ChannelState::running);
  bench.ask(OperatorAction::program_reset);
  cycles(100);
  EXPECT_EQ(bench.channel().state, ChannelState::ready);
  EXPECT_FALSE(bench.channel().running);
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
