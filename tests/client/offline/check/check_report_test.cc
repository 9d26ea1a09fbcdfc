#include "client/offline/check/check_report.h"

#include <gtest/gtest.h>

#include "client/terminal/diagnostic_output.h"
#include "client/terminal/progress_line.h"
#include "client/terminal/screen_text.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

Diagnostic diagnostic(Severity severity) {
  Diagnostic d;
  d.code = severity == Severity::error ? "E4003" : "W410";
  d.severity = severity;
  d.stack = {"in hole(), called at a.nc:4:1"};
  return d;
}

const std::vector<CheckedProgram> checked_programs = {
    {"a.nc", {diagnostic(Severity::error), diagnostic(Severity::warning)}, 12, 0.25},
    {"b.nc", {}, 30, 0.5}};

TEST(CheckReport, SumsUpProgramsInATable) {
  EXPECT_EQ(summary_table(checked_programs, Terminal(Screen::none)),
            "program                    blocks  errors  warnings  seconds\n"
            "a.nc                           12       1         1    0.250\n"
            "b.nc                           30       0         0    0.500\n"
            "2 programs, 1 with errors      42       1         1    0.750\n");
}

TEST(CheckReport, HasTheSameNumbersAndAllDiagnosticsInJson) {
  const auto report = summary_json(checked_programs);
  EXPECT_EQ(report["totals"]["blocks"], 42);
  EXPECT_EQ(report["totals"]["errors"], 1);
  EXPECT_EQ(report["files"][0]["warnings"], 1);
  EXPECT_EQ(report["files"][0]["diagnostics"][0], to_json(checked_programs[0].diagnostics[0]));
  EXPECT_EQ(report["files"][0]["diagnostics"][0]["stack"][0], "in hole(), called at a.nc:4:1");
  EXPECT_TRUE(report["files"][1]["diagnostics"].empty());
}

TEST(CheckReport, ShowsProgressWithinTheColumnsOfTheTerminal) {
  EXPECT_EQ(progress_bar(1, 4, "a.nc", 79), "[=====               ]  1 of 4  a.nc");
  const std::string path = std::string(100, 'x') + "/\xD0\xA4lange.nc";
  for (std::size_t columns = 20; columns < 120; ++columns) {
    const std::string text = progress_bar(3, 4, path, columns);
    EXPECT_LE(screen_columns(text), std::max<std::size_t>(columns, 32)) << columns;
    EXPECT_TRUE(columns < 60 || text.ends_with("lange.nc")) << text;
  }
}

}  // namespace
}  // namespace stanok::client
