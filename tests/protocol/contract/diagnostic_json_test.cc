#include "protocol/contract/diagnostic_json.h"

#include <gtest/gtest.h>

namespace stanok::protocol {
namespace {

TEST(DiagnosticJson, IsReadBack) {
  Diagnostic told{.code = "E4031",
                  .severity = Severity::warning,
                  .place = {"part.nc", 3, 7, 4, 9},
                  .message = "two G codes",
                  .label = "here",
                  .notes = {{"the first one", {"part.nc", 2}}, {"no place", {}}},
                  .help = {"drop G1", "drop G2"},
                  .stack = {"in hole()"},
                  .source_line = {}};
  const Diagnostic read = diagnostic_of(nlohmann::json::parse(diagnostic_json(told).dump()));
  EXPECT_EQ(read.severity, Severity::warning);
  EXPECT_EQ(read.place.end_column, 9);
  EXPECT_EQ(to_text(read), to_text(told));
}

TEST(DiagnosticJson, OfAnotherDaemonIsReadAsFarAsItGoes) {
  const Diagnostic read = diagnostic_of({{"code", 7},
                                         {"severity", "dreadful"},
                                         {"line", "three"},
                                         {"notes", {1, {{"text", "so"}}}},
                                         {"help", "not a list"},
                                         {"message", "what is wrong"}});
  EXPECT_EQ(read.code, "");
  EXPECT_EQ(read.severity, Severity::error);
  EXPECT_EQ(read.place.line, 0);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_EQ(read.message, "what is wrong");
  EXPECT_EQ(diagnostic_of(nullptr).message, "");
}

}  // namespace
}  // namespace stanok::protocol
