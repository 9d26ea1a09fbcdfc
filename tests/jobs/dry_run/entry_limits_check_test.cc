// What a program must not write into the tables is found before it runs, with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

using ::testing::HasSubstr;

class ProgramThatWrites : public lang::Files {
 public:
  explicit ProgramThatWrites(std::string text) : text_(std::make_shared<lang::SourceText>()) {
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

config::MachineFile machine(const std::string& name) {
  return config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                   "config" / "machines" / name);
}

Diagnostics checked_on(const std::string& name, const std::string& program) {
  return check_program(machine(name).machine, 1, -1, "part.nc", ProgramThatWrites(program))
      .diagnostics;
}

struct Fault {
  const char* program;
  int line;
  const char* words;
  int column = 1;
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.program;
}

class ImplausibleEntry : public ::testing::TestWithParam<Fault> {};

TEST_P(ImplausibleEntry, IsFoundInItsLineBeforeTheRun) {
  const Fault& fault = GetParam();
  const Diagnostics found =
      checked_on("mill3_probe.toml", "G21 G90 G17 G94\n" + std::string(fault.program) + "\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E5022") << found[0].message;
  EXPECT_EQ(found[0].place.file, "part.nc");
  EXPECT_EQ(found[0].place.line, fault.line);
  EXPECT_EQ(found[0].place.column, fault.column);
  EXPECT_THAT(found[0].message, HasSubstr(fault.words));
}

INSTANTIATE_TEST_SUITE_P(
    Programs, ImplausibleEntry,
    ::testing::Values(
        Fault{"G10 L1 P1 Z-5", 2, "tool 1, edge 1, length: -5 mm is less than 0 mm"},
        Fault{"G4 P0.1\nG10 L1 P1 Z99999", 3, "more than 500 mm (tool_length_max)"},
        Fault{"G10 L1 P1 R5000", 2, "radius: 5000 mm is more than 250 mm (tool_radius_max)"},
        Fault{"G10 L2 P1 X99999", 2, "G54 X: 99999 mm is more than"},
        Fault{"settable_zs (1, 3, Y, -99999);", 2, "G56 Y: -99999 mm is less than"},
        Fault{"settable_tool (1, 1, \"wear_radius\", 80);", 2,
              "80 mm is more than 2 mm (wear_max)"},
        Fault{"if (settable_tool (1, 1, \"wear_length\", 80)) { M0\n}", 2, "(wear_max)", 5}));

TEST(ImplausibleEntries, OfVariablesOfADialectAreFound) {
  const Diagnostics found =
      checked_on("mill3_probe.toml", "(dialect fanuc)\nG21 G90\n#5221=99999\nM30\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E5022");
  EXPECT_EQ(found[0].place.line, 3);
}

// A lathe has tools whose length along Z is negative, a mill has none.
TEST(ImplausibleEntries, DependOnTheMachine) {
  const std::string program = "G21 G18 G90 G94\nG10 L1 P1 Z-40\nM30\n";
  EXPECT_TRUE(checked_on("lathe.toml", program).empty());
  EXPECT_EQ(checked_on("mill3_probe.toml", program).size(), 1U);
}

}  // namespace
}  // namespace stanok::jobs
