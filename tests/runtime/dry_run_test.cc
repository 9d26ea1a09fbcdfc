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

}  // namespace
}  // namespace stanok::runtime
