// check_program over several files: what is dispatched is followed, and what is said of files that
// are not included does not contradict it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class TextsInMemory : public lang::Files {
 public:
  explicit TextsInMemory(std::map<std::string, std::string> texts) : texts_(std::move(texts)) {}
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view) const override {
    const auto found = texts_.find(std::string(name));
    if (found != texts_.end())
      return std::make_shared<const lang::SourceText>(
          lang::SourceText{found->first, found->first, found->second});
    Diagnostic missing;
    missing.code = "E7001";
    missing.message = "the file was not found: " + std::string(name);
    return tl::unexpected(missing);
  }

 private:
  std::map<std::string, std::string> texts_;
};

Diagnostics found_on_channel(int channel, std::map<std::string, std::string> texts) {
  const auto file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "e7106mf4.toml");
  return check_program(file.machine, channel, -1, "main.nc", TextsInMemory(std::move(texts)))
      .diagnostics;
}

// The worker is looked at although it is no part of the program: the warning must not say that it
// is not, beside an error that was found there.
TEST(ProgramCheck, FindsErrorsOfAWorkerAndDoesNotSayThatItIsNotChecked) {
  const Diagnostics found = found_on_channel(
      2, {{"main.nc", "channel_run (1, \"work.nc\");\nM30\n"}, {"work.nc", "G0 X1 Q5\nG4\nM30\n"}});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].code, "W710");
  EXPECT_EQ(found[0].message, "\"work.nc\" is not included; it is looked for at run time");
  EXPECT_EQ(found[0].help, std::vector<std::string>{"add `#include \"work.nc\"`"});
  EXPECT_EQ(found[1].place.file, "work.nc");
  EXPECT_EQ(found[1].code, "E4003");
  EXPECT_EQ(found[2].code, "E4007");
  for (const Diagnostic& diagnostic : found)
    EXPECT_THAT(to_text(diagnostic), Not(HasSubstr("not checked")));
}

TEST(ProgramCheck, SaysOfACalledFileWhetherItWasFound) {
  const Diagnostics there = found_on_channel(
      1, {{"main.nc", "call (\"sub.nc\");\nM30\n"}, {"sub.nc", "G0 X1 Q5\nM99\n"}});
  ASSERT_EQ(there.size(), 2U);
  EXPECT_EQ(there[0].code, "W710");
  EXPECT_EQ(there[0].message, "\"sub.nc\" is called without being included");
  EXPECT_EQ(there[1].place.file, "sub.nc");
  EXPECT_EQ(there[1].code, "E4003");
  const Diagnostics missing = found_on_channel(1, {{"main.nc", "call (\"no.nc\");\nM30\n"}});
  ASSERT_EQ(missing.size(), 2U);
  EXPECT_EQ(missing[0].code, "E7005");
  EXPECT_EQ(missing[1].message, "\"no.nc\" is not included and was not found");
}

}  // namespace
}  // namespace stanok::jobs
