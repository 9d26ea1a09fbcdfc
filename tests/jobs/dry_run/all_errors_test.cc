// All errors of a program at once: from its text and from its blocks, each once, none that follows
// from another one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

class TextInMemory : public lang::Files {
 public:
  explicit TextInMemory(const std::string& text)
      : text_(std::make_shared<lang::SourceText>(lang::SourceText{"part.nc", "part.nc", text})) {}
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view, std::string_view) const override {
    return text_;
  }

 private:
  std::shared_ptr<const lang::SourceText> text_;
};

// "3 E4007", "4 E4061": errors by line.
std::vector<std::string> errors_of(const std::string& text, bool with_warnings = false) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "mill3.toml");
  const auto result = check_program(file.machine, 1, -1, "part.nc", TextInMemory(text));
  std::vector<std::string> errors;
  for (const Diagnostic& d : result.diagnostics) {
    if (d.severity == Severity::error || with_warnings)
      errors.push_back(std::to_string(d.place.line) + " " + d.code);
  }
  return errors;
}

using Errors = std::vector<std::string>;

TEST(AllErrors, OfTheBlocksOfAProgramAreShownTogether) {
  EXPECT_EQ(errors_of("G0 X0 Q5\nG2 X5 Y5 F100\nG4 Z1 R2\nG81 X1\nM30\n"),
            (Errors{"1 E4003", "2 E4031", "3 E4007", "4 E4061"}));
}

TEST(AllErrors, OfTextAndBlocksAreShownTogetherInTheOrderOfTheirPlaces) {
  EXPECT_EQ(
      errors_of("G0 X0 Q5\nnum ab = ;\nG1 X1 F100 Y[\nG4 Z1\nG0 X=ab\nif (true {\nG0 R1\n}\nM30\n"),
      (Errors{"1 E4003", "2 E2001", "3 E2001", "4 E4007", "6 E2001", "7 E4003"}));
}

TEST(AllErrors, AMissingFeedIsToldOnce) {
  EXPECT_EQ(errors_of("G1 X1\nX2\nG0 X3\nG1 X4 Q1\nM30\n"), (Errors{"1 E4020", "4 E4003"}));
}

TEST(AllErrors, AnArcBehindAFaultyBlockBeginsWhereThatOneWasToEnd) {
  EXPECT_EQ(errors_of("G0 X0 Y0\nG1 X10 F100 Q5\nG2 X20 I5\nG2 X30 I6\nM30\n"),
            (Errors{"2 E4003", "4 E4032"}));
}

TEST(AllErrors, OfGeometryAreNotToldWhereThePositionIsNotKnown) {
  EXPECT_EQ(errors_of("G0 X0 Y0\nG81 X10\nG80\nG2 X20 I5 F100\nG0 R1\nM30\n"),
            (Errors{"2 E4061", "5 E4003"}));
}

TEST(AllErrors, OfABlockInALoopAreToldOnce) {
  EXPECT_EQ(errors_of("for (num ii = 0; ii < 300; ii++) {\nG0 X1 Q5\nG4\n}\nG0 R3\nM30\n"),
            (Errors{"2 E4003", "3 E4007", "5 E4003"}));
}

TEST(AllErrors, AnEndlessLoopOverAFaultyBlockComesToItsEnd) {
  EXPECT_EQ(errors_of("while (true) {\nG0 X1 Q5\n}\nM30\n").front(), "2 E4003");
}

TEST(AllErrors, AWrongDeclarationIsTheOnlyErrorOfItsName) {
  EXPECT_EQ(errors_of("int count = 5;\nG0 X=count\nG1 X=count*2 F100\ncount = 3;\nM30\n"),
            (Errors{"1 E3001"}));
  EXPECT_EQ(errors_of("num depth = 5 6;\nG0 X=depth\ndepth++;\nM30\n"), (Errors{"1 E2001"}));
  EXPECT_EQ(errors_of("num list[3;\nG0 X=list[1]\nlist[0] = 2;\nM30\n"), (Errors{"1 E2001"}));
  EXPECT_EQ(errors_of("num twice (num) { return 2; }\nG0 X=twice (3)\nM30\n").size(), 1U);
}

TEST(AllErrors, AWrongHeaderIsTheOnlyErrorOfItsStatement) {
  EXPECT_EQ(errors_of("num i;\nfor (i = 0; i < 3; i++) {\nG0 X1\n}\nM30\n"), (Errors{"1 E3003"}));
  EXPECT_EQ(errors_of("if (1 +) {\nG0 X1\n} else {\nG0 X2\n}\nG0 X3 Q1\nM30\n"),
            (Errors{"1 E2001", "6 E4003"}));
  EXPECT_EQ(errors_of("if (true) {\nwhile (= 1) { G0 X1 }\nG0 X2\n}\nM30\n"), (Errors{"2 E2001"}));
}

TEST(AllErrors, ANameThatIsOnlyWronglyDeclaredBehindTheEndStaysUnknown) {
  EXPECT_EQ(errors_of("G0 X=depth\nM30\nnum depth = ;\n"), (Errors{"1 E3001"}));
}

TEST(AllErrors, AreAHundredAtMostAndTheRestIsCounted) {
  std::string text;
  for (int k = 0; k < 150; ++k) text += "G0 X=unknown_" + std::to_string(k) + "\n";
  const auto of_text = errors_of(text + "M30\n", true);
  EXPECT_EQ(of_text.size(), 101U);
  EXPECT_EQ(of_text.back(), "151 W213");
  text.clear();
  for (int k = 0; k < 150; ++k) text += "G4\n";
  const auto of_blocks = errors_of(text + "M30\n", true);
  EXPECT_EQ(of_blocks.size(), 101U);
  EXPECT_EQ(of_blocks.back(), "101 W213");
}

// A text for something else has one fault; what will not be shown is not looked for. Each line of
// it was blanked by going through all faulty words for every character: 0.4 ms a line.
TEST(AllErrors, OfALongTextForAPrinterAreOne) {
  std::string words = "G28\n";
  for (int k = 0; k < 20000; ++k) words += "G1 X" + std::to_string(k % 99) + " E0.5\n";
  const auto begun = std::clock();
  EXPECT_EQ(errors_of(words).size(), 100U);
  EXPECT_EQ(errors_of("M104 S200\n" + words), Errors{"1 E2042"});
  EXPECT_LT(static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC, 4.0);
}

TEST(AllErrors, OfWordsOfOneLineLeaveTheRestOfItInPlace) {
  EXPECT_EQ(errors_of("G0 X0 Q5 R6 Y0\nG1 X1 Q5 F100\nG2 X3 I1 Q7\nG2 X9 I5\nM30\n"),
            (Errors{"1 E4003", "2 E4003", "3 E4003", "4 E4032"}));
}

}  // namespace
}  // namespace stanok::jobs
