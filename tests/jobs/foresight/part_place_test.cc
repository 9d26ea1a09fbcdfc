// Where a planned path lies on the part, beside matrices made by hand: work offsets, tilted planes,
// rotary tables with and without the tip that follows them, a spindle that is an axis.
#include "jobs/foresight/part_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <thread>

#include "jobs/foresight/foresight.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr double rounding_mm = 1e-4;  // of Float32 at some hundred millimetres

struct PathPoint {
  Vector3d in_W;
  Vector3d on_part;
  std::uint32_t line;
  bool begins;
};

Vector3d vector_of(const std::array<float, 3>& place) {
  return {place[0], place[1], place[2]};
}

// The whole planned path of a program on a machine of the project.
std::vector<PathPoint> planned_on(const std::string& machine, const std::string& text) {
  const stanok::testing::TemporaryDirectory folder;
  const auto file = config::read_machine_file(
      std::filesystem::path(stanok::testing::source_folder()) / "config/machines" / machine);
  std::ofstream(folder.path() / "part.nc") << text;
  channels::CycleOutput now;
  now.channel_count = static_cast<int>(file.machine.channels.size());
  for (std::size_t k = 0; k < file.machine.channels.size(); ++k) {
    now.channels[k].id = file.machine.channels[k].id;
    now.channels[k].scheme = file.machine.channels[k].scheme;
  }
  Foresight foresight(
      file, {folder.path()}, [](const recording::PathPreview&) {},
      [](const std::string& obstacle) { ADD_FAILURE() << obstacle; });
  foresight.look_at(1, "part.nc", now, file.machine.tables);
  const auto path = foresight.planned_path(1);
  constexpr int looks_max = 18'000;
  for (int n = 0; n < looks_max && !path->state().is_complete; ++n) {
    if (path->state().given_up != GivenUp::no) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(path->state().is_complete);
  std::vector<PathPoint> points;
  for (std::size_t k = 0; k < path->state().pages; ++k) {
    for (const PathPage::Point& point : path->page(k)->points)
      points.push_back(
          {vector_of(point.place_mm), vector_of(point.on_part_mm), point.line, point.begins});
  }
  return points;
}

std::vector<PathPoint> of_lines(const std::vector<PathPoint>& points, std::uint32_t from,
                                std::uint32_t to) {
  std::vector<PathPoint> some;
  for (const PathPoint& point : points)
    if (!point.begins && point.line >= from && point.line <= to) some.push_back(point);
  return some;
}

TEST(PartPlace, AnotherWorkOffsetIsAnotherPlaceOnThePart) {
  const auto points = planned_on("mill3.toml",
                                 "G21 G90 G17\nG10 L2 P1 X1 Y2 Z-3\nG10 L2 P2 X6 Y9 Z-1\n"
                                 "G54\nG1 X10 F1000\nG55\nG1 X20 Y0 F500\nM30\n");
  const auto first = of_lines(points, 5, 5);
  const auto second = of_lines(points, 7, 7);
  ASSERT_FALSE(first.empty() || second.empty());
  for (const PathPoint& point : first) EXPECT_LT((point.on_part - point.in_W).norm(), rounding_mm);
  const Vector3d from_g54_to_g55(5.0, 7.0, 2.0);
  for (const PathPoint& point : second)
    EXPECT_LT((point.on_part - point.in_W - from_g54_to_g55).norm(), rounding_mm);
}

// I turns about Z, J about the new X: the plane as its matrix says it.
TEST(PartPlace, ATiltedPlaneLiesOnThePartAsItsMatrixSays) {
  const auto points = planned_on(
      "trunnion.toml",
      "G21 G90 G17 G54 T2 M6\nG43 H2\nG0 X0 Y0 Z90\nG68.2 X8 Y-5.5 Z-3 I30 J25 K-15\nG53.1\n"
      "G0 X0 Y0 Z20\nG1 Z0 F1000\nX20\nG3 X30 Y10 I0 J10\nG0 Z30\nG69\nM30\n");
  const Eigen::Matrix3d turn = (AngleAxisd(30.0 * rad_per_deg, Vector3d::UnitZ()) *
                                AngleAxisd(25.0 * rad_per_deg, Vector3d::UnitX()) *
                                AngleAxisd(-15.0 * rad_per_deg, Vector3d::UnitZ()))
                                   .toRotationMatrix();
  for (const PathPoint& point : of_lines(points, 2, 3))
    EXPECT_LT((point.on_part - point.in_W).norm(), rounding_mm) << point.line;
  const auto plane = of_lines(points, 7, 10);
  ASSERT_GT(plane.size(), 4U);
  for (const PathPoint& point : plane) {
    const Vector3d expected = Vector3d(8.0, -5.5, -3.0) + turn * point.in_W;
    EXPECT_LT((point.on_part - expected).norm(), rounding_mm) << point.line;
  }
}

// The part stands upright in the picture also where a program first moves in a plane.
TEST(PartPlace, APathThatBeginsInATiltedPlaneLiesUpright) {
  const auto points = planned_on("trunnion.toml",
                                 "G21 G90 G17 G54 T2 M6\nG43 H2\nG68.2 X8 Y-5.5 Z-3 I0 J25 K0\n"
                                 "G53.1\nG0 X0 Y0 Z20\nG1 Z0 F1000\nX20\nM30\n");
  const Eigen::Matrix3d turn = AngleAxisd(25.0 * rad_per_deg, Vector3d::UnitX()).toRotationMatrix();
  const auto plane = of_lines(points, 6, 7);
  ASSERT_FALSE(plane.empty());
  for (const PathPoint& point : plane) {
    const Vector3d expected = Vector3d(8.0, -5.5, -3.0) + turn * point.in_W;
    EXPECT_LT((point.on_part - expected).norm(), rounding_mm) << point.line;
  }
}

// With G43.4 W turns with the table itself.
TEST(PartPlace, UnderATipThatFollowsItIsTheWorkpieceSystem) {
  const auto points = planned_on("trunnion.toml",
                                 "G21 G90 G17 G54 T2 M6\nG43.4 H2\nG0 X0 Y0 Z90 A0 C0\n"
                                 "G1 X-30 Y-20 Z5 A-10 C0 F3000\nX30 A-25 C60\nM30\n");
  const auto tips = of_lines(points, 4, 5);
  ASSERT_GT(tips.size(), 1U);
  for (const PathPoint& point : tips)
    EXPECT_LT((point.on_part - point.in_W).norm(), rounding_mm) << point.line;
}

// The table turns beneath the tool: on the part the tip goes round the axis of C, against the
// table.
TEST(PartPlace, ATableThatTurnsCarriesThePart) {
  const auto points = planned_on("trunnion.toml",
                                 "G21 G90 G17 G54 T2 M6\nG43 H2\nG0 X30 Y0 Z10\nG1 C90 F3000\n"
                                 "G1 Y10 F1000\nM30\n");
  const auto round = of_lines(points, 4, 4);
  ASSERT_GT(round.size(), 10U) << "an arc, no chord";
  for (const PathPoint& point : round)
    EXPECT_NEAR(std::hypot(point.on_part.x(), point.on_part.y()), 30.0, 0.001);
  const auto& quarter = round.back().on_part;
  EXPECT_NEAR(std::abs(quarter.y()), 30.0, 0.001);
  // Where the table has turned the part by 90 deg, Y of the machine is X of the part, or -X: a
  // cutter at (0, 30) of the part moves to -X, one at (0, -30) to +X.
  const Vector3d way = of_lines(points, 5, 5).back().on_part - quarter;
  EXPECT_NEAR(way.norm(), 10.0, 0.001);
  EXPECT_NEAR(way.x() * quarter.y(), -300.0, 0.05);
}

// Tools count with their length, whatever length the program has chosen.
TEST(PartPlace, WithoutALengthTheTipIsWhereItIs) {
  const auto points = planned_on(
      "trunnion.toml", "G21 G90 G17 G54 T2 M6\nG49 G1 X10 Z300 F1000\nG43 H2\nX20\nM30\n");
  const auto without = of_lines(points, 2, 2);
  ASSERT_FALSE(without.empty());
  constexpr double length_of_tool = 130.0;
  for (const PathPoint& point : without)
    EXPECT_LT((point.on_part - point.in_W + Vector3d(0.0, 0.0, length_of_tool)).norm(),
              rounding_mm);
  for (const PathPoint& point : of_lines(points, 4, 4))
    EXPECT_LT((point.on_part - point.in_W).norm(), rounding_mm);
}

TEST(PartPlace, ATurnedPartLiesAsItIsProgrammed) {
  const auto points =
      planned_on("lathe.toml",
                 "G21 G90 G18 G7 G40 G54\nT0101\nG97 S1200 M3\nG95 G0 X70 Z5\n"
                 "G1 X40 F0.3\nZ0\nG3 X60 Z-10 R10\nG1 X64 Z-30\nG0 X80 Z10\nM30\n");
  ASSERT_GT(points.size(), 6U);
  for (const PathPoint& point : of_lines(points, 4, 9))
    EXPECT_LT((point.on_part - point.in_W).norm(), rounding_mm) << point.line;
}

// A milling tool beside a part that is turned as an axis goes round it.
TEST(PartPlace, ASpindleThatIsAnAxisCarriesThePart) {
  const auto points = planned_on("lathe.toml",
                                 "G21 G90 G18 G7 G40 G54\nT0301\nM902 H1=1\n$2 S4000 M3\n"
                                 "G94 G8 G0 X40 Z-8 C0\nG1 C90 F3000\nM30\n");
  const auto round = of_lines(points, 6, 6);
  ASSERT_GT(round.size(), 10U) << "an arc, no chord";
  for (const PathPoint& point : round) {
    EXPECT_NEAR(std::hypot(point.on_part.x(), point.on_part.y()), 40.0, 0.001);
    EXPECT_NEAR(point.on_part.z(), -8.0, rounding_mm);
  }
  EXPECT_NEAR(std::abs(round.back().on_part.y()), 40.0, 0.001);
}

}  // namespace
}  // namespace stanok::jobs
