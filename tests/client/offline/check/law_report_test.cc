#include "client/offline/check/law_report.h"

#include <gtest/gtest.h>

namespace stanok::client {
namespace {

jobs::LawBlock block_of(motion::LawKind kind, int line) {
  jobs::LawBlock block;
  block.place.file = "a.nc";
  block.place.line = line;
  block.kind = kind;
  block.path_mm = 10.0;
  block.estimate.increments = 4;
  block.estimate.feed_first = block.estimate.feed_last = 120.0;
  block.estimate.time_s = 5.8;
  return block;
}

std::vector<CheckedProgram> programs_with_laws() {
  CheckedProgram program;
  program.file = "a.nc";
  Diagnostic warning;
  warning.code = "W810";
  warning.severity = Severity::warning;
  program.diagnostics = {warning};
  jobs::LawBlock interrupted = block_of(motion::LawKind::interrupted, 4);
  interrupted.estimate.closed_form_s = 5.8;
  interrupted.estimate.duration_rev = 2.0;
  interrupted.estimate.spacing_rev = 10.0;
  jobs::LawBlock turned = block_of(motion::LawKind::linear, 7);
  turned.units = {.per_revolution = true, .speed = motion::LawSpeed::m_per_min};
  turned.time_is_least = true;
  program.laws = {interrupted, turned};
  return {program};
}

TEST(LawReport, IsATableOfBlocks) {
  EXPECT_EQ(estimate_table(programs_with_laws(), Terminal(Screen::none)),
            "block   law            mm      increments  from  to   unit    s          closed form  "
            "cycle s  K_A  K_B  K_M\n"
            "a.nc:4  interrupted    10.000           4   120  120  mm/min     5.8000       5.8000  "
            "           2   10\n"
            "a.nc:7  cutting speed  10.000           4   120  120  mm/rev  >= 5.8000\n");
  EXPECT_EQ(estimate_table({}, Terminal(Screen::none)), "no feed laws\n");
}

TEST(LawReport, KeepsTheDiagnosticsBesideTheLawsInJson) {
  const auto report = estimate_json(programs_with_laws());
  EXPECT_EQ(report["diagnostics"][0]["code"], "W810");
  const auto& first = report["feed_laws"][0];
  EXPECT_EQ(first["line"], 4);
  EXPECT_EQ(first["law"], "interrupted");
  EXPECT_EQ(first["k_a"], 2.0);
  EXPECT_EQ(first["k_b"], 10.0);
  EXPECT_FALSE(first.contains("k_m"));
  EXPECT_FALSE(first.contains("cycle_s"));
  const auto& second = report["feed_laws"][1];
  EXPECT_EQ(second["feed_unit"], "mm/rev");
  EXPECT_EQ(second["time_is_least"], true);
  EXPECT_FALSE(second.contains("closed_form_s"));
}

}  // namespace
}  // namespace stanok::client
