// Positions of tilted planes, as they are printed, written as JSON and passed between processes.
#include <gtest/gtest.h>

#include "client/offline/check/check_record.h"
#include "client/terminal/plane_table.h"
#include "protocol/contract/plane_json.h"

namespace stanok::client {
namespace {

PlanePosition plane_at(int line, double a_deg, double c_deg) {
  PlanePosition plane;
  plane.place.file = "a.nc";
  plane.place.line = line;
  plane.tool = {-1e-17, -0.5, 0.8660254037844386};
  plane.axes = {{"A", a_deg}, {"C", c_deg}};
  return plane;
}

CheckedProgram program_with_planes() {
  CheckedProgram program;
  program.file = "a.nc";
  program.planes = {plane_at(3, -30.0, 0.0), plane_at(9, -21.801409486, -90.0), plane_at(12, 0, 0)};
  program.planes[0].other = {.word = "P1", .axes = {{"A", 30.0}, {"C", 180.0}}, .limit_deg = {}};
  program.planes[1].other = {.word = "P2", .axes = {{"A", 50.0}}, .limit_deg = 30.0};
  return program;
}

TEST(TiltedPlanes, IsATableOfPositions) {
  EXPECT_EQ(plane_table(protocol::plane_json(program_with_planes().planes), Terminal(Screen::none)),
            "tilted plane  tool on the table  rotary axes     other position\n"
            "a.nc:3        X0 Y-0.5 Z0.866    A-30 C0         P1: A30 C180\n"
            "a.nc:9        X0 Y-0.5 Z0.866    A-21.8014 C-90  P2: A50, but A ends at 30\n"
            "a.nc:12       X0 Y-0.5 Z0.866    A0 C0\n");
  EXPECT_EQ(plane_table(protocol::plane_json({}), Terminal(Screen::none)), "");
}

TEST(TiltedPlanes, HasTheSameInJson) {
  const auto report = protocol::plane_json(program_with_planes().planes);
  ASSERT_EQ(report.size(), 3U);
  EXPECT_EQ(report[0]["line"], 3);
  EXPECT_EQ(report[0]["axes"]["A"], -30.0);
  EXPECT_EQ(report[0]["other"]["word"], "P1");
  EXPECT_EQ(report[0]["other"]["axes"]["C"], 180.0);
  EXPECT_FALSE(report[0]["other"].contains("limit"));
  EXPECT_EQ(report[1]["other"]["limit"], 30.0);
  EXPECT_FALSE(report[2].contains("other"));
}

TEST(TiltedPlanes, PassesBetweenProcesses) {
  const CheckedProgram program = program_with_planes();
  EXPECT_EQ(protocol::plane_json(checked_program(check_record(program)).planes),
            protocol::plane_json(program.planes));
}

}  // namespace
}  // namespace stanok::client
