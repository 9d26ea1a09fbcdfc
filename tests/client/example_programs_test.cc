// The example programs of the project run to their end on the machines they are written for, and
// their logs repeat bit for bit.
//
// Not here, since they need generated programs: master.nc (./start runs it), master_on_blanks.nc
// with car_body.nc and blade.nc (tests/peers/workpiece.sh).
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>

#include "tests/client/stanok_program.h"
#include "tests/support/project_folders.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

const std::string root = stanok::testing::source_folder();

struct Example {
  const char* name;
  const char* machine;
  const char* scheme;  // active at the start; "" that of power-on
};

void PrintTo(const Example& example, std::ostream* stream) {
  *stream << example.name;
}

class ExampleProgram : public ::testing::TestWithParam<Example> {};

void expect_success(const std::string& command) {
  const int status = std::system((command + " >/dev/null").c_str());
  ASSERT_TRUE(WIFEXITED(status)) << command;
  EXPECT_EQ(WEXITSTATUS(status), 0) << command;
}

TEST_P(ExampleProgram, RunsToItsEndOnItsMachineAndRepeats) {
  const Example& example = GetParam();
  std::string command = stanok_program + " simulate " + example_folder + example.name +
                        ".nc --machine " + root + "/config/machines/" + example.machine + ".toml";
  if (*example.scheme != '\0') command += std::string(" --scheme 1=") + example.scheme;
  if (testing::is_sanitized) return expect_success(command);  // logs are repeated in release
  const testing::TemporaryDirectory folder;
  const std::string log = (folder.path() / "run.lcm").string();
  expect_success(command + " --log " + log);
  expect_success(stanok_program + " log verify " + log);
}

constexpr Example example_programs[] = {
    {"square_and_circle", "mill3", ""}, {"helix", "mill3", ""},
    {"bolt_circle", "mill3", ""},       {"tilted_pocket", "e7106mf4", "2"},
    {"trunnion", "trunnion", ""},       {"lathe", "lathe", ""},
    {"millturn4", "millturn4", ""},     {"helix", "mill5", ""},
    {"helix", "stress8", ""},           {"thread", "lathe", ""},
    {"chip_breaking", "lathe", ""},     {"slender_shaft", "lathe", ""},
    {"plunge_grinding", "grinder", ""}, {"adaptive_steps", "lathe", ""},
    {"workpiece", "e7106mf4", ""},      {"turned_part", "lathe", ""},
};
// Touched by a probe in many places.
constexpr Example long_programs[] = {
    {"measured_part", "mill3_probe", ""},
};

std::string name_of(const ::testing::TestParamInfo<Example>& example) {
  return std::string(example.param.name) + "_on_" + example.param.machine;
}

INSTANTIATE_TEST_SUITE_P(All, ExampleProgram, ::testing::ValuesIn(example_programs), name_of);
INSTANTIATE_TEST_SUITE_P(FullSize, ExampleProgram, ::testing::ValuesIn(long_programs), name_of);

TEST(ExamplePrograms, ExistForEveryMachineFile) {
  std::set<std::string> machines;
  for (const Example& example : example_programs) machines.insert(example.machine);
  for (const Example& example : long_programs) machines.insert(example.machine);
  for (const auto& entry : std::filesystem::directory_iterator(root + "/config/machines")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_TRUE(machines.contains(entry.path().stem().string())) << entry.path();
  }
}

}  // namespace
}  // namespace stanok::client
