// ProgramAdvice: programs whose blocks are right, but hardly meant.
#include "jobs/dry_run/program_advice.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

class AdvisedText : public lang::Files {
 public:
  explicit AdvisedText(const std::string& text) : text_(std::make_shared<lang::SourceText>()) {
    text_->name = text_->path = "part.nc";
    text_->text = text;
  }
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view, std::string_view) const override {
    return text_;
  }

 private:
  std::shared_ptr<lang::SourceText> text_;
};

Diagnostics advice_on(const std::string& program) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "mill3.toml");
  return check_program(file.machine, 1, -1, "part.nc", AdvisedText(program)).diagnostics;
}

struct AdviceCase {
  const char* name;
  const char* program;
  const char* code;  // nothing: there is no advice
  int line;
};

class AdvisedProgram : public ::testing::TestWithParam<AdviceCase> {};

TEST_P(AdvisedProgram, IsToldOnceWithPlaceAndRemedy) {
  const AdviceCase& c = GetParam();
  const Diagnostics found = advice_on(c.program);
  ASSERT_EQ(found.size(), c.code == nullptr ? 0U : 1U) << found.back().message;
  if (c.code == nullptr) return;
  EXPECT_EQ(found[0].code, c.code) << found[0].message;
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_EQ(found[0].place.line, c.line);
  EXPECT_FALSE(found[0].help.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Programs, AdvisedProgram,
    ::testing::Values(
        AdviceCase{"spindle_stopped", "S500 M3\nG1 X1 F100\nM5\nG1 X2\nX3\nM30\n", "W411", 4},
        AdviceCase{"spindle_forgotten", "T1 M6\nG0 X1\nG1 X2 F100\nM30\n", "W411", 3},
        AdviceCase{"no_spindle_at_all", "G1 X1 F100\nM30\n", nullptr, 0},
        AdviceCase{"spindle_started_again", "S500 M3\nM5\nG0 X1\nM3\nG1 X2 F100\nM30\n", nullptr,
                   0},
        AdviceCase{"compensation_left_on", "S500 M3\nG41.1 D2\nG1 X10 Y5 F100\nY20\nM30\n", "W412",
                   5},
        AdviceCase{"compensation_ended", "S500 M3\nG41.1 D2\nG1 X10 Y5 F100\nY20\nG40 X0\nM30\n",
                   nullptr, 0},
        AdviceCase{"speed_above_limit", "S99999 M3\nG1 X1 F100\nS99998\nM30\n", "W413", 1}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace stanok::jobs
