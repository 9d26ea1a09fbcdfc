// The virtual workpiece of whole simulated runs: findings with their lines, zeros and switches that
// are followed, announcements that cannot be.
#include "client/offline/workpiece/simulated_parts.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "client/offline/workpiece/streamed_workpieces.h"
#include "recording/format/decode.h"
#include "recording/log/log_reader.h"
#include "runtime/log_observer.h"
#include "runtime/recorded_run.h"
#include "tests/support/project_folders.h"

namespace stanok::client {
namespace {

using runtime::WorkpieceStream;

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::filesystem::path machines =
    std::filesystem::path(stanok::testing::source_folder()) / "config" / "machines";

// Programs that are run on a machine of the project.
class WorkpieceRun : public ::testing::Test {
 protected:
  WorkpieceRun() {
    folder_ = std::filesystem::temp_directory_path() /
              ("stanok_workpiece_" + std::to_string(getpid()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    log_ = folder_ / "run.lcm";
  }
  ~WorkpieceRun() override { std::filesystem::remove_all(folder_); }

  // The JSON of its workpieces.
  nlohmann::ordered_json run(const std::string& machine, const std::string& program,
                             int scheme = 0) {
    std::ofstream(folder_ / "part.nc") << program;
    runtime::SimulationOptions options;
    options.file = config::read_machine_file(machines / machine);
    options.program_roots = {folder_};
    options.programs = {{1, "part.nc"}};
    if (scheme != 0) options.schemes = {{1, scheme}};
    WorkpieceOptions wanted;
    wanted.files.report = folder_ / "report.json";
    SimulatedParts parts(options.file, wanted);
    options.workpieces = parts.workpieces();
    runtime::LogObserver log(options.file, runtime::setup_of(options), log_, "test");
    const auto result = runtime::simulate(options, {&log}, [] { return false; });
    EXPECT_EQ(log.close(), "");
    for (const auto& alarm : result.alarms)
      ADD_FAILURE() << alarm.diagnostic.place.line << ": " << alarm.diagnostic.message;
    finished_ = parts.finish(result.runs, RunWas::whole);
    return parts.json();
  }

  // The JSON of the one workpiece in the log, without the messages on channels that end so.
  [[nodiscard]] nlohmann::ordered_json out_of_log(const std::string& left_out = "none") const {
    const auto recorded = runtime::read_run(log_);
    WorkpieceStream stream(recorded->beginning.machine.machine, simulation::memory_default,
                           complain, recorded->files.get());
    auto reader = recording::LogReader::open(log_);
    while (const auto event = reader->next()) {
      if (!event->channel.ends_with(left_out)) stream.take(event->channel, event->bytes);
    }
    const auto workpieces = streamed_workpieces(stream);
    EXPECT_EQ(workpieces.size(), 1U);
    EXPECT_EQ(workpieces.at(0).title, "part.nc");
    return to_json(workpieces.at(0), file_names_of(stream));
  }

  // What is missing of the log when the setpoints of these cycles did not come.
  [[nodiscard]] WorkpieceStream::Missing missing_without(std::int64_t from, std::int64_t to) const {
    const auto recorded = runtime::read_run(log_);
    WorkpieceStream stream(recorded->beginning.machine.machine, simulation::memory_default,
                           complain, recorded->files.get());
    auto reader = recording::LogReader::open(log_);
    while (const auto event = reader->next()) {
      const auto setpoint = recording::decode<setpoint_t>(event->bytes);
      const bool is_setpoint = event->channel.ends_with("_SETPOINT") && setpoint.has_value();
      if (is_setpoint && from <= setpoint->cycle && setpoint->cycle < to) continue;
      stream.take(event->channel, event->bytes);
    }
    return stream.missing();
  }

  std::filesystem::path folder_;
  std::filesystem::path log_;
  bool finished_ = false;
};

// Lines with a mark in front are in the program with errors only.
std::string program_with(bool errors) {
  const std::string marked = R"(G21 G90 G17 G40 G49 G80 G54
#workpiece (0, 0.25, 0, 80, 60, 20, 40, 30, 20)
T4 M6
S9000 M3
G0 X-20 Y-10
G43 H4 Z50
G0 Z2
!G0 Z-1
!G0 Z2
G1 Z-2 F300
G1 X20 F1200
!G0 Y0
!G0 Y-10
G1 X10
G0 Z50
G0 X-55 Y-20
G0 Z-14
G1 X-41 F1000
!G1 Z-18
!G1 Y0
!G1 Z-14
G1 Y20
G0 X-55
!G0 X-64 Z-33
!G1 X-55 F1000
G0 Z50
!M5
G0 X0 Y20
G1 Z-1 F300
G0 Z50
M30
)";
  std::string program;
  std::istringstream lines(marked);
  for (std::string line; std::getline(lines, line);) {
    const bool is_error = line.front() == '!';
    if (is_error && !errors) {
      program += "\n";  // lines keep their numbers
      continue;
    }
    program += (is_error ? line.substr(1) : line) + "\n";
  }
  return program;
}

std::vector<std::pair<std::string, int>> findings_of(const nlohmann::ordered_json& workpiece) {
  std::vector<std::pair<std::string, int>> findings;
  for (const auto& finding : workpiece["findings"])
    findings.emplace_back(finding["code"], finding["line"]);
  return findings;
}

TEST_F(WorkpieceRun, FindsTheFivePlantedErrors) {
  const auto workpieces = run("e7106mf4.toml", program_with(true));
  EXPECT_TRUE(finished_);
  ASSERT_EQ(workpieces.size(), 1U);
  EXPECT_THAT(findings_of(workpieces[0]),
              ElementsAre(std::pair("W921", 8), std::pair("W921", 12), std::pair("W922", 20),
                          std::pair("W923", 25), std::pair("W924", 29)));
  for (const auto& finding : workpieces[0]["findings"]) EXPECT_EQ(finding["file"], "part.nc");
}

TEST_F(WorkpieceRun, FindsNothingWithoutThem) {
  const auto workpieces = run("e7106mf4.toml", program_with(false));
  ASSERT_EQ(workpieces.size(), 1U);
  EXPECT_THAT(findings_of(workpieces[0]), IsEmpty());
  EXPECT_GT(workpieces[0]["removed_mm3"], 500.0);
}

// The log knows machine, tools, programs and blank by itself.
TEST_F(WorkpieceRun, IsTheSameOutOfItsLog) {
  const auto live = run("e7106mf4.toml", program_with(true));
  const auto recorded = out_of_log();
  EXPECT_DOUBLE_EQ(recorded["removed_mm3"].get<double>(), live[0]["removed_mm3"].get<double>());
  EXPECT_EQ(recorded["findings"], live[0]["findings"]);
}

// The file of a finding is the one that the block stands in, in a run and out of its log.
TEST_F(WorkpieceRun, NamesTheCalledFile) {
  std::ofstream(folder_ / "called.nc") << "%\nG0 Z-1\nG0 X20\nG0 Z50\nM99\n%\n";
  const auto live = run("e7106mf4.toml", R"(#include "called.nc"
G21 G90 G17 G40 G49 G80 G54
#workpiece (0, 0.5, 0, 80, 60, 20, 40, 30, 20)
T3 M6
S9000 M3
G0 X-60 Y0
G43 H3 Z50
call ("called.nc");
M30
)");
  ASSERT_EQ(live.size(), 1U);
  EXPECT_EQ(live[0]["program"], "part.nc");
  EXPECT_THAT(findings_of(live[0]), ElementsAre(std::pair("W921", 3)));
  EXPECT_EQ(live[0]["findings"][0]["file"], "called.nc");
  EXPECT_EQ(out_of_log()["findings"], live[0]["findings"]);
}

TEST_F(WorkpieceRun, SaysWhenThereIsNone) {
  EXPECT_TRUE(run("e7106mf4.toml", "G21 G90\nG0 X1\nM30\n").empty());
  EXPECT_FALSE(finished_);
}

TEST_F(WorkpieceRun, RefusesAResolutionThatIsTooFine) {
  EXPECT_TRUE(
      run("e7106mf4.toml", "G21 G90\n#workpiece (0, 0.001, 0, 80, 60, 20, 0, 0, 0)\nG0 X1\nM30\n")
          .empty());
  EXPECT_FALSE(finished_);
}

// A groove of 6 x 2 over the whole width, once as seen from G54 and once from G55, which lies 10 mm
// further: the blank stays where it was announced.
TEST_F(WorkpieceRun, FollowsChangesOfTheZero) {
  const auto workpieces = run("e7106mf4.toml", R"(G21 G90 G17 G40 G49 G80
G10 L2 P1 X0 Y0 Z0
G10 L2 P2 X10 Y0 Z0
G54
#workpiece (0, 0.25, 0, 80, 60, 20, 40, 30, 20)
T3 M6
S9000 M3
G0 X-20 Y-40
G43 H3 Z50
G0 Z-2
G1 Y40 F1200
G0 Z50
G55
G0 X-30 Y-40
G0 Z-2
G1 Y40
G0 Z50
G0 X-20 Y-40
G0 Z-2
G1 Y40
G0 Z50
M30
)");
  ASSERT_EQ(workpieces.size(), 1U);
  EXPECT_NEAR(workpieces[0]["removed_mm3"], 2 * 60.0 * 6.0 * 2.0, 10.0);
  EXPECT_THAT(findings_of(workpieces[0]), IsEmpty());
}

// A groove of 6 x 2 along X in the vise; then the part goes to the table as it is, its zero on the
// axis of the table (Z -150: the nose hangs 200 under the pivot, the table lies at -350), and gets
// one along Y while the table stands turned.
TEST_F(WorkpieceRun, FollowsThePartFromTheViseToTheTable) {
  const auto workpieces = run("e7106mf4.toml", R"(G21 G90 G17 G40 G49 G80 G54
#workpiece (0, 0.25, 0, 80, 60, 20, 40, 30, 20)
T3 M6
S9000 M3
G0 X-50 Y0
G43 H3 Z50
G0 Z-2
G1 X50 F1200
G0 Z50
G49
#kinematics (2, 1)
#workpiece_pos (0, 0, -150, 0, 0, 0)
G0 B0 C30
G0 G43.4 H3 X0 Y-50 Z50
G0 Z-2
G1 Y50 F1200
G0 Z50
G49
M30
)",
                              1);
  ASSERT_EQ(workpieces.size(), 1U);
  EXPECT_NEAR(workpieces[0]["removed_mm3"], 80.0 * 12.0 + 60.0 * 12.0 - 36.0 * 2.0, 20.0);
  EXPECT_THAT(findings_of(workpieces[0]), IsEmpty());
}

// A pocket with corners of radius R and the volume D (L W - (4 - π) R²): three places and sizes at
// which its faces lie anyhow in the grid, milled with the flat end mill of 6.
TEST_F(WorkpieceRun, APocketWithRoundCornersHasItsVolumeWithinTwoTenThousandths) {
  struct Pocket {
    double length, width, depth, corner, zero_x;
  };
  for (const Pocket& it : {Pocket{40.0, 30.0, 5.0, 5.0, 40.0}, Pocket{36.3, 28.7, 6.2, 6.0, 40.1},
                           Pocket{25.0, 25.0, 8.0, 10.0, 39.93}}) {
    const double x = it.length / 2.0 - 3.0;
    const double y = it.width / 2.0 - 3.0;
    const double r = it.corner - 3.0;
    std::string program = fmt::format(
        "G21 G90 G17 G40 G49 G80 G54\nT3 M6\nS9000 M3\nG0 X0 Y0\nG43 H3 Z50\n"
        "#workpiece (0, 0.25, 0, 80, 60, 20, {}, 30, 20)\nG0 Z2\nG1 Z{} F3000\n",
        it.zero_x, -it.depth);
    for (double part = 0.15; part < 0.8; part += 0.15)
      program += fmt::format("G1 X{0} Y-{1}\nY{1}\nX-{0}\nY-{1}\nX{0}\n", part * x, part * y);
    program += fmt::format(
        "G1 X0 Y-{y}\nX{l}\nG3 X{x} Y-{w} R{r}\nG1 Y{w}\nG3 X{l} Y{y} R{r}\nG1 X-{l}\n"
        "G3 X-{x} Y{w} R{r}\nG1 Y-{w}\nG3 X-{l} Y-{y} R{r}\nG1 X0\nG0 Z50\nM30\n",
        fmt::arg("x", x), fmt::arg("y", y), fmt::arg("l", x - r), fmt::arg("w", y - r),
        fmt::arg("r", r));
    const double volume =
        it.depth * (it.length * it.width - (4.0 - std::numbers::pi) * it.corner * it.corner);
    const auto workpieces = run("e7106mf4.toml", program);
    ASSERT_EQ(workpieces.size(), 1U);
    EXPECT_NEAR(workpieces[0]["removed_mm3"], volume, 2e-4 * volume) << it.length;
    EXPECT_NEAR(workpieces[0]["left_mm3"], 80.0 * 60.0 * 20.0 - volume, 2e-4 * volume);
  }
}

// Slots of 2 x 60 across the block with the flat end mill of 6: one as the table of the machine has
// it, then one after `change`, which is written while the tool is in the spindle.
std::string two_slots(const std::string& change) {
  return R"(G21 G90 G17 G40 G49 G80 G54
#workpiece (0, 0.25, 0, 80, 60, 20, 40, 30, 20)
T3 M6
S9000 M3
G0 X-20 Y-40
G43 H3 Z50
G0 Z-2
G1 Y40 F1200
G0 Z50
)" + change +
         R"(
G43 H3 Z50
G0 X20
G0 Z-2
G1 Y-40
G0 Z50
M30
)";
}

double removed_by_slots(double first_width, double second_width) {
  return (first_width + second_width) * 2.0 * 60.0;
}

constexpr double slots_within_mm3 = 10.0;  // of 1440: the cells at the walls

TEST_F(WorkpieceRun, TheToolHasTheRadiusThatG10Gives) {
  const auto live = run("e7106mf4.toml", two_slots("G10 L1 P3 R2"));
  ASSERT_EQ(live.size(), 1U);
  EXPECT_NEAR(live[0]["removed_mm3"], removed_by_slots(6.0, 4.0), slots_within_mm3);
  const auto recorded = out_of_log();
  EXPECT_DOUBLE_EQ(recorded["removed_mm3"].get<double>(), live[0]["removed_mm3"].get<double>());
  EXPECT_EQ(recorded["findings"], live[0]["findings"]);
}

// The lengths, too: with the old ones the cutter would stay 8 mm above the part.
TEST_F(WorkpieceRun, TheToolHasTheLengthThatG10Gives) {
  const auto live = run("e7106mf4.toml", two_slots("G10 L1 P3 Z90 R1.5"));
  ASSERT_EQ(live.size(), 1U);
  EXPECT_NEAR(live[0]["removed_mm3"], removed_by_slots(6.0, 3.0), slots_within_mm3);
  EXPECT_DOUBLE_EQ(out_of_log()["removed_mm3"].get<double>(), live[0]["removed_mm3"].get<double>());
}

TEST_F(WorkpieceRun, TheToolIsAsSettableToolHasMadeIt) {
  const auto live = run("e7106mf4.toml", two_slots(R"(settable_tool (3, 1, "radius", 2.5);
settable_tool (3, 1, "wear_radius", -0.5);
settable_tool (3, 1, "wear_length", 1);)"));
  ASSERT_EQ(live.size(), 1U);
  EXPECT_NEAR(live[0]["removed_mm3"], removed_by_slots(6.0, 4.0), slots_within_mm3);
  EXPECT_DOUBLE_EQ(out_of_log()["removed_mm3"].get<double>(), live[0]["removed_mm3"].get<double>());
}

// Written before it comes to work, and a log of a version that did not tell of it.
TEST_F(WorkpieceRun, AToolThatComesToWorkIsAsItWasSetBefore) {
  const auto live = run("e7106mf4.toml", R"(G21 G90 G17 G40 G49 G80 G54
G10 L1 P3 R2
#workpiece (0, 0.25, 0, 80, 60, 20, 40, 30, 20)
T3 M6
S9000 M3
G0 X-20 Y-40
G43 H3 Z50
G0 Z-2
G1 Y40 F1200
G0 Z50
M30
)");
  ASSERT_EQ(live.size(), 1U);
  EXPECT_NEAR(live[0]["removed_mm3"], 4.0 * 2.0 * 60.0, slots_within_mm3);
  EXPECT_DOUBLE_EQ(out_of_log()["removed_mm3"].get<double>(), live[0]["removed_mm3"].get<double>());
  EXPECT_NEAR(out_of_log("_TOOL_ROW")["removed_mm3"], 6.0 * 2.0 * 60.0, slots_within_mm3);
}

TEST_F(WorkpieceRun, SetpointsThatAreMissingAreCounted) {
  (void)run("e7106mf4.toml", two_slots(""));
  EXPECT_EQ(missing_without(0, 0).count, 0);
  const auto missing = missing_without(300, 340);
  EXPECT_EQ(missing.count, 40);
  EXPECT_DOUBLE_EQ(missing.first_s, 0.3);
}

}  // namespace
}  // namespace stanok::client
