#include "base/diagnostic.h"

#include <gtest/gtest.h>

namespace stanok {
namespace {

Diagnostic unknown_code() {
  Diagnostic diagnostic;
  diagnostic.code = "E4031";
  diagnostic.place = {"part.nc", 12, 4, 12, 8};
  diagnostic.message = "G199 is no code of this machine";
  diagnostic.label = "unknown code";
  diagnostic.source_line = "G1 G199 X5";
  return diagnostic;
}

TEST(Diagnostic, PointsAtTheWordInItsLine) {
  EXPECT_EQ(to_text(unknown_code()),
            "error[E4031]: G199 is no code of this machine\n"
            "  --> part.nc:12:4\n"
            "   |\n"
            "12 | G1 G199 X5\n"
            "   |    ^^^^ unknown code\n"
            "   |\n");
}

TEST(Diagnostic, KeepsTabsSoThatTheCaretStandsUnderItsWord) {
  Diagnostic diagnostic = unknown_code();
  diagnostic.source_line = "G1\tG199 X5";
  EXPECT_NE(to_text(diagnostic).find("   |   \t^^^^ unknown code"), std::string::npos);
}

TEST(Diagnostic, MarksOneCharacterWhenTheSpanGoesOverSeveralLines) {
  Diagnostic diagnostic = unknown_code();
  diagnostic.place.end_line = 14;
  EXPECT_NE(to_text(diagnostic).find("|    ^ unknown code"), std::string::npos);
}

// A very long line does not flood the terminal: what is shown is what is around the word.
TEST(Diagnostic, ShowsThePartOfAVeryLongLineWhereTheWordStands) {
  Diagnostic diagnostic = unknown_code();
  const std::string spaces(50'000, ' ');
  diagnostic.source_line = spaces + "G199" + spaces;
  diagnostic.place = {"part.nc", 12, 50'001, 12, 50'005};
  const std::string blanks(80, ' ');
  EXPECT_NE(to_text(diagnostic)
                .find("12 | ..." + blanks + "G199" + std::string(76, ' ') + "...\n   |    " +
                      blanks + "^^^^ unknown code\n"),
            std::string::npos);
  diagnostic.source_line = std::string(100'000, 'G');
  diagnostic.place = {"part.nc", 12, 1, 12, 100'001};
  EXPECT_LT(to_text(diagnostic).size(), 600U);
}

TEST(Diagnostic, NotesHelpAndCallStackFollowThePicture) {
  Diagnostic diagnostic = unknown_code();
  diagnostic.source_line.clear();
  diagnostic.notes = {{"included here", {"main.nc", 3, 1, 3, 9}}, {"nothing was moved", {}}};
  diagnostic.help = {"write G99"};
  diagnostic.stack = {"in hole(), called at part.nc:20:3"};
  EXPECT_EQ(to_text(diagnostic),
            "error[E4031]: G199 is no code of this machine\n"
            "  --> part.nc:12:4\n"
            " note: included here (main.nc:3:1)\n"
            " note: nothing was moved\n"
            " help: write G99\n"
            "   in hole(), called at part.nc:20:3\n");
}

TEST(Diagnostic, WithoutALineOnlyTheFileIsNamed) {
  Diagnostic diagnostic;
  diagnostic.code = "E7001";
  diagnostic.message = "file not found";
  diagnostic.place.file = "absent.nc";
  EXPECT_EQ(to_text(diagnostic), "error[E7001]: file not found\n  --> absent.nc\n");
  diagnostic.place.file.clear();
  EXPECT_EQ(to_text(diagnostic), "error[E7001]: file not found\n");
}

TEST(Diagnostic, WithoutAColumnTheLineIsNamed) {
  Diagnostic diagnostic;
  diagnostic.code = "W921";
  diagnostic.severity = Severity::warning;
  diagnostic.message = "a rapid traverse goes through material";
  diagnostic.place.file = "part.nc";
  diagnostic.place.line = 12;
  EXPECT_EQ(to_text(diagnostic),
            "warning[W921]: a rapid traverse goes through material\n  --> part.nc:12\n");
}

TEST(Diagnostic, OnlyErrorsMakeAListFail) {
  Diagnostic warning;
  warning.severity = Severity::warning;
  Diagnostic note;
  note.severity = Severity::note;
  EXPECT_FALSE(has_errors({}));
  EXPECT_FALSE(has_errors({warning, note}));
  EXPECT_TRUE(has_errors({warning, unknown_code(), note}));
  EXPECT_EQ(to_text(warning).substr(0, 8), "warning[");
}

}  // namespace
}  // namespace stanok
