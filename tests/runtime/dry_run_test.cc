// DryRun and check_program: programs looked at before a run.
#include "runtime/dry_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "config/machine_file.h"

namespace stanok::runtime {
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
  const auto file = config::read_machine_file(std::filesystem::path(STANOK_SOURCE_DIR) / "config" /
                                              "machines" / "lathe.toml");
  const OneProgram files("G21 G18 G90 G94\nS300 M3\nG0 X20 Z2\nG33 Z-10 K1.5\nG0 X22\nM30\n");
  const DryRunResult result = check_program(file.machine, 1, -1, "part.nc", files);
  EXPECT_EQ(result.blocks, 6U);
  for (const Diagnostic& diagnostic : result.diagnostics)
    ADD_FAILURE() << diagnostic.code << " " << diagnostic.message;
}

TEST(DryRun, StandsWhereARigidTapBegan) {
  const auto file = config::read_machine_file(std::filesystem::path(STANOK_SOURCE_DIR) / "config" /
                                              "machines" / "mill3.toml");
  const OneProgram files("G21 G90 G94\nS300 M3\nG0 X0 Y0 Z5\nG33.1 Z-10 K1\nG0 X5\nM30\n");
  DryRun dry_run(file.machine, 1, -1, files);
  motion::Point last{};
  const DryRunResult result = dry_run.run(
      "part.nc", Reachability::unchecked,
      [&](const lang::Command&, const motion::PathBlock* block) {
        if (block != nullptr) last = block->end;
      },
      [](const lang::Request&, const lang::Command&) {});
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
  const auto file = config::read_machine_file(std::filesystem::path(STANOK_SOURCE_DIR) / "config" /
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
}  // namespace stanok::runtime
