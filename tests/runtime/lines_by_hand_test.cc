// A line by hand is a block of a program; what is shown leads where the axes stand; a place where
// the program waits changes nothing.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/chain/operator_session.h"
#include "tests/support/sanitized.h"

namespace stanok::testing {
namespace {

class ByHand : public ::testing::TestWithParam<std::string> {};

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// Types up to `count` lines, as long as they are admitted; what was done.
std::vector<std::string> type_lines(HandBench& bench, LineSource& source, int count) {
  std::vector<std::string> lines{source.first()};
  EXPECT_EQ(bench.type(lines[0]), "");
  for (int n = 0; n < count; ++n) {
    const std::string line = source.next(bench.shown());
    if (!bench.type(line).empty()) break;  // beyond the travel, not with this mode
    lines.push_back(line);
  }
  return lines;
}

// Axes, tables, frame, length, codes, tool and spindle after lines by hand, and after the same
// lines as a program: the program is the reference.
TEST_P(ByHand, LinesDoWhatTheSameLinesDoAsAProgram) {
  const channels::MachineConfig machine = shipped_machine(GetParam());
  const int sessions = cases(40);
  int compared = 0;
  std::map<std::string, int> drawn;
  for (int seed = 0; seed < sessions; ++seed) {
    SeededChoices choices(static_cast<std::uint64_t>(seed) + 5100);
    LineSource source(machine, choices);
    HandBench by_hand(machine);
    std::vector<std::string> lines = type_lines(by_hand, source, 12);
    for (const auto& [what, times] : source.drawn()) drawn[what] += times;
    if (!by_hand.bench().machine().alarms().empty()) {
      // The line that failed is none of them: the same up to it, typed once more.
      HandBench again(machine);
      for (const std::string& line : lines) ASSERT_EQ(again.type(line), "") << line;
      HandBench program(machine);
      ASSERT_EQ(program.run_to_stop(text_of(lines)), "") << text_of(lines);
      EXPECT_EQ(difference(again.left(), program.left()), "") << "seed " << seed << "\n"
                                                              << text_of(lines);
    } else {
      HandBench program(machine);
      ASSERT_EQ(program.run_to_stop(text_of(lines)), "") << text_of(lines);
      EXPECT_EQ(difference(by_hand.left(), program.left()), "") << "seed " << seed << "\n"
                                                                << text_of(lines);
    }
    compared += static_cast<int>(lines.size());
    if (HasFailure()) return;
  }
  std::cout << GetParam() << ": " << compared << " lines compared;";
  for (const auto& [what, times] : drawn) std::cout << " " << what << " " << times;
  std::cout << "\n";
  EXPECT_GT(compared, 4 * sessions);
}

// After each line: the words that are shown, typed back in the units of the channel, move nothing.
TEST_P(ByHand, TypingWhatIsShownMovesNothing) {
  const channels::MachineConfig machine = shipped_machine(GetParam());
  const int sessions = cases(20);
  for (int seed = 0; seed < sessions; ++seed) {
    SeededChoices choices(static_cast<std::uint64_t>(seed) + 5200);
    LineSource source(machine, choices);
    HandBench bench(machine);
    std::vector<std::string> lines = type_lines(bench, source, 6);
    if (!bench.bench().machine().alarms().empty()) continue;
    const ChannelLeft before = bench.left();
    const std::string back = bench.typed_back();
    ASSERT_EQ(bench.type(back), "") << back << "\n" << text_of(lines);
    const ChannelLeft after = bench.left();
    for (std::size_t k = 0; k < before.axes_M.size(); ++k) {
      EXPECT_NEAR(after.axes_M[k], before.axes_M[k], 1e-9)
          << "seed " << seed << " axis " << k << " " << back << "\n"
          << text_of(lines);
    }
    if (HasFailure()) return;
  }
}

// What makes the axes stand and the program wait changes no position and no table.
TEST_P(ByHand, ASyncPointChangesNothing) {
  const channels::MachineConfig machine = shipped_machine(GetParam());
  const int sessions = cases(20);
  const std::vector<std::string> waits{"M1", "sync ();", "M66 P0 L0", "G4 P0", "M70\nM72"};
  for (int seed = 0; seed < sessions; ++seed) {
    SeededChoices choices(static_cast<std::uint64_t>(seed) + 5300);
    LineSource source(machine, choices);
    HandBench by_hand(machine);
    const std::vector<std::string> lines = type_lines(by_hand, source, 12);
    std::vector<std::string> waiting;
    for (const std::string& line : lines) {
      waiting.push_back(line);
      if (choices.chance(0.6)) waiting.push_back(waits[choices.below(waits.size())]);
    }
    HandBench plain(machine);
    HandBench with(machine);
    ASSERT_EQ(plain.run_to_stop(text_of(lines)), "") << text_of(lines);
    ASSERT_EQ(with.run_to_stop(text_of(waiting)), "") << text_of(waiting);
    EXPECT_EQ(difference(plain.left(), with.left()), "") << "seed " << seed << "\n"
                                                         << text_of(waiting);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ByHand, ::testing::ValuesIn(machines_with_tools()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace stanok::testing
