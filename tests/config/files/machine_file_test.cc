// What a machine file means: every key arrives where it belongs, defaults are those of the structs.
#include "config/files/machine_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>

#include "config/files/key_reference.h"
#include "config/files/tables_file.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::config {
namespace {

constexpr std::string_view full_file = R"(
[machine]
name = "full"
cycle_us = 500
stop_limits = 1.5
stop_time_max = 2.5
request_age_max = 0.25
catch_up_max = 5
tables = "tables.toml"

[[axis]]
name = "X2"
kind = "linear"
min = -350.0
max = 350
start = 12.5
velocity_max = 400.0
acceleration_max = 4000.0
jerk_max = 100000.0
rapid_max = 300.0
stop_limits = 1.25
resolution = 0.0005
kmv = 1000
following_error_max = 0.25
[axis.homing]
order = 2
position = 350
velocity = -15
[axis.position_controller]
feedback = "cycle"
kp = 20
kd = 0.5
kint = 0.1
kv = 0.99
ka = 0.002
kr = 1e-5
[axis.drive]
address = 17
registers = { control = 10, status = 50 }
scales = { position = 2000, velocity = 500 }
brake_time = 0.2
power_time = 0.3

[[axis]]
name = "C2"
kind = "rotary"
velocity_max = 90
acceleration_max = 900
jerk_max = 9000
modulo = 360

[[axis]]
name = "C3"
kind = "rotary"
velocity_max = 90
acceleration_max = 900
jerk_max = 9000

[[spindle]]
id = 3
speed_max = 4000
speed_min = 20
acceleration = 1500
wait_at_speed = false
power_idle = 300
encoder = 2048
axis = "C3"

[[channel]]
id = 4
name = "helper"
kind = "master"

[[channel]]
id = 2
name = "lower"
kind = "lathe"
axes = ["X2", "C2"]
words = ["X", "C"]
spindles = [3]
scheme = 2
path_tolerance = 0.02
orientation_tolerance = 0.1
arc_radius_tolerance = 0.005
tool_change = "t_word"
t_format = "tool_edge"
dialect = "fanuc"
on_owner_failure = "continue"
[channel.address_alias]
E = "dS"
[channel.codes]
G200 = "cycles/groove.nc"
[[channel.scheme]]
id = 1
type = "cartesian"
axes = ["X", "C2"]
[[channel.scheme]]
id = 2
file = "schemes/face.toml"

[drives]
bus = "modbus-rtu"
device = "/dev/ttyUSB0"
baud = 57600
poll_ms = 20
timeout_ms = 300
[lcm]
url = "udpm://239.255.76.67:7668?ttl=1"
[recorder]
directory = "logs"
size_mb = 64
logs_max_gb = 2.5
logs_max_days = 7
free_space_min_gb = 0.5
[process]
feed_min = 0.5
feed_max = 20
vibration_level = 3
reduced_mass = 40
[simulation]
drive_frequency = 60
drive_damping = 0.7
servo_frequency = 200
servo_damping = 0.75
resonance_frequency = 55
resonance_damping = 0.03
)";

class FullFile : public ::testing::Test {
 protected:
  FullFile() {
    files_.write("schemes/face.toml",
                 "type = \"cartesian\"\naxes = [\"X\"]\nzero = { X = 5 }\n"
                 "retract = { C = 90, X = 300 }\n"
                 "[[parked]]\naxis = \"C\"\nposition = 30\nvelocity = 45\nbrake = false\n"
                 "drive = \"on\"\n");
    files_.write("tables.toml",
                 "[[tool]]\nnumber = 7\nedge = 2\nname = \"insert\"\nkind = \"insert\"\n"
                 "length = 60\nlength_x = -25\nlength_y = 1\nradius = 0.8\ncorner_radius = 0.4\n"
                 "flute_length = 1\nshank_diameter = 2\nholder_diameter = 3\nholder_length = 4\n"
                 "wear_length = 0.01\nwear_length_x = -0.03\nwear_radius = -0.02\noverhang = "
                 "30\norientation = 3\n"
                 "angle_front = 95\nangle_back = 5\n"
                 "[offset.G54]\nX2 = 1.5\n[offset.\"G54.1 P3\"]\nC2 = 45\n[offset.\"G59.1\"]\n");
    file_ = read_machine_file(files_.write("full.toml", full_file));
  }

  TemporaryFiles files_;
  MachineFile file_;
};

TEST_F(FullFile, AxisGetsItsLimitsHomingControllerAndDrive) {
  const channels::AxisConfig& axis = file_.machine.axes[0];
  EXPECT_EQ(axis.name, "X2");
  EXPECT_FALSE(axis.rotary);
  EXPECT_TRUE(axis.limits.linear);
  EXPECT_EQ(axis.limits.position_min, -350.0);
  EXPECT_EQ(axis.limits.position_max, 350.0);
  EXPECT_EQ(axis.limits.velocity_max, 400.0);
  EXPECT_EQ(axis.limits.acceleration_max, 4000.0);
  EXPECT_EQ(axis.limits.jerk_max, 100000.0);
  EXPECT_EQ(axis.limits.rapid_max, 300.0);
  EXPECT_EQ(axis.limits.stop_limits, 1.25);
  EXPECT_EQ(axis.start, 12.5);
  EXPECT_EQ(axis.resolution, 0.0005);
  EXPECT_EQ(axis.kmv, 1000.0);
  EXPECT_EQ(axis.following_error_max, 0.25);
  EXPECT_EQ(axis.homing.order, 2);
  EXPECT_EQ(axis.homing.position, 350.0);
  EXPECT_EQ(axis.homing.velocity, -15.0);
  EXPECT_EQ(axis.controller.feedback, channels::FeedbackPlace::cycle);
  EXPECT_EQ(axis.controller.gains.kp, 20.0);
  EXPECT_EQ(axis.controller.gains.kd, 0.5);
  EXPECT_EQ(axis.controller.gains.kint, 0.1);
  EXPECT_EQ(axis.controller.gains.kv, 0.99);
  EXPECT_EQ(axis.controller.gains.ka, 0.002);
  EXPECT_EQ(axis.controller.gains.kr, 1e-5);
  EXPECT_EQ(axis.brake_s, 0.2);
  EXPECT_EQ(axis.power_s, 0.3);
  const drives::AxisDriveConfig& drive = file_.bus.axes[0];
  EXPECT_EQ(drive.acceleration_max, 4000.0);
  EXPECT_EQ(drive.target_acceleration_max, 1.25 * 4000.0);
  EXPECT_EQ(drive.axis, "X2");
  EXPECT_EQ(drive.unit, 17);
  EXPECT_EQ(drive.kind, drives::DriveKind::velocity);
  EXPECT_FALSE(drive.absolute_encoder);
  EXPECT_EQ(drive.map,
            drives::register_map(
                {.control = 10, .status = 50, .position_scale = 2000.0, .velocity_scale = 500.0}));
  EXPECT_EQ(drive.following_error_max, 0.25);
  EXPECT_EQ(drive.velocity_max, 400.0);
}

TEST_F(FullFile, RotaryAxisWithoutTravelIsUnlimitedAndItsDriveHasTheAddressOfItsPlace) {
  const channels::AxisConfig& axis = file_.machine.axes[1];
  EXPECT_TRUE(axis.rotary);
  EXPECT_EQ(axis.limits.position_min, -motion::unlimited);
  EXPECT_EQ(axis.limits.position_max, motion::unlimited);
  EXPECT_EQ(axis.limits.rapid_max, 90.0);
  EXPECT_EQ(axis.limits.stop_limits, 1.5);
  EXPECT_EQ(axis.modulo_deg, 360.0);
  EXPECT_EQ(file_.bus.axes[1].unit, 2);
}

TEST_F(FullFile, SpindleAndChannelsAreComplete) {
  const channels::SpindleConfig& spindle = file_.machine.spindles[0];
  EXPECT_EQ(spindle.id, 3);
  EXPECT_EQ(spindle.speed_min, 20.0);
  EXPECT_EQ(spindle.speed_max, 4000.0);
  EXPECT_EQ(spindle.acceleration, 1500.0);
  EXPECT_FALSE(spindle.wait_at_speed);
  EXPECT_EQ(spindle.power_idle_w, 300.0);
  EXPECT_EQ(spindle.encoder_pulses, 2048);
  EXPECT_EQ(spindle.axis, "C3");

  ASSERT_EQ(file_.machine.channels.size(), 2U);
  const channels::ChannelConfig& channel = file_.machine.channels[0];  // ascending ids
  EXPECT_EQ(channel.id, 2);
  EXPECT_EQ(channel.name, "lower");
  EXPECT_EQ(channel.kind, lang::ChannelKind::lathe);
  EXPECT_EQ(channel.axes, (std::vector<int>{0, 1}));
  EXPECT_EQ(channel.words, (std::vector<std::string>{"X", "C"}));
  EXPECT_EQ(channel.spindles, std::vector<int>{3});
  EXPECT_EQ(channel.scheme, 2);
  EXPECT_EQ(channel.path_tolerance_mm, 0.02);
  EXPECT_EQ(channel.orientation_tolerance_deg, 0.1);
  EXPECT_EQ(channel.arc_radius_tolerance_mm, 0.005);
  EXPECT_EQ(channel.tool_change, "t_word");
  EXPECT_EQ(channel.t_format, "tool_edge");
  EXPECT_EQ(channel.rules, (lang::TextRules{lang::Dialect::fanuc, lang::CodeSystem::b}));
  EXPECT_EQ(channel.on_owner_failure, channels::OwnerFailure::continue_run);
  EXPECT_EQ(channel.address_alias.at("E"), "dS");
  EXPECT_EQ(channel.codes.at("G200"), "cycles/groove.nc");
  EXPECT_EQ(file_.machine.channels[1].id, 4);
  EXPECT_EQ(file_.machine.channels[1].kind, lang::ChannelKind::master);
}

TEST_F(FullFile, SchemesNameAxesByWordOrByMachineName) {
  const auto& schemes = file_.machine.channels[0].schemes;
  ASSERT_EQ(schemes.size(), 2U);
  EXPECT_EQ(schemes[0].axes, (std::vector<int>{0, 1}));
  EXPECT_EQ(schemes[0].linear, (std::array<int, 3>{0, -1, -1}));
  const kinematics::SchemeConfig& face = schemes[1];
  EXPECT_EQ(face.file, (files_.folder() / "schemes" / "face.toml").string());
  EXPECT_EQ(face.axes, std::vector<int>{0});
  EXPECT_EQ(face.zero[0], 5.0);
  ASSERT_EQ(face.parking.size(), 1U);
  EXPECT_EQ(face.parking[0].axis, 1);
  EXPECT_EQ(face.parking[0].position, 30.0);
  EXPECT_EQ(face.parking[0].velocity, 45.0);
  EXPECT_FALSE(face.parking[0].brake);
  EXPECT_FALSE(face.parking[0].drive_off);
  // In the order of the file, not of the alphabet: 90 of C before 300 of X.
  EXPECT_EQ(face.retract, (std::vector<std::pair<int, double>>{{1, 90.0}, {0, 300.0}}));
}

TEST_F(FullFile, BusAndServicesAreRead) {
  EXPECT_EQ(file_.bus.kind, drives::BusKind::modbus_rtu);
  EXPECT_EQ(file_.bus.device, "/dev/ttyUSB0");
  EXPECT_EQ(file_.bus.baud, 57600);
  EXPECT_EQ(file_.bus.poll_ms, 20);
  EXPECT_EQ(file_.bus.timeout_ms, 300);
  EXPECT_EQ(file_.machine.cycle_us, 500);
  EXPECT_EQ(file_.machine.stop_time_max_s, 2.5);
  EXPECT_EQ(file_.machine.request_age_max_s, 0.25);
  EXPECT_EQ(file_.machine.catch_up_max, 5);
  EXPECT_EQ(file_.lcm_url, "udpm://239.255.76.67:7668?ttl=1");
  EXPECT_EQ(file_.recorder.directory, files_.folder() / "logs");
  EXPECT_EQ(file_.recorder.size_mb, 64);
  EXPECT_EQ(file_.recorder.logs_max_gb, 2.5);
  EXPECT_EQ(file_.recorder.logs_max_days, 7.0);
  EXPECT_EQ(file_.recorder.free_space_min_gb, 0.5);
  EXPECT_EQ(file_.process.control.feed_min, 0.5);
  EXPECT_EQ(file_.process.control.feed_max, 20.0);
  EXPECT_EQ(file_.process.control.vibration_level_um, 3.0);
  EXPECT_EQ(file_.process.control.reduced_mass_kg, 40.0);
  EXPECT_EQ(file_.simulation.drive_frequency_hz, 60.0);
  EXPECT_EQ(file_.simulation.drive_damping, 0.7);
  EXPECT_EQ(file_.simulation.servo_frequency_hz, 200.0);
  EXPECT_EQ(file_.simulation.servo_damping, 0.75);
  EXPECT_EQ(file_.simulation.resonance_frequency_hz, 55.0);
  EXPECT_EQ(file_.simulation.resonance_damping, 0.03);
}

TEST_F(FullFile, ToolsAndOffsetsAreRead) {
  ASSERT_EQ(file_.machine.tables.tools.size(), 1U);
  const channels::ToolEdge& tool = file_.machine.tables.tools[0];
  EXPECT_EQ(tool.number, 7);
  EXPECT_EQ(tool.edge, 2);
  EXPECT_EQ(tool.name, "insert");
  EXPECT_EQ(tool.kind, "insert");
  EXPECT_EQ(tool.length, 60.0);
  EXPECT_EQ(tool.length_x, -25.0);
  EXPECT_EQ(tool.length_y, 1.0);
  EXPECT_EQ(tool.radius, 0.8);
  EXPECT_EQ(tool.corner_radius, 0.4);
  EXPECT_EQ(tool.flute_length, 1.0);
  EXPECT_EQ(tool.shank_diameter, 2.0);
  EXPECT_EQ(tool.holder_diameter, 3.0);
  EXPECT_EQ(tool.holder_length, 4.0);
  EXPECT_EQ(tool.wear_length, 0.01);
  EXPECT_EQ(tool.wear_length_x, -0.03);
  EXPECT_EQ(tool.wear_radius, -0.02);
  EXPECT_EQ(tool.overhang, 30.0);
  EXPECT_EQ(tool.orientation, 3);
  EXPECT_EQ(tool.angle_front, 95.0);
  EXPECT_EQ(tool.angle_back, 5.0);
  EXPECT_EQ(file_.machine.tables.offsets.at("G54").at("X2"), 1.5);
  EXPECT_EQ(file_.machine.tables.offsets.at("G54.1 P3").at("C2"), 45.0);
  EXPECT_TRUE(file_.machine.tables.offsets.at("G59.1").empty());
}

constexpr std::string_view head_table_machine = R"(
[machine]
name = "m"
)";

std::string five_axis_file(const std::string& scheme_keys) {
  std::string text(head_table_machine);
  for (const std::string name : {"X", "Y", "Z", "B", "C"}) {
    const bool rotary = name == "B" || name == "C";
    text += "[[axis]]\nname = \"" + name + "\"\nkind = \"" + (rotary ? "rotary" : "linear") +
            "\"\n" + (rotary ? "" : "min = -500\nmax = 500\n") +
            "velocity_max = 100\nacceleration_max = 1000\njerk_max = 10000\n";
  }
  return text +
         "[[channel]]\nid = 1\nname = \"work\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n" +
         "[[channel.scheme]]\nid = 1\ntype = \"head_table\"\n"
         "axes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n"
         "pivot_to_spindle = [1, 2, -200]\ntable_centre = [10, 20, -350]\n" +
         scheme_keys;
}

TEST(MachineFile, LinearZeroOfAHeadTableFollowsFromItsGeometryUnlessGiven) {
  const TemporaryFiles files;
  const auto derived = read_machine_file(files.write("a.toml", five_axis_file("")));
  EXPECT_EQ(derived.machine.channels[0].schemes[0].zero,
            (kinematics::AxisVector<double>{9, 18, -150}));
  const auto given =
      read_machine_file(files.write("b.toml", five_axis_file("zero = { Z = -100, C = 30 }\n")));
  EXPECT_EQ(given.machine.channels[0].schemes[0].zero,
            (kinematics::AxisVector<double>{9, 18, -100, 0, 30}));
}

TEST(MachineFile, HeadTableRolesAreBAndCUnlessNamed) {
  const TemporaryFiles files;
  const auto usual = read_machine_file(files.write("a.toml", five_axis_file("")));
  const auto roles = [](const MachineFile& file) {
    const auto& geometry = file.machine.channels[0].schemes[0].geometry;
    const auto& head_table = std::get<kinematics::HeadTable::Geometry>(geometry);
    return std::pair(head_table.head_axis, head_table.table_axis);
  };
  EXPECT_EQ(roles(usual), std::pair(3, 4));
  const auto named = read_machine_file(
      files.write("b.toml", five_axis_file("head_axis = \"C\"\ntable_axis = \"B\"\n")));
  EXPECT_EQ(roles(named), std::pair(4, 3));
}

TEST(MachineFile, ChannelWithoutSchemesGetsACartesianOneOfAllItsAxes) {
  const TemporaryFiles files;
  const MachineFile file = read_machine_file(files.write(
      "m.toml",
      "[machine]\nname = \"m\"\n[[axis]]\nname = \"Z\"\nkind = \"linear\"\nmin = 0\nmax = 1\n"
      "velocity_max = 1\nacceleration_max = 1\njerk_max = 1\n"
      "[[channel]]\nid = 1\nname = \"c\"\naxes = [\"Z\"]\n"));
  const channels::ChannelConfig& channel = file.machine.channels[0];
  ASSERT_EQ(channel.schemes.size(), 1U);
  EXPECT_EQ(channel.scheme, 1);
  EXPECT_EQ(channel.schemes[0].type, "cartesian");
  EXPECT_EQ(channel.schemes[0].axes, std::vector<int>{0});
  EXPECT_EQ(channel.schemes[0].linear, (std::array<int, 3>{-1, -1, 0}));
  EXPECT_EQ(file.bus.kind, drives::BusKind::none);
  EXPECT_TRUE(file.bus.axes.empty());
  EXPECT_EQ(file.lcm_url, "udpm://239.255.76.67:7667?ttl=0");
}

TEST(TablesFile, ReferencePointsComeBackToTheBit) {
  channels::TablesConfig tables;
  tables.reference_points[2]["G28"] = {{"X2", 0.1 + 0.2}, {"C2", -45.0}};
  tables.reference_points[2]["G30 P4"] = {{"X2", 1e-300}};
  const auto back = read_tables_text(to_toml(tables), "tables.toml", {"X2", "C2"});
  EXPECT_EQ(back.reference_points, tables.reference_points);
}

TEST(TablesFile, CommonVariablesComeBackToTheBit) {
  channels::TablesConfig tables;
  tables.variables[1] = {{500, 0.1 + 0.2}, {999, -1e300}};
  const auto back = read_tables_text(to_toml(tables), "tables.toml", {"X"});
  EXPECT_EQ(back.variables, tables.variables);
}

TEST(TablesFile, WrongCommonVariablesAreFaults) {
  for (const char* const text :
       {"[variable.1]\n499 = 1\n", "[variable.1]\n500 = \"x\"\n", "[variable.0]\n500 = 1\n",
        "[variable.1]\n5e2 = 1\n", "[variable]\n1 = 5\n"}) {
    EXPECT_THROW(static_cast<void>(read_tables_text(text, "t.toml", {"X"})), ConfigError) << text;
  }
}

TEST(TablesFile, WrongReferencePointsAreFaultsWithAPlace) {
  try {
    static_cast<void>(
        read_tables_text("[reference_point.1.G27]\nX = 1\n[reference_point.0.G28]\n"
                         "[reference_point.1.G28]\nQ = 1\nX = \"far\"\n",
                         "t.toml", {"X"}));
    FAIL() << "taken";
  } catch (const ConfigError& error) {
    std::vector<std::uint32_t> lines;
    for (const ConfigFault& fault : error.faults())
      lines.push_back(static_cast<std::uint32_t>(fault.line));
    EXPECT_EQ(lines, (std::vector<std::uint32_t>{1, 3, 5, 6}));
  }
}

TEST(TablesFile, NamesOfWorkOffsets) {
  for (const char* name : {"G54", "G59", "G59.1", "G59.3", "G54.1 P1", "G54.1 P300"}) {
    EXPECT_TRUE(is_work_offset(name)) << name;
  }
  for (const char* name : {"G53", "G60", "G59.4", "G54.1", "G54.1 P0", "G54.1 P", "G54.1 Px", ""}) {
    EXPECT_FALSE(is_work_offset(name)) << name;
  }
}

std::string configuration_document() {
  std::ifstream stream(stanok::testing::source_folder() + "/docs/reference/configuration.md");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(TablesFile, ReferencePointsAreThoseOfChannelsOfTheMachine) {
  TemporaryFiles files;
  const auto machine = [&](const std::string& text) {
    files.write("schemes/face.toml", "type = \"cartesian\"\naxes = [\"X\"]\n");
    files.write("tables.toml", text);
    return files.write("full.toml", full_file);
  };
  try {
    static_cast<void>(read_machine_file(machine("[reference_point.15.G28]\nX2 = 1\n")));
    FAIL() << "taken";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("the machine has no channel 15"), std::string::npos)
        << error.what();
  }
}

// docs/reference/configuration.md holds the tables that the readers are made of, word for word.
TEST(MachineFile, AutomaticFeedLawsOfAChannelHaveTheirFigures) {
  const TemporaryFiles files;
  const MachineFile file = read_machine_file(files.write(
      "m.toml",
      "[machine]\nname = \"m\"\n[[axis]]\nname = \"X\"\nkind = \"linear\"\nmin = 0\nmax = 1\n"
      "velocity_max = 1\nacceleration_max = 1\njerk_max = 1\n[[spindle]]\nid = 1\nspeed_max = 1\n"
      "[[channel]]\nid = 1\nname = \"a\"\naxes = [\"X\"]\nspindles = [1]\n"
      "[[channel.automatic_feed]]\nlaw = \"modulated\"\nlevel = 5\nfeed_min = 0.5\n"
      "[[channel.automatic_feed]]\nlaw = \"linear\"\nlevel = 900\nrelease = 700\nfeed_min = 0.3\n"
      "feed_step = 0.02\npath_step = 0.4\nactive = true\n"));
  const auto& laws = file.machine.channels[0].automatic_feeds;
  ASSERT_EQ(laws.size(), 2U);
  EXPECT_EQ(laws[0].law, motion::LawKind::modulated);
  EXPECT_EQ(laws[0].release, 4.0);
  EXPECT_FALSE(laws[0].on_at_start);
  EXPECT_EQ(laws[1].law, motion::LawKind::linear);
  EXPECT_EQ(laws[1].level, 900.0);
  EXPECT_EQ(laws[1].release, 700.0);
  EXPECT_EQ(laws[1].part_min, 0.3);
  EXPECT_EQ(laws[1].part_step, 0.02);
  EXPECT_EQ(laws[1].path_step_mm, 0.4);
  EXPECT_TRUE(laws[1].on_at_start);
}

TEST(KeyReference, StandsInTheDocumentation) {
  const std::string document = configuration_document() + '\n';
  for (const KeySection& section : key_sections()) {
    // A blank line behind it: the table has no other rows.
    EXPECT_NE(document.find(to_markdown(section) + '\n'), std::string::npos)
        << "docs/reference/configuration.md lacks this table, or has another one:\n"
        << to_markdown(section);
  }
}

TEST(KeyReference, ExampleOfTheDocumentationIsAValidMachineFile) {
  const std::string document = configuration_document();
  constexpr std::string_view fence = "```toml\n";
  const std::size_t begin = document.find(fence) + fence.size();
  const TemporaryFiles files;
  const auto path =
      files.write("m.toml", document.substr(begin, document.find("```", begin) - begin));
  EXPECT_EQ(read_machine_file(path).machine.name, "router");
}

}  // namespace
}  // namespace stanok::config
