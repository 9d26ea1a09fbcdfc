// DryRun and check_program: programs looked at before a run.
#include "runtime/dry_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

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

}  // namespace
}  // namespace stanok::runtime
