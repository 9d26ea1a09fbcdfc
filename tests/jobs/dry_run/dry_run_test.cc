// DryRun and check_program: programs looked at before a run.
#include "jobs/dry_run/dry_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "config/files/machine_file.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

// One program, in memory.
class OneProgram : public lang::Files {
 public:
  explicit OneProgram(std::string text) : text_(std::make_shared<lang::SourceText>()) {
    text_->name = text_->path = "part.nc";
    text_->text = std::move(text);
  }
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view, std::string_view) const override {
    return text_;
  }

 private:
  std::shared_ptr<lang::SourceText> text_;
};

TEST(CheckProgram, FollowsThreadsWhoseFeedTheSpindleGives) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "lathe.toml");
  const OneProgram files("G21 G18 G90 G94\nS300 M3\nG0 X20 Z2\nG33 Z-10 K1.5\nG0 X22\nM30\n");
  const DryRunResult result = check_program(file.machine, 1, -1, "part.nc", files);
  EXPECT_EQ(result.blocks, 6U);
  for (const Diagnostic& diagnostic : result.diagnostics)
    ADD_FAILURE() << diagnostic.code << " " << diagnostic.message;
}

Diagnostics check_on(const std::string& machine, const std::string& program) {
  const auto file = config::read_machine_file(
      std::filesystem::path(stanok::testing::source_folder()) / "config" / "machines" / machine);
  return check_program(file.machine, 1, -1, "part.nc", OneProgram(program)).diagnostics;
}

struct FaultCase {
  const char* name;
  const char* machine;
  const char* program;
  const char* code;
  int line;
};

class CheckedThread : public ::testing::TestWithParam<FaultCase> {};

// All that stops a thread or a tap on the machine is known before, with its place and a remedy.
TEST_P(CheckedThread, IsFaultyBeforeItRuns) {
  const FaultCase& c = GetParam();
  const Diagnostics found = check_on(c.machine, c.program);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, c.code) << found[0].message;
  EXPECT_EQ(found[0].place.line, c.line);
  EXPECT_GE(found[0].place.column, 1);
  EXPECT_FALSE(found[0].help.empty()) << found[0].message;
}

#define TURN "G18 G7 G97 S400 M3\nG0 X32 Z5\n"
#define MILL "G94 S500 M3\nG0 X0 Y0 Z5\n"
INSTANTIATE_TEST_SUITE_P(
    Programs, CheckedThread,
    ::testing::Values(
        FaultCase{"no_encoder", "mill3.toml", MILL "G33 Z-10 K1\nM30\n", "E5301", 3},
        FaultCase{"tap_without_encoder", "mill3.toml", MILL "G33.1 Z-10 K1\nM30\n", "E5301", 3},
        FaultCase{"driven_tool_without_encoder", "lathe.toml",
                  TURN "S1000 $2 M3\nG33 Z-20 K2 $2\nM30\n", "E5301", 4},
        FaultCase{"axis_too_slow", "lathe.toml",
                  "G18 G7 G97 S4500 M3\nG0 X32 Z5\nG33 Z-20 K6\nM30\n", "E5302", 3},
        FaultCase{"tap_too_fast_back", "lathe.toml",
                  "G18 G7 G97 S2000 M3\nG0 X0 Z5\nG33.1 Z-20 K3 I4\nM30\n", "E5302", 3},
        FaultCase{"floating_tap_too_fast", "mill3.toml",
                  "G94 S12000 M3\nG0 X0 Y0 Z5\nG84 Z-10 R2 K2\nG80\nM30\n", "E5302", 3},
        FaultCase{"sharp_corner", "lathe.toml",
                  "G18 G8 G97 S2000 M3\nG0 X10 Z2\nG64 P0.001\nG33 Z-10 K3\nG33 X30 Z-12 K3\nM30\n",
                  "E5303", 5},
        FaultCase{"sharp_corner_behind_an_output", "lathe.toml",
                  "G18 G8 G97 S2000 M3\nG0 X10 Z2\nG64 P0.001\nG33 Z-10 K3\nM62 P1\n"
                  "G33 X30 Z-12 K3\nM30\n",
                  "E5303", 6},
        FaultCase{"lead_too_large_for_the_encoder", "lathe.toml",
                  "G18 G8 G97 S60 M3\nG0 X10 Z5\nG33 Z-90 K23\nM30\n", "E5306", 3},
        FaultCase{"two_leads", "lathe.toml", TURN "G33 Z-20 K2 F2\nM30\n", "E4066", 3},
        FaultCase{"no_lead", "lathe.toml", TURN "G33 Z-20\nM30\n", "E4066", 3},
        FaultCase{"negative_lead", "lathe.toml", TURN "G33 Z-20 K-2\nM30\n", "E4066", 3},
        FaultCase{"no_way", "lathe.toml", TURN "G33 Z5 K2\nM30\n", "E4067", 3},
        FaultCase{"tap_on_a_slant", "mill3.toml",
                  "G94 S300 M3\nG0 X0 Y0 Z5\nG33.1 X10 Y0 Z-10 K0.7\nM30\n", "E4070", 3},
        FaultCase{"standing", "lathe.toml", "G18 G7\nG0 X32 Z5\nG33 Z-20 K2\nM30\n", "E4064", 3},
        FaultCase{"g78_without_lead", "lathe.toml", TURN "G78 X29 Z-20\nM30\n", "E4066", 3},
        FaultCase{"g76_without_lead", "lathe.toml", TURN "G76 X27.5 Z-20 P1.2 Q0.4\nM30\n", "E4007",
                  3},
        FaultCase{"g76_last_cut_too_deep", "lathe.toml",
                  TURN "G76 P020560 Q0.05 R2\nG76 X27.5 Z-20 P1.2 Q0.4 F2\nM30\n", "E4008", 4},
        FaultCase{"g76_negative_cut", "lathe.toml", TURN "G76 P020560 Q-0.05 R0.1\nM30\n", "E4008",
                  3},
        FaultCase{"g84_without_speed", "mill3.toml",
                  "G94\nG0 X0 Y0 Z5\nG84 Z-10 R2 F500\nG80\nM30\n", "E4064", 3},
        FaultCase{"g74_without_lead", "mill3.toml", MILL "G74 Z-10 R2\nG80\nM30\n", "E4066", 3},
        FaultCase{"g74_without_level", "mill3.toml", MILL "G74 Z-10 K1\nG80\nM30\n", "E4061", 3}),
    [](const auto& with) { return std::string(with.param.name); });
#undef TURN
#undef MILL

TEST(CheckProgram, WarnsOnceOfAFeedThatTheAxesLimit) {
  // 250 mm/s are 15000 mm/min; at 45 degrees both axes together reach 21213.
  const Diagnostics found =
      check_on("mill3.toml", "G94\nG1 X10 F15000\nX20 Y10 F21213\nX30 F20000\nX40\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "W810");
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].place.line, 4);
  EXPECT_EQ(found[0].message, "the feed of 20000 mm/min is above 15000, the limit of the axes");
  // The greatest feed of a law counts as well.
  const Diagnostics of_law =
      check_on("mill3.toml", "G94\nG1 X50 Smin=14000 dS=100 n_s=20 dl=0.5\nM30\n");
  ASSERT_EQ(of_law.size(), 1U);
  EXPECT_EQ(of_law[0].message, "the feed of 16000 mm/min is above 15000, the limit of the axes");
}

TEST(CheckProgram, EstimatesBlocksUnderALaw) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "lathe.toml");
  const OneProgram files(
      "G18 G7 G97 S600 M3\nG0 X60 Z0\nG94 G1 Z-20.04 S_n=120 dS=0.5 dl=0.1\n"
      "X70 F120 L_A=0.4 L_B=2\nG95 X72 S_n=0.1 dS=0.01 dl=0.5\nG97 M5\nM30\n");
  const auto laws = check_program(file.machine, 1, -1, "part.nc", files).laws;
  ASSERT_EQ(laws.size(), 3U);
  double sum = 60.0 * 0.04 / 220.0;
  for (int k = 0; k < 200; ++k) sum += 60.0 * 0.1 / (120.0 + 0.5 * k);
  EXPECT_EQ(laws[0].place.line, 3);
  EXPECT_EQ(laws[0].estimate.increments, 200U);
  EXPECT_NEAR(laws[0].estimate.time_s, sum, 1e-9);
  // 120 mm/min at 600 rev/min: 0.2 mm/rev; two stands of 0.4 mm in 5 mm.
  EXPECT_EQ(laws[1].place.line, 4);
  EXPECT_NEAR(laws[1].estimate.time_s, 2.5 + 2.0 * 0.2, 1e-9);
  EXPECT_NEAR(laws[1].estimate.duration_rev.value_or(0.0), 2.0, 1e-12);
  EXPECT_NEAR(laws[1].estimate.spacing_rev.value_or(0.0), 10.0, 1e-12);
  EXPECT_NEAR(laws[2].estimate.time_s, 0.5 * (60.0 / 60.0 + 60.0 / 66.0), 1e-9);
  EXPECT_FALSE(laws[2].time_is_least);
}

// A curve has the length of its path, not that of its chord: here twice the legs of a parabola.
TEST(CheckProgram, EstimatesASplineUnderALaw) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "mill3.toml");
  const OneProgram files("G94 G17\nG0 X-2 Y4 Z0\nG5.1 X2 I2 J-8 S_n=60 dS=1 dl=0.5\nM30\n");
  const auto result = check_program(file.machine, 1, -1, "part.nc", files);
  EXPECT_TRUE(result.diagnostics.empty());
  ASSERT_EQ(result.laws.size(), 1U);
  // y = x^2 from -2 to 2.
  const double length = 2.0 * std::sqrt(17.0) + 0.5 * std::asinh(4.0);
  EXPECT_NEAR(result.laws[0].path_mm, length, 1e-6);
  EXPECT_EQ(result.laws[0].estimate.increments, 18U);  // 9.29 mm
}

TEST(DryRun, StandsWhereARigidTapBegan) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "mill3.toml");
  const OneProgram files("G21 G90 G94\nS300 M3\nG0 X0 Y0 Z5\nG33.1 Z-10 K1\nG0 X5\nM30\n");
  DryRun dry_run(file.machine, 1, -1, files);
  motion::Point last{};
  const DryRunResult result = dry_run.run(
      "part.nc", Reachability::unchecked,
      [&](const lang::Command&, const motion::PathBlock* block) {
        if (block != nullptr) last = block->end;
      },
      [](const lang::ProgramRequest&, const lang::Command&) {});
  EXPECT_TRUE(result.diagnostics.empty());
  EXPECT_EQ(last[0], 5.0);
  EXPECT_EQ(last[2], 5.0);
}

// A search and what it came to.
struct Found {
  DryRunResult result;
  lang::SearchState state;
  std::vector<double> x;  // ends of the motions behind the target
};

Found search(const std::string& text, std::uint32_t line, Calculation calculation) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "mill3.toml");
  const OneProgram files(text);
  DryRun dry_run(file.machine, 1, -1, files);
  Beginning beginning;
  beginning.target.line = line;
  beginning.calculation = calculation;
  Found found;
  found.result = dry_run.run_from(
      "part.nc", beginning,
      [&](const lang::Command&, const motion::PathBlock* block) {
        if (block != nullptr) found.x.push_back(block->end[0]);
      },
      [&](const lang::SearchState& state, const lang::Origin&) { found.state = state; });
  return found;
}

TEST(DryRun, BeginsAtABlockWithAllThatIsInForceThere) {
  const std::string text = "G91 G1 F100\nX1\nX2\nX4\nM30\n";
  const Found found = search(text, 4, Calculation::with);
  EXPECT_TRUE(found.result.diagnostics.empty());
  EXPECT_TRUE(found.state.calculated);
  EXPECT_EQ(found.state.position_W[0], 3.0);
  EXPECT_EQ(found.x, std::vector<double>{7.0});
  EXPECT_EQ(search("G0 X1\nG0 X2\nM30\n", 2, Calculation::without).x, std::vector<double>{2.0});
}

TEST(DryRun, ASearchSeesWhatTheProgramWroteIntoTables) {
  const Found found = search("G10 L2 P1 X5\nG54 G53 G0 X5\nG0 X2\nM30\n", 3, Calculation::with);
  EXPECT_TRUE(found.result.diagnostics.empty());
  EXPECT_EQ(found.state.frame.offset[0], 5.0);
  ASSERT_EQ(found.state.omissions.size(), 1U);
  EXPECT_EQ(found.state.omissions[0].what, "table writes");
}

TEST(DryRun, SaysWhyASearchEnded) {
  const Found found = search("G0 X1\nif ($in[1]) { sync (); }\nG0 X2\nM30\n", 3, Calculation::with);
  ASSERT_EQ(found.result.diagnostics.size(), 1U);
  EXPECT_EQ(found.result.diagnostics[0].code, "E6041");
  EXPECT_EQ(found.result.diagnostics[0].place.line, 2);
}

}  // namespace
}  // namespace stanok::jobs
