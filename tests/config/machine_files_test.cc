// The machine files of the project: they are read without a fault and say what they should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"
#include "config/files/machine_file.h"
#include "kinematics/scheme.h"
#include "tests/support/project_folders.h"

namespace stanok::config {
namespace {

const std::filesystem::path machines =
    std::filesystem::path(stanok::testing::source_folder()) / "config" / "machines";

MachineFile machine(const std::string& name) {
  return read_machine_file(machines / (name + ".toml"));
}

class ProjectMachine : public ::testing::TestWithParam<std::string> {};

TEST_P(ProjectMachine, IsReadWithoutFaultAndItsSchemesCanBeMade) {
  const MachineFile file = machine(GetParam());
  EXPECT_EQ(file.machine.name, GetParam());
  ASSERT_FALSE(file.machine.channels.empty());
  for (const channels::ChannelConfig& channel : file.machine.channels) {
    for (const auto& scheme : channel.schemes) {
      EXPECT_NE(kinematics::make_scheme(scheme), nullptr) << kinematics::scheme_defect(scheme);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ProjectMachine,
                         ::testing::Values("e7106mf4", "grinder", "mill3", "mill5", "lathe",
                                           "mill3_probe", "millturn4", "stress8", "trunnion"),
                         [](const auto& name) { return name.param; });

// ISO 5608: the cutting edge angle is the one between the edge and the direction of the feed, here
// -Z: an edge at 95 deg lies 85 deg from +Z, behind the shoulder that the tip cuts. An 80 deg
// insert (C) has its other edge 80 deg from there, one of 35 deg (V) 35 deg.
TEST(MachineFiles, InsertsCutAShoulderWithTheirTip) {
  for (const char* const name : {"lathe", "millturn4"}) {
    for (const channels::ToolEdge& tool : machine(name).machine.tables.tools) {
      if (tool.kind != "insert") continue;
      const bool roughs = tool.name.find("CNMG") != std::string::npos;
      EXPECT_EQ(tool.angle_front, 180.0 - (roughs ? 95.0 : 93.0)) << name << " " << tool.name;
      EXPECT_EQ(tool.angle_front - tool.angle_back, roughs ? 80.0 : 35.0)
          << name << " " << tool.name;
    }
  }
}

// The slide of a front turret goes against the workpiece's X; the tip of the shipped tools lies
// 25 mm beside its reference point.
TEST(MachineFiles, TurretsOfMillturn4ReachFromTheCentreToAWorkpieceOfDiameter200) {
  const MachineFile file = machine("millturn4");
  for (const auto& [name, sign] : {std::pair("X1", 1.0), std::pair("X2", -1.0)}) {
    const auto axis = std::ranges::find(file.machine.axes, name, &channels::AxisConfig::name);
    ASSERT_NE(axis, file.machine.axes.end());
    EXPECT_GT(sign * axis->start, 100.0) << name;
    for (const double radius : {0.0, 100.0}) {
      const double position = sign * (radius - 25.0);
      EXPECT_GE(position, axis->limits.position_min) << name;
      EXPECT_LE(position, axis->limits.position_max) << name;
    }
  }
}

TEST(MachineFiles, E7106mf4HasAWorkChannelWithTwoSchemesAndAMaster) {
  const MachineFile file = machine("e7106mf4");
  ASSERT_EQ(file.machine.channels.size(), 2U);
  const channels::ChannelConfig& work = file.machine.channels[0];
  EXPECT_EQ(work.name, "work");
  EXPECT_EQ(work.words, (std::vector<std::string>{"X", "Y", "Z", "B", "C"}));
  EXPECT_EQ(work.spindles, std::vector<int>{1});
  EXPECT_EQ(work.scheme, 1);
  ASSERT_EQ(work.schemes.size(), 2U);
  const kinematics::SchemeConfig& vise = work.schemes[0];
  EXPECT_EQ(vise.axes, (std::vector<int>{0, 1, 2}));
  ASSERT_EQ(vise.parking.size(), 2U);
  for (const int k : {0, 1}) {
    const kinematics::Parking& parking = vise.parking[static_cast<std::size_t>(k)];
    EXPECT_EQ(parking.axis, 3 + k);
    EXPECT_EQ(parking.position, 0.0);
    EXPECT_TRUE(parking.brake);
    EXPECT_TRUE(parking.drive_off);
  }
  EXPECT_EQ(work.schemes[1].type, "head_table");
  EXPECT_EQ(work.schemes[1].zero, (kinematics::AxisVector<double>{0, 0, -150}));
  const channels::ChannelConfig& master = file.machine.channels[1];
  EXPECT_EQ(master.kind, lang::ChannelKind::master);
  EXPECT_TRUE(master.axes.empty());
  EXPECT_TRUE(master.schemes.empty());
}

TEST(MachineFiles, E7106mf4DrivesItsFiveAxesOverModbus) {
  const MachineFile file = machine("e7106mf4");
  EXPECT_EQ(file.bus.kind, drives::BusKind::modbus_tcp);
  EXPECT_EQ(file.bus.poll_ms, 10);
  EXPECT_EQ(file.bus.timeout_ms, 250);
  ASSERT_EQ(file.bus.axes.size(), 5U);
  EXPECT_EQ(file.bus.axes[3].axis, "B");
  EXPECT_EQ(file.bus.axes[3].unit, 4);
  EXPECT_EQ(file.bus.axes[3].velocity_max, 120.0);
}

TEST(MachineFiles, E7106mf4RotaryAxisCIsUnlimitedAndBIsNot) {
  const MachineFile file = machine("e7106mf4");
  const auto config = channels::motion_config(file.machine, file.machine.channels[0]);
  EXPECT_EQ(config.axes[3].position_min, -100.0);
  EXPECT_EQ(config.axes[3].position_max, 100.0);
  EXPECT_EQ(config.axes[4].position_max, motion::unlimited);
  EXPECT_FALSE(config.axes[4].linear);
  EXPECT_EQ(config.axes[0].rapid_max, 400.0);
}

// The finishing programs call ball mills as tools 1 and 2 (programs/generators).
TEST(MachineFiles, E7106mf4HasTheToolsOfItsPrograms) {
  const MachineFile file = machine("e7106mf4");
  const auto& tools = file.machine.tables.tools;
  ASSERT_EQ(tools.size(), 4U);
  for (const auto& tool : tools) EXPECT_EQ(tool.radius, 3.0);
  EXPECT_EQ(tools[0].kind, "ball");
  EXPECT_EQ(tools[0].length, 80.0);
  EXPECT_EQ(tools[1].kind, "ball");
  EXPECT_EQ(tools[1].length, 75.0);
  EXPECT_EQ(tools[2].kind, "flat");
  EXPECT_EQ(tools[3].kind, "ball");
  EXPECT_EQ(file.machine.tables.offsets.at("G54").at("X"), 0.0);
}

// A workpiece of 52 x 86 x 34 mm with 50 mm of clearance above, at the base of either scheme, is
// reached by tools up to 150 mm; on the table also while the head tilts to 45 deg at any angle of
// C.
void expect_within_reach(const kinematics::AxisVector<double>& axes_M,
                         const motion::MotionConfig& config) {
  for (std::size_t axis = 0; axis < 4; ++axis) {
    ASSERT_GE(axes_M[axis], config.axes[axis].position_min) << "axis " << axis;
    ASSERT_LE(axes_M[axis], config.axes[axis].position_max) << "axis " << axis;
  }
}

// The corners of the workpiece and of the clearance above it, at one attitude of the tool.
void expect_corners_within_reach(const kinematics::Scheme& scheme,
                                 const motion::MotionConfig& config, double length, double B,
                                 double C) {
  for (const double x : {-52.0, 52.0}) {
    for (const double y : {-86.0, 86.0}) {
      for (const double z : {-34.0, 34.0, 84.0}) {
        kinematics::AxisVector<double> axes_M{};
        scheme.inverse(kinematics::PointMode::tip, {{0.0, 0.0, -length}}, {x, y, z, B, C}, axes_M);
        expect_within_reach(axes_M, config);
      }
    }
  }
}

TEST(MachineFiles, E7106mf4ReachesTheWorkpieceAtBothBases) {
  const MachineFile file = machine("e7106mf4");
  const channels::ChannelConfig& work = file.machine.channels[0];
  const auto config = channels::motion_config(file.machine, work);
  for (const auto& scheme_config : work.schemes) {
    const auto scheme = kinematics::make_scheme(scheme_config);
    const int tilt_max = scheme_config.type == "head_table" ? 45 : 0;
    for (const double length : {0.0, 75.0, 150.0})
      for (int B = -tilt_max; B <= tilt_max; B += 15)
        for (int C = 0; C < 360; C += 30)
          expect_corners_within_reach(*scheme, config, length, B, C);
  }
}

// A block of 120 x 120 x 60 mm on the plate is reached from above and at every tilt of the cradle
// down to the horizontal, whatever way the plate is turned.
TEST(MachineFiles, TrunnionReachesTheBlockOnItsPlate) {
  const MachineFile file = machine("trunnion");
  const channels::ChannelConfig& mill = file.machine.channels[0];
  EXPECT_EQ(mill.schemes[0].type, "table_table");
  EXPECT_EQ(mill.schemes[0].zero, (kinematics::AxisVector<double>{0, -25, -560}));
  ASSERT_EQ(file.machine.tables.tools.size(), 3U);
  const auto config = channels::motion_config(file.machine, mill);
  const auto scheme = kinematics::make_scheme(mill.schemes[0]);
  for (const auto& tool : file.machine.tables.tools) {
    for (const double A : {-90.0, -60.0, -30.0, 0.0, 30.0}) {
      for (int C = 0; C < 360; C += 30) {
        for (const double x : {-60.0, 60.0})
          for (const double y : {-60.0, 60.0})
            for (const double z : {0.0, 60.0, 110.0}) {
              kinematics::AxisVector<double> axes_M{};
              scheme->inverse(kinematics::PointMode::tip, {{0.0, 0.0, -tool.length}},
                              {x, y, z, A, static_cast<double>(C)}, axes_M);
              expect_within_reach(axes_M, config);
            }
      }
    }
  }
}

TEST(MachineFiles, Stress8HasEightChannelsOfFiveAxesCalledAlike) {
  const MachineFile file = machine("stress8");
  ASSERT_EQ(file.machine.axes.size(), 40U);
  ASSERT_EQ(file.machine.channels.size(), 8U);
  for (int n = 0; n < 8; ++n) {
    const auto& channel = file.machine.channels[static_cast<std::size_t>(n)];
    EXPECT_EQ(channel.id, n + 1);
    EXPECT_EQ(channel.axes.front(), 5 * n);
    EXPECT_EQ(channel.words, (std::vector<std::string>{"X", "Y", "Z", "B", "C"}));
    const auto config = channels::motion_config(file.machine, channel);
    EXPECT_EQ(config.axes[0].velocity_max, 250.0);
    EXPECT_EQ(config.axes[0].acceleration_max, 2500.0);
    EXPECT_EQ(config.axes[0].jerk_max, 50000.0);
    EXPECT_EQ(config.axes[4].velocity_max, 120.0);
    EXPECT_EQ(config.axes[4].acceleration_max, 1200.0);
    EXPECT_EQ(config.axes[4].jerk_max, 24000.0);
  }
  EXPECT_EQ(file.bus.kind, drives::BusKind::none);
}

TEST(MachineFiles, LatheHasNoYAndChangesToolsByTheTWord) {
  const MachineFile file = machine("lathe");
  const channels::ChannelConfig& turn = file.machine.channels[0];
  EXPECT_EQ(turn.kind, lang::ChannelKind::lathe);
  EXPECT_EQ(turn.tool_change, "t_word");
  EXPECT_EQ(turn.t_format, "tool_edge");
  EXPECT_EQ(channels::motion_config(file.machine, turn).geometry, (std::array<int, 3>{0, -1, 1}));
}

}  // namespace
}  // namespace stanok::config
