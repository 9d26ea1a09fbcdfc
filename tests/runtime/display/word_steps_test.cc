// The steps from the machine position lead to the word that is shown, and each is what tables,
// scheme and program say.
#include "runtime/display/word_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>

#include "tests/support/chain/operator_session.h"
#include "tests/support/sanitized.h"

namespace stanok::runtime {
namespace {

using testing::HandBench;
using testing::SeededChoices;

constexpr double same = 1e-9;

std::vector<WordStep> steps_of(HandBench& bench, const channels::MachineConfig& machine) {
  return steps_to_words(machine, machine.channels[0], bench.now(),
                        bench.bench().machine().situation(bench.now()).meaning);
}

std::optional<WordStep> step(const std::vector<WordStep>& steps, WordTerm term) {
  const auto found = std::ranges::find(steps, term, &WordStep::term);
  return found == steps.end() ? std::nullopt : std::optional(*found);
}

double amount(const std::vector<WordStep>& steps, WordTerm term, std::size_t axis) {
  double sum = 0.0;
  for (const WordStep& one : steps) sum += one.term == term ? one.amount[axis] : 0.0;
  return sum;
}

// Empty: the steps begin at the axes, add up and end at the words of the display.
std::string gap(const std::vector<WordStep>& steps, HandBench& bench, std::size_t axes) {
  const lang::AxisValues shown = bench.shown();
  for (std::size_t k = 0; k < axes; ++k) {
    if (steps.front().value[k] != bench.now().axes[k].position) return "does not begin at the axes";
    double sum = 0.0;
    for (const WordStep& one : steps) {
      sum += one.amount[k];
      if (std::abs(sum - one.value[k]) > same) return "a value is not the sum of the amounts";
    }
    if (std::abs(sum - shown[k]) > same)
      return "axis " + std::to_string(k) + " ends at " + std::to_string(sum) + " instead of " +
             std::to_string(shown[k]);
  }
  for (std::size_t k = 0; k < axes; ++k) {
    const bool is_spindle = bench.now().drives[k].follows_velocity;
    if (!is_spindle && std::abs(amount(steps, WordTerm::rest, k)) > same)
      return "something is not explained";
  }
  return "";
}

// What tables and configuration say of the terms that are there, as far as this needs no
// kinematics.
void compare_with_tables(const std::vector<WordStep>& steps, HandBench& bench,
                         const channels::MachineConfig& machine) {
  const channels::ChannelConfig& channel = machine.channels[0];
  const auto scheme =
      std::ranges::find(channel.schemes, bench.now().scheme, &kinematics::SchemeConfig::id);
  const lang::MeaningTerms& terms = *bench.bench().machine().situation(bench.now()).meaning.terms;
  const channels::TablesConfig tables = bench.bench().machine().tables();
  const auto offset = tables.offsets.find("G" + std::to_string(53 + terms.frame.work_offset));
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    const bool takes_part = kinematics::takes_part(*scheme, static_cast<int>(k));
    EXPECT_NEAR(amount(steps, WordTerm::scheme_zero, k), takes_part ? -scheme->zero[k] : 0.0, same);
    if (terms.frame.work_offset > 6) continue;
    const std::string& axis = machine.axes[channel.axes[k]].name;
    const bool is_given = offset != tables.offsets.end() && offset->second.contains(axis);
    EXPECT_NEAR(amount(steps, WordTerm::work_offset, k), is_given ? -offset->second.at(axis) : 0.0,
                same)
        << axis;
  }
}

class WayToTheWords : public ::testing::TestWithParam<std::string> {};

TEST_P(WayToTheWords, LeadsFromTheAxesToWhatIsShown) {
  const channels::MachineConfig machine = testing::shipped_machine(GetParam());
  const int sessions = testing::cases(200);
  std::map<WordTerm, int> seen;
  for (int seed = 0; seed < sessions; ++seed) {
    SeededChoices choices(static_cast<std::uint64_t>(seed) + 5400);
    testing::LineSource source(machine, choices);
    HandBench bench(machine);
    ASSERT_EQ(bench.type(source.first()), "");
    std::string typed;
    for (int n = 0; n < 12; ++n) {
      const std::string line = source.next(bench.shown());
      typed += line + "\n";
      if (!bench.type(line).empty()) break;
      const auto steps = steps_of(bench, machine);
      ASSERT_EQ(gap(steps, bench, machine.channels[0].axes.size()), "") << "seed " << seed << "\n"
                                                                        << typed;
      compare_with_tables(steps, bench, machine);
      for (const WordStep& one : steps) ++seen[one.term];
      if (HasFailure()) FAIL() << "seed " << seed << "\n" << typed;
    }
  }
  std::cout << GetParam() << ":";
  for (const auto& [term, times] : seen) std::cout << " " << name_of(term) << " " << times;
  std::cout << "\n";
}

INSTANTIATE_TEST_SUITE_P(Shipped, WayToTheWords,
                         ::testing::ValuesIn(testing::machines_with_tools()),
                         [](const auto& tested) { return tested.param; });

struct Typed {
  const char* machine;
  std::vector<std::string> lines;
  std::vector<WordTerm> terms;  // that must be there
};

void PrintTo(const Typed& typed, std::ostream* out) {
  *out << typed.machine << " " << typed.lines.back();
}

class WordsOf : public ::testing::TestWithParam<Typed> {};

// What the random lines do not draw.
TEST_P(WordsOf, AreExplained) {
  const channels::MachineConfig machine = testing::shipped_machine(GetParam().machine);
  HandBench bench(machine);
  std::string text;
  for (const std::string& line : GetParam().lines) text += line + "\n";
  ASSERT_EQ(bench.run_to_stop(text), "") << text;
  const auto steps = steps_of(bench, machine);
  EXPECT_EQ(gap(steps, bench, machine.channels[0].axes.size()), "");
  compare_with_tables(steps, bench, machine);
  for (const WordTerm term : GetParam().terms) EXPECT_TRUE(step(steps, term)) << name_of(term);
}

INSTANTIATE_TEST_SUITE_P(
    Modes, WordsOf,
    ::testing::Values(
        Typed{"trunnion",
              {"T1 M6", "G10 L2 P1 X5 Y-3", "G0 A10 C20", "G43.4 H1"},
              {WordTerm::scheme_zero, WordTerm::kinematics, WordTerm::tool_length,
               WordTerm::work_offset}},
        Typed{"trunnion",
              {"G10 L2 P1 X5 Y-3 Z20 R30", "G52 X1 Y2", "G92 X40", "G68 X1 Y2 R25"},
              {WordTerm::work_offset, WordTerm::work_offset_rotation, WordTerm::local_shift,
               WordTerm::axis_shift, WordTerm::rotation}},
        Typed{"trunnion",
              {"G10 L2 P1 X5 Y-3 Z20", "G68.2 X1 Y2 Z3 I20 J15", "G52 X1 Z2"},
              {WordTerm::plane, WordTerm::plane_shift}},
        Typed{"trunnion", {"G51 X1 Y2 P1.5", "G51.1 X3"}, {WordTerm::scaling}},
        Typed{"trunnion", {"G0 X100 Y20", "G16"}, {WordTerm::polar}},
        Typed{"lathe", {"T0101", "G0 X100 Z0", "G7"}, {WordTerm::tool_length, WordTerm::diameter}},
        Typed{"trunnion",
              {"G10 L2 P1 X5 Y-3", "G54.4 X0.5 Y-0.25 K30", "G0 X10 Y20"},
              {WordTerm::work_offset, WordTerm::set_up_error}},
        Typed{"lathe",
              {"M902 H1=1", "G94 G8 G0 X30 Z-2 C0", "G12.1", "G1 X20 C5 F600"},
              {WordTerm::transformation}},
        Typed{"lathe",
              {"M902 H1=1", "G94 G8 G0 X30 Z-2 C0", "G7.1 C30", "G1 C20 F600"},
              {WordTerm::transformation}},
        Typed{"lathe",
              {"M902 H1=1", "G10 L2 P1 X1 C30", "G8 G0 X40 C10", "G12.1"},
              {WordTerm::work_offset, WordTerm::transformation}}));

// The frames nobody can see: all offsets are 0, and yet work and machine differ.
TEST(WayToTheWord, NamesTheZeroOfTheScheme) {
  channels::MachineConfig machine = testing::shipped_machine("e7106mf4");
  for (auto& [name, row] : machine.tables.offsets) row.clear();
  HandBench bench(machine);
  const auto steps = steps_of(bench, machine);
  EXPECT_EQ(gap(steps, bench, machine.channels[0].axes.size()), "");
  EXPECT_TRUE(step(steps, WordTerm::scheme_zero));
  EXPECT_FALSE(step(steps, WordTerm::work_offset));
}

}  // namespace
}  // namespace stanok::runtime
