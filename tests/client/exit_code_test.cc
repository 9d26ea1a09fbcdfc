// Exit codes of the real `stanok`: a script that calls it must be able to tell what happened.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "protocol/contract/json_rpc.h"
#include "tests/client/fake_server.h"
#include "tests/client/stanok_program.h"
#include "tests/support/project_folders.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

const std::string machine_file = stanok::testing::source_folder() + "/config/machines/mill3.toml";

int exit_code_of(const std::string& arguments) {
  const int status = std::system((stanok_program + " " + arguments + " >/dev/null 2>&1").c_str());
  EXPECT_TRUE(WIFEXITED(status)) << arguments;
  return WEXITSTATUS(status);
}

// Of a command whose daemon gives this answer.
int exit_code_after(const std::string& answer) {
  const FakeServer server([&](int c) {
    say(c, hello);
    EXPECT_EQ(json::parse(heard(c))["method"], "program.start");
    say(c, answer);
  });
  return exit_code_of("--socket " + server.path().string() + " program start --wait");
}

TEST(ExitCode, IsZeroWhenItWasDone) {
  EXPECT_EQ(exit_code_after(protocol::answer_line(1, {{"accepted", true}})), 0);
  EXPECT_EQ(exit_code_of("--version"), 0);
  EXPECT_EQ(exit_code_of("explain E6006"), 0);
  EXPECT_EQ(exit_code_of("explain 6006"), 0);
  EXPECT_EQ(exit_code_of("explain 60066"), 1);
}

// The daemon has answered, and the answer is that the program is wrong.
TEST(ExitCode, IsSixWhenADaemonFindsErrorsInAProgram) {
  const json answer = {{"program", "a.nc"},
                       {"ok", false},
                       {"diagnostics", {{{"code", "E4031"}, {"severity", "error"}}}}};
  const FakeServer server([&](int c) {
    say(c, hello);
    EXPECT_EQ(json::parse(heard(c))["method"], "program.check");
    say(c, protocol::answer_line(1, answer));
  });
  EXPECT_EQ(exit_code_of("--socket " + server.path().string() + " program check a.nc"), 6);
}

struct FailedCase {
  FailureKind kind;
  int exit_code;
};

TEST(ExitCode, TellsTheKindOfAFailure) {
  const std::vector<FailedCase> cases = {
      {FailureKind::refused, 1},       {FailureKind::invalid_parameters, 2},
      {FailureKind::timed_out, 4},     {FailureKind::not_permitted, 5},
      {FailureKind::program_error, 6}, {FailureKind::machine_fault, 7},
  };
  for (const FailedCase& given : cases) {
    const Failure failure{given.kind, "", "no", 1, {}};
    EXPECT_EQ(exit_code_after(protocol::failure_line(1, failure)), given.exit_code);
  }
}

TEST(ExitCode, IsTwoWhenTheCommandLineIsWrong) {
  for (const char* line : {"", "dance", "program run", "override feed much", "override feed 201",
                           "channel status --chanel 1", "subscribe weather"}) {
    EXPECT_EQ(exit_code_of(line), 2) << line;
  }
}

// An option that may be repeated takes one value each time: what stands behind it is the program.
TEST(ExitCode, IsZeroWhereverTheOptionsStand) {
  const std::string program = example_folder + "helix.nc";
  for (const std::string& line :
       {"check --scheme 1=1 " + program, "interpret --scheme 1=1 " + program,
        "simulate --scheme 1=1 " + program, "simulate --tip-trace 1=/dev/null " + program,
        "simulate --axis-trace 1=/dev/null " + program})
    EXPECT_EQ(exit_code_of(line + " --machine " + machine_file), 0) << line;
}

TEST(ExitCode, IsThreeWhenThereIsNoDaemon) {
  EXPECT_EQ(exit_code_of("--socket /nonexistent/op.sock machine status"), 3);
  const FakeServer gone([](int) {});
  EXPECT_EQ(exit_code_of("--socket " + gone.path().string() + " machine status"), 3);
}

TEST(ExitCode, IsSixWhenAProgramHasErrors) {
  EXPECT_EQ(exit_code_of("check " + example_folder + "helix.nc --machine " + machine_file), 0);
  std::string pattern = (std::filesystem::temp_directory_path() / "stanok-exit-XXXXXX").string();
  const std::filesystem::path folder = ::mkdtemp(pattern.data());
  const std::string bad = (folder / "bad.nc").string();
  EXPECT_EQ(std::system(("echo 'G1 X1 F' > " + bad).c_str()), 0);
  EXPECT_EQ(exit_code_of("check " + bad + " --machine " + machine_file), 6);
  std::filesystem::create_directory(folder / "below");
  EXPECT_EQ(exit_code_of("check " + (folder / "below").string() + " --machine " + machine_file), 2);
  std::filesystem::rename(bad, folder / "below" / "BAD.NC");
  EXPECT_EQ(exit_code_of("check " + folder.string() + " --machine " + machine_file), 6);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace stanok::client
