// A line by hand is a block of a program; a place where the program waits changes nothing.
#include <gtest/gtest.h>

#include "tests/support/chain/operator_session.h"
#include "tests/support/sanitized.h"

namespace stanok::testing {
namespace {

class ByHand : public ::testing::TestWithParam<HandPlace> {};

std::string printed(const WordCounts& counts) {
  std::string text;
  for (const auto& [what, times] : counts) text += " " + what + " " + std::to_string(times) + ";";
  return text;
}

// Axes, tables, frame, length, codes, tool and spindle after lines by hand, and after the same
// lines as a program: the program is the reference.
TEST_P(ByHand, LinesDoWhatTheSameLinesDoAsAProgram) {
  const channels::MachineConfig machine = GetParam().config();
  const bool is_own = GetParam().dialect == lang::Dialect::stanok;
  // Half of a tenth with a sanitizer: the longest test of all builds.
  const int sessions = cases(is_own ? 320 : 20) / (is_sanitized ? 2 : 1);
  std::size_t compared = 0;
  WordCounts counts;
  for (int seed = 0; seed < sessions; ++seed) {
    SeededChoices choices(static_cast<std::uint64_t>(seed) + 5100);
    OperatorSession session(machine, GetParam().channel, choices, counts);
    session.type(12);
    counts = session.counts();
    HandBench program(machine, GetParam().channel);
    ASSERT_EQ(program.run_to_stop(session.text()), "") << session.text();
    ASSERT_EQ(difference(session.bench().left(), program.left()), "") << "seed " << seed << "\n"
                                                                      << session.text();
    compared += session.lines().size();
  }
  std::cout << GetParam().name() << ": " << compared << " lines compared;" << printed(counts)
            << "\n";
  EXPECT_GT(compared, static_cast<std::size_t>(sessions) * 6);
  if (!is_own || is_sanitized) return;
  for (const auto& [what, times] : counts) EXPECT_GE(times, 25) << what;
}

class SyncPoint {
 public:
  SyncPoint(lang::Dialect dialect, Choices& choices) : dialect_(dialect), choices_(choices) {}

  // What makes the axes stand, or keeps what words mean and gives it back.
  [[nodiscard]] std::string next() {
    std::vector<std::string> points{"M1",       "sync ();", "M66 P0 L0",
                                    "G4 P0",    "M70\nM72", "M70\n" + change() + "\nM72",
                                    "M98 P9900"};
    const std::string name = "kept" + std::to_string(++saved_);
    points.push_back("string " + name + " = save_gvector (GV_ALL);\nrestore_gvector (" + name +
                     ");");
    if (dialect_ == lang::Dialect::fanuc || dialect_ == lang::Dialect::haas)
      points = {"M1", "G4 P0", "#100=#5021", "#100=#5003", "M98 P9900"};
    if (dialect_ == lang::Dialect::linuxcnc)
      points = {"M1", "G4 P0", "M66 P0 L0", "#100=#5422", "M70\nM72", "O9900 call"};
    return points[choices_.below(points.size())];
  }
  // Behind the end of the program.
  [[nodiscard]] std::string subprograms() const {
    if (dialect_ == lang::Dialect::linuxcnc) return "O9900 sub\nM73\nG91 G20\nO9900 endsub\n";
    if (dialect_ != lang::Dialect::stanok) return "O9900\nM99\n";
    return "O9900\nM73\nG91 G20\nM99\n";
  }

 private:
  [[nodiscard]] std::string change() {
    const std::vector<std::string> changes{"G91", "G20", "G90 G21", "F77", "G61", "M9"};
    return changes[choices_.below(changes.size())];
  }

  lang::Dialect dialect_;
  Choices& choices_;
  int saved_ = 0;
};

// What makes the axes stand and the program wait changes no position, no table, no length.
TEST_P(ByHand, ASyncPointChangesNothing) {
  const channels::MachineConfig machine = GetParam().config();
  const int sessions = cases(60);
  for (int seed = 0; seed < sessions; ++seed) {
    SeededChoices choices(static_cast<std::uint64_t>(seed) + 5300);
    OperatorSession session(machine, GetParam().channel, choices);
    session.type(12);
    SyncPoint points(GetParam().dialect, choices);
    std::string waiting;
    for (const std::string& line : session.lines()) {
      waiting += line + "\n";
      if (choices.chance(0.6)) waiting += points.next() + "\n";
    }
    HandBench plain(machine, GetParam().channel);
    HandBench with(machine, GetParam().channel);
    ASSERT_EQ(plain.run_to_stop(session.text()), "") << session.text();
    ASSERT_EQ(with.run_to_stop(waiting, points.subprograms()), "") << waiting;
    ASSERT_EQ(difference(plain.left(), with.left()), "") << "seed " << seed << "\n" << waiting;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ByHand, ::testing::ValuesIn(hand_places()),
                         [](const auto& tested) { return tested.param.name(); });

}  // namespace
}  // namespace stanok::testing
