// What `check` takes, `simulate` runs to its end, and what it refuses does not: all examples and
// all conformance programs, each on a machine file. Generated programs: whole_chain_test.cc.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "runtime/program_files.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

const std::filesystem::path project = stanok::testing::source_folder();

// Machine and scheme of examples that need another one than mill5.
struct Surroundings {
  const char* machine = "mill5";
  int channel = 1;
  int scheme = -1;
};
const std::map<std::string, Surroundings> machines_of_examples{
    {"adaptive_steps", {"lathe"}},
    {"chip_breaking", {"lathe"}},
    {"lathe", {"lathe"}},
    {"master", {"e7106mf4", 2}},
    {"master_on_blanks", {"e7106mf4", 2}},
    {"millturn4", {"millturn4"}},
    {"millturn4_lower", {"millturn4", 2}},
    {"millturn4_mill", {"millturn4", 1}},
    {"millturn4_sub", {"millturn4", 1}},
    {"plunge_grinding", {"grinder"}},
    {"measured_part", {"mill3_probe"}},
    {"slender_shaft", {"lathe"}},
    {"thread", {"lathe"}},
    {"tilted_pocket", {"e7106mf4", 1, 2}},
    {"trunnion", {"trunnion"}},
    {"turned_part", {"lathe"}},
    {"workpiece", {"e7106mf4"}},
};

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

Surroundings surroundings_of(const std::filesystem::path& program) {
  const auto known = machines_of_examples.find(program.stem().string());
  const bool is_example = program.parent_path().filename() == "examples";
  if (is_example && known != machines_of_examples.end()) return known->second;
  const std::string text = text_of(program);
  if (text.find("; channel lathe") != std::string::npos) return {"lathe"};
  if (text.find("; channel master") != std::string::npos) return {"e7106mf4", 2};
  return {};
}

// Its fault comes after a dwell of thirty years.
constexpr std::string_view endless = "fault_dwell_for_ever.nc";

std::vector<std::filesystem::path> programs_in(const char* folder) {
  std::vector<std::filesystem::path> found;
  const std::filesystem::path programs = project / "programs" / folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(programs)) {
    const bool is_included = entry.path().parent_path().filename() == "included";
    const bool ends = entry.path().filename() != endless;
    if (entry.path().extension() == ".nc" && !is_included && ends) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

const config::MachineFile& machine_file(const std::string& name) {
  static std::map<std::string, config::MachineFile> read;
  auto found = read.find(name);
  if (found == read.end()) {
    const auto path = project / "config" / "machines" / (name + ".toml");
    found = read.emplace(name, config::read_machine_file(path)).first;
  }
  return found->second;
}

std::vector<std::filesystem::path> roots_of(const std::filesystem::path& program) {
  return {program.parent_path(), project / "programs"};
}

// The first error of `check`; empty: it takes the program.
std::string refusal_of(const Surroundings& on, const std::filesystem::path& program) {
  const config::MachineFile& file = machine_file(on.machine);
  const ProgramFiles files(roots_of(program), program_format(file.machine));
  const auto result =
      jobs::check_program(file.machine, on.channel, on.scheme, program.filename().string(), files);
  for (const Diagnostic& d : result.diagnostics)
    if (d.severity == Severity::error) return d.code + " " + d.message;
  return "";
}

// The longest examples cut for hours; what is refused ends at its fault, wherever it is.
constexpr double time_of_taken_s = 20.0;
constexpr double time_of_refused_s = 3600.0;

// The ideal drives of a simulation have no sensors: no fault of the program.
constexpr std::string_view no_sensor = "A4010";

// Why the run ended before the end of the program; empty: it did not.
std::string fault_of(const Surroundings& on, const std::filesystem::path& program, double until_s) {
  SimulationOptions options;
  options.file = machine_file(on.machine);
  options.program_roots = roots_of(program);
  options.programs = {{on.channel, program.filename().string()}};
  if (on.scheme >= 0) options.schemes = {{on.channel, on.scheme}};
  options.until_s = until_s;
  const SimulationResult result = simulate(options, {}, [] { return false; });
  if (!result.refusals.empty()) return result.refusals.front();
  if (!result.alarms.empty()) {
    const Diagnostic& alarm = result.alarms.front().diagnostic;
    return alarm.code == no_sensor ? "" : alarm.code + " " + alarm.message;
  }
  if (result.ok || result.until_reached) return "";
  return "it did not come to its end";
}

class CheckAndRun : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(CheckAndRun, Agree) {
  const Surroundings on = surroundings_of(GetParam());
  const std::string refusal = refusal_of(on, GetParam());
  const std::string fault =
      fault_of(on, GetParam(), refusal.empty() ? time_of_taken_s : time_of_refused_s);
  EXPECT_EQ(refusal.empty(), fault.empty())
      << GetParam().filename() << " on " << on.machine
      << "\ncheck: " << (refusal.empty() ? "takes it" : refusal)
      << "\nrun: " << (fault.empty() ? "ends well" : fault);
}

std::string name_of(const ::testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name =
      info.param.parent_path().filename().string() + "_" + info.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Examples, CheckAndRun, ::testing::ValuesIn(programs_in("examples")),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Conformance, CheckAndRun, ::testing::ValuesIn(programs_in("conformance")),
                         name_of);

}  // namespace
}  // namespace stanok::runtime
