// The situations of a log say what its setpoints mean: with the terms of the message, as
// messages/situation_t.lcm writes them down, each programmed point leads to its machine position,
// and each word of the program to where its block ends.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <stanok_messages/setpoint_t.hpp>
#include <stanok_messages/situation_t.hpp>
#include <string>
#include <vector>

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode.h"
#include "recording/log/log_reader.h"
#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::runtime {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Vector vector_of(const double* values) {
  return Eigen::Map<const Vector>(values);
}
Matrix turn_of(const double (&rows)[3][3]) {
  return Eigen::Map<const Matrix>(&rows[0][0]);
}

// As the comment of the message says, for a machine of three linear axes.
Vector base_of(const situation_t& s, const Vector& p_W) {
  const Vector in_plane =
      vector_of(s.plane_shift) + turn_of(s.rotation_turn) * p_W + vector_of(s.rotation_shift);
  const Vector shifted = vector_of(s.local_shift) + vector_of(s.axis_shift) +
                         turn_of(s.plane_turn) * in_plane + vector_of(s.plane_origin);
  Vector overhang = Vector::Zero();
  if (s.overhang_axis >= 0) overhang[s.overhang_axis] = s.overhang;
  return vector_of(s.work_offset) - overhang +
         turn_of(s.work_turn) *
             (turn_of(s.set_up_error_turn) * shifted + vector_of(s.set_up_error_shift));
}

Vector words_of(const situation_t& s, const Vector& p_W) {
  return (p_W - vector_of(s.shift)).cwiseQuotient(vector_of(s.gain));
}

struct Shown {
  situation_t situation;
  setpoint_t setpoint;
};

// Each setpoint with the situation told before it.
std::vector<Shown> shown_in(const std::filesystem::path& file) {
  auto reader = recording::LogReader::open(file);
  if (!reader) return {};
  std::vector<Shown> all;
  std::optional<situation_t> newest;
  while (const auto event = reader->next()) {
    const std::string_view topic = recording::topic_of(event->channel);
    if (topic == "SITUATION") newest = recording::decode<situation_t>(event->bytes);
    if (topic != "SETPOINT") continue;
    const auto setpoint = recording::decode<setpoint_t>(event->bytes);
    EXPECT_TRUE(newest && setpoint);
    if (newest && setpoint) all.push_back({*newest, *setpoint});
  }
  return all;
}

std::vector<Shown> shown_on(const std::string& machine, const std::string& program) {
  const stanok::testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "part.nc") << program;
  const std::filesystem::path log = folder.path() / "run.lcm";
  SimulationOptions options;
  options.file = config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                           "config" / "machines" / machine);
  options.program_roots = {folder.path()};
  options.programs = {{1, "part.nc"}};
  {
    LogObserver observer(options.file, setup_of(options), log.string(), "test");
    EXPECT_TRUE(simulate(options, {&observer}, [] { return false; }).ok);
    EXPECT_EQ(observer.close(), "");
  }
  return shown_in(log);
}

std::string codes_of(const situation_t& situation) {
  return std::string(recording::text_of(situation.codes));
}

TEST(SituationInLogs, LeadsFromEachPointToItsMachinePosition) {
  const auto shown = shown_on("mill3.toml",
                              "G21 G90 G17 G61.1\n"
                              "G10 L2 P2 X10 Y20 Z-30 R30\n"
                              "G10 L1 P1 Z40 R3\n"
                              "T1 M6\n"
                              "G55 G43 H1\n"
                              "G1 X10 Y3 Z4 F6000\n"  // 6
                              "G52 X1 Y-2 Z3\n"       //
                              "G1 X11 Y4 Z5\n"        // 8
                              "G68 X5 Y5 R20\n"       //
                              "G1 X12 Y6\n"           // 10
                              "G51 X2 Y1 Z0 P2\n"     //
                              "G1 X13 Y7 Z1\n"        // 12
                              "G50\nG69\n"            //
                              "G92 X0 Y0\n"           //
                              "G1 X3 Y1\n"            // 16
                              "G43.1 Z12.5\n"         //
                              "G1 X4 Y2 Z6\n"         // 18
                              "G20\n"                 //
                              "G1 X1\n"               // 20: 25.4 mm
                              "M30\n");
  std::map<int, Vector> ends;
  for (const Shown& at : shown) {
    const Vector p_W = vector_of(at.setpoint.tip_position);
    // A block that changes frame and length takes a cycle for each while the axes stand.
    if (at.setpoint.path_speed == 0.0 && at.setpoint.line == 5) continue;
    const Vector p_M = base_of(at.situation, p_W) + vector_of(at.situation.length);
    ASSERT_LT((p_M - vector_of(at.setpoint.position)).norm(), 1e-9)
        << "line " << at.setpoint.line << ", " << codes_of(at.situation);
    ends[at.setpoint.line] = words_of(at.situation, p_W);
  }
  const std::map<int, Vector> programmed{{6, {10, 3, 4}},   {8, {11, 4, 5}}, {10, {12, 6, 5}},
                                         {12, {13, 7, 1}},  {16, {3, 1, 1}}, {18, {4, 2, 6}},
                                         {20, {25.4, 2, 6}}};
  constexpr double last_cycle = 1e-4;  // mm: the way of the last cycle before the axes stand
  for (const auto& [line, words] : programmed) {
    ASSERT_TRUE(ends.contains(line)) << line;
    EXPECT_LT((ends[line] - words).head<2>().norm(), last_cycle) << line << ": " << ends[line];
  }
  EXPECT_NEAR(ends[18].z(), 6.0, last_cycle);
}

TEST(SituationInLogs, TellsCodesToolAndUnits) {
  const auto shown =
      shown_on("lathe.toml", "G21 T0101\nG0 X100 Z0\nG55\nG0 X90\nG20\nG0 X4\nM30\n");
  std::map<int, situation_t> of_line;
  for (const Shown& at : shown) of_line[at.setpoint.line] = at.situation;
  ASSERT_TRUE(of_line.contains(2) && of_line.contains(4) && of_line.contains(6));
  EXPECT_EQ(of_line[2].tool, 1);
  EXPECT_EQ(of_line[2].length_tool, 1);
  EXPECT_EQ(of_line[2].work_offset_number, 1);
  EXPECT_EQ(of_line[2].diameter[0], 1);
  EXPECT_EQ(of_line[2].inches, 0);
  EXPECT_NE(codes_of(of_line[2]).find("G54"), std::string::npos) << codes_of(of_line[2]);
  EXPECT_EQ(of_line[4].work_offset_number, 2);
  EXPECT_NE(codes_of(of_line[4]).find("G55"), std::string::npos) << codes_of(of_line[4]);
  EXPECT_EQ(of_line[6].inches, 1);
  EXPECT_GT(of_line[6].number, of_line[4].number);
  // M30 leaves the default state behind, and the last setpoint says so.
  EXPECT_EQ(shown.back().situation.work_offset_number, 1);
  EXPECT_EQ(shown.back().situation.inches, 0);
}

}  // namespace
}  // namespace stanok::runtime
