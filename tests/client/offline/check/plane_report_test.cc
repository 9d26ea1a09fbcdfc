#include "client/offline/check/plane_report.h"

#include <gtest/gtest.h>

#include "client/offline/check/check_record.h"

namespace stanok::client {
namespace {

runtime::PlanePosition plane_at(int line, double a_deg, double c_deg) {
  runtime::PlanePosition plane;
  plane.place.file = "a.nc";
  plane.place.line = line;
  plane.normal_B = {-1e-17, -0.5, 0.8660254037844386};
  plane.axes = {{"A", a_deg}, {"C", c_deg}};
  return plane;
}

CheckedProgram program_with_planes() {
  CheckedProgram program;
  program.file = "a.nc";
  program.planes = {plane_at(3, -30.0, 0.0), plane_at(9, -21.801409486, -90.0), plane_at(12, 0, 0)};
  program.planes[0].other = {
      .first = lang::FirstRotary::positive, .axes = {{"A", 30.0}, {"C", 180.0}}, .limit_deg = {}};
  program.planes[1].other = {
      .first = lang::FirstRotary::negative, .axes = {{"A", 50.0}}, .limit_deg = 30.0};
  return program;
}

TEST(PlaneReport, IsATableOfPositions) {
  EXPECT_EQ(plane_table({program_with_planes()}, Terminal(Screen::none)),
            "tilted plane  tool on the table  rotary axes     other position\n"
            "a.nc:3        X0 Y-0.5 Z0.866    A-30 C0         P1: A30 C180\n"
            "a.nc:9        X0 Y-0.5 Z0.866    A-21.8014 C-90  P2: A50, but A ends at 30\n"
            "a.nc:12       X0 Y-0.5 Z0.866    A0 C0\n");
  EXPECT_EQ(plane_table({CheckedProgram{}}, Terminal(Screen::none)), "");
}

TEST(PlaneReport, HasTheSameInJson) {
  const auto report = plane_json({program_with_planes()});
  ASSERT_EQ(report.size(), 3U);
  EXPECT_EQ(report[0]["line"], 3);
  EXPECT_EQ(report[0]["axes"]["A"], -30.0);
  EXPECT_EQ(report[0]["other"]["word"], "P1");
  EXPECT_EQ(report[0]["other"]["axes"]["C"], 180.0);
  EXPECT_FALSE(report[0]["other"].contains("limit"));
  EXPECT_EQ(report[1]["other"]["limit"], 30.0);
  EXPECT_FALSE(report[2].contains("other"));
}

TEST(PlaneReport, PassesBetweenProcesses) {
  const CheckedProgram program = program_with_planes();
  EXPECT_EQ(plane_json({checked_program(check_record(program))}), plane_json({program}));
}

}  // namespace
}  // namespace stanok::client
