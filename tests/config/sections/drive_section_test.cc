// Register maps, bits and words of drives in the machine file: what is read, and what is refused
// with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "config/files/machine_file.h"
#include "config/files/machine_remarks.h"
#include "tests/config/temporary_files.h"

namespace stanok::config {
namespace {

using drives::DriveKind;
using drives::RegisterField;
using drives::RequestStyle;
using drives::WordOrder;
using ::testing::HasSubstr;

constexpr std::string_view head =
    "machine = { name = \"m\" }\n"  // 1
    "[[channel]]\n"                 // 2
    "id = 1\n"                      // 3
    "name = \"c\"\n"                // 4
    "axes = [\"X\"]\n"              // 5
    "[drives]\n"                    // 6
    "bus = \"modbus-tcp\"\n"        // 7
    "[[axis]]\n"                    // 8
    "name = \"X\"\n"                // 9
    "kind = \"linear\"\n"           // 10
    "min = 0\n"                     // 11
    "max = 100\n"                   // 12
    "velocity_max = 100\n"          // 13
    "acceleration_max = 1000\n"     // 14
    "jerk_max = 20000\n";           // 15; what follows begins with line 16

class DriveSectionTest : public ::testing::Test {
 protected:
  MachineFile read(std::string_view drive) {
    return read_machine_file(files_.write("m.toml", std::string(head) + std::string(drive)));
  }
  std::string faults_of(std::string_view drive) {
    try {
      static_cast<void>(read(drive));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFiles files_;
};

// a T^2 / 2 = 1.2 x 1000 mm/s2 x (50 ms)^2 / 2 = 1.5 mm.
TEST_F(DriveSectionTest, APollThatIsTooRareForAStopIsRemarkedOn) {
  const std::vector<std::string> remarks = remarks_on(read("following_error_max = 1.4\n"));
  EXPECT_TRUE(remarks.empty()) << "10 ms";
  MachineFile file = read("following_error_max = 1.4\n");
  EXPECT_EQ(file.bus.axes[0].target_acceleration_max, 1200.0);
  file.bus.poll_ms = 50;
  ASSERT_EQ(remarks_on(file).size(), 1U);
  EXPECT_THAT(remarks_on(file)[0], HasSubstr("axis X: a stop brakes at 1200 /s2"));
  EXPECT_THAT(remarks_on(file)[0], HasSubstr("50 ms is 1.5 away"));
  file.bus.axes[0].following_error_max = 1.6;
  EXPECT_TRUE(remarks_on(file).empty());
}

TEST_F(DriveSectionTest, AMapHasWhatItNamesAndNothingElse) {
  const MachineFile file = read(R"([axis.drive]
write = "fc16"
read_gap = 3
scales = { position = 500 }
[axis.drive.map]
control_word = { address = 0x2000 }
target_position = { address = 0x2010, order = "low_first" }
target_velocity = { address = 0x2012, width = 16, signed = true, scale = 2.5, offset = 10 }
status_word = { address = 0x3000 }
position = { address = 0x3001, scale = -2000 }
temperature = { address = 0x3003, signed = false, scale = 1, offset = 40 }
[axis.drive.bits]
referenced = 8
home_switch = -1
)");
  const drives::AxisDriveConfig& drive = file.bus.axes[0];
  EXPECT_EQ(drive.kind, DriveKind::position);
  EXPECT_EQ(drive.requests, RequestStyle::write_multiple);
  EXPECT_EQ(drive.gap_max, 3);
  drives::RegisterMap map;
  map.control_word = {.address = 0x2000};
  map.target_position = {.address = 0x2010,
                         .words = 2,
                         .is_signed = true,
                         .order = WordOrder::low_first,
                         .scale = 500.0};
  map.target_velocity = {.address = 0x2012, .is_signed = true, .scale = 2.5, .offset = 10.0};
  map.status_word = {.address = 0x3000};
  map.position = {.address = 0x3001, .words = 2, .is_signed = true, .scale = -2000.0};
  map.temperature = {.address = 0x3003, .scale = 1.0, .offset = 40.0};
  map.bits = {.referenced = 1U << 8, .limit_negative = 1U << 0, .limit_positive = 1U << 1};
  EXPECT_EQ(drive.map, map);
}

TEST_F(DriveSectionTest, WordsOfAManufacturerAreRead) {
  const MachineFile file = read(R"([axis.position_controller]
feedback = "cycle"
kp = 20
[axis.drive]
kind = "velocity"
[axis.drive.map]
control_word = { address = 0 }
target_velocity = { address = 1 }
status_word = { address = 2 }
position = { address = 3 }
[axis.drive.words]
stop = 1
run = 0x12
run_reverse = 0x22
reset = 2
running = [3, 3]
fault = [0x80, 0x80]
)");
  const drives::AxisDriveConfig& drive = file.bus.axes[0];
  EXPECT_EQ(drive.kind, DriveKind::velocity);
  EXPECT_EQ(drive.words, (drives::RunWords{.stop = 1,
                                           .run = 0x12,
                                           .run_reverse = 0x22,
                                           .fault_reset = 2,
                                           .running = {.mask = 3, .value = 3},
                                           .fault = {.mask = 0x80, .value = 0x80}}));
}

TEST_F(DriveSectionTest, ASpindleMayHaveADriveOfItsOwn) {
  const MachineFile file = read(R"([[spindle]]
id = 2
speed_max = 3000
[spindle.drive]
kind = "on_off"
watchdog_ms = 500
map.control_word = { address = 7 }
words = { stop = 0, run = 1 }
[[spindle]]
id = 4
speed_max = 6000
[spindle.drive]
address = 9
)");
  ASSERT_EQ(file.bus.spindles.size(), 2U);
  const drives::AxisDriveConfig& contactor = file.bus.spindles[0];
  EXPECT_EQ(contactor.axis, "S2");
  EXPECT_EQ(contactor.spindle, 2);
  EXPECT_EQ(contactor.unit, 202);
  EXPECT_EQ(contactor.kind, DriveKind::on_off);
  EXPECT_EQ(contactor.watchdog_ms, 500);
  EXPECT_EQ(contactor.map.control_word.address, 7);
  EXPECT_FALSE(contactor.map.status_word.exists());
  const drives::AxisDriveConfig& inverter = file.bus.spindles[1];
  EXPECT_EQ(inverter.unit, 9);
  EXPECT_EQ(inverter.kind, DriveKind::velocity);
  EXPECT_EQ(inverter.velocity_max, 6000.0);
  EXPECT_EQ(inverter.map.target_velocity.scale, 1.0) << "rev/min";
}

TEST_F(DriveSectionTest, PlantHasEncoderAndSwitches) {
  const MachineFile file = read(R"([axis.plant]
encoder = "incremental"
home_switch_from = -2
home_switch_to = 5
limit_switch_negative = -3
limit_switch_positive = 104
index_position = 1.5
index_pitch = 10
backlash = 0.02
friction = 300
)");
  const AxisSimulation& plant = file.axis_plants[0];
  EXPECT_FALSE(plant.absolute_encoder);
  EXPECT_EQ(plant.home_switch_from, -2.0);
  EXPECT_EQ(plant.home_switch_to, 5.0);
  EXPECT_EQ(plant.limit_negative, -3.0);
  EXPECT_EQ(plant.limit_positive, 104.0);
  EXPECT_EQ(plant.index_position, 1.5);
  EXPECT_EQ(plant.index_pitch, 10.0);
  EXPECT_EQ(plant.backlash, 0.02);
  EXPECT_EQ(plant.dry_friction, 300.0);
  EXPECT_TRUE(read("").axis_plants[0].absolute_encoder);
}

TEST_F(DriveSectionTest, SignalsHaveTheirPlaceOnTheBus) {
  const MachineFile file = read(R"([[signal]]
kind = "digital_input"
number = 3
address = 20
table = "input_register"
register = 7
bit = 12
inverted = true
[[signal]]
kind = "analog_output"
number = 1
address = 20
table = "holding_register"
register = 30
width = 32
order = "low_first"
scale = 327.67
offset = 5
)");
  ASSERT_EQ(file.bus.signals.size(), 2U);
  const drives::SignalConfig& input = file.bus.signals[0];
  EXPECT_EQ(input.kind, drives::SignalKind::digital_input);
  EXPECT_EQ(input.number, 3);
  EXPECT_EQ(input.unit, 20);
  EXPECT_EQ(input.table, drives::SignalTable::input_register);
  EXPECT_EQ(input.field.address, 7);
  EXPECT_EQ(input.bit, 12);
  EXPECT_TRUE(input.is_inverted);
  EXPECT_EQ(file.bus.signals[1].field, (RegisterField{.address = 30,
                                                      .words = 2,
                                                      .order = WordOrder::low_first,
                                                      .scale = 327.67,
                                                      .offset = 5.0}));
}

struct FaultCase {
  const char* name;
  const char* drive;  // from line 16 on
  const char* place;  // ":line:column: "
  const char* text;
};

class DriveFault : public DriveSectionTest, public ::testing::WithParamInterface<FaultCase> {};

TEST_P(DriveFault, IsFoundAtItsPlace) {
  const std::string faults = faults_of(GetParam().drive);
  EXPECT_THAT(faults, HasSubstr(GetParam().place));
  EXPECT_THAT(faults, HasSubstr(GetParam().text));
  EXPECT_EQ(std::count(faults.begin(), faults.end(), '\n'), 0) << faults;
}

INSTANTIATE_TEST_SUITE_P(
    Found, DriveFault,
    ::testing::Values(
        FaultCase{"UnknownQuantity",
                  "[axis.drive.map]\ncontrol_word = {address=0}\n"
                  "status_word={address=1}\ntarget_position={address=2}\nposition={address=4}\n"
                  "powr = {address=6}\n",
                  ":21:1: ", "map: unknown key 'powr'; did you mean 'power'?"},
        FaultCase{"UnknownKeyOfAField",
                  "[axis.drive.map]\ncontrol_word = {address=0, adress=1}\n"
                  "status_word={address=1}\ntarget_position={address=2}\nposition={address=4}\n",
                  ":17:28: ", "control_word: unknown key 'adress'; did you mean 'address'?"},
        FaultCase{"NoTable",
                  "[axis.drive.map]\ncontrol_word = {address=0}\nstatus_word={address=1}\n"
                  "target_position={address=2}\nposition={address=4}\npower = 5\n",
                  ":21:9: ", "write a table, as { address = 100 }"},
        FaultCase{"Width",
                  "[axis.drive.map]\ncontrol_word = {address=0}\n"
                  "status_word={address=1}\ntarget_position={address=2, width=24}\n"
                  "position={address=4}\n",
                  ":19:35: ", "width is 24; it must be 16 or 32 bits"},
        FaultCase{"ScaleOfNothing",
                  "[axis.drive.map]\ncontrol_word = {address=0}\n"
                  "status_word={address=1}\ntarget_position={address=2}\n"
                  "position={address=4, scale=0}\n",
                  ":20:28: ", "scale is 0; write the number of increments per unit"},
        FaultCase{"NothingToFollow",
                  "[axis.drive.map]\ncontrol_word = {address=0}\n"
                  "status_word={address=1}\nposition={address=4}\n",
                  ":16:1: ", "map: target_position is missing; a position drive follows it"},
        FaultCase{"TwoWritesToOneRegister",
                  "[axis.drive.map]\ncontrol_word = {address=3}\n"
                  "status_word={address=1}\ntarget_position={address=2}\nposition={address=4}\n",
                  ":16:1: ", "two written values share register 3; give each its own"},
        FaultCase{"TornValue",
                  "[axis.drive]\nwrite = \"fc06\"\nmap.control_word = {address=0}\n"
                  "map.status_word={address=1}\nmap.target_position={address=2}\n"
                  "map.position={address=4}\n",
                  ":17:9: ", "fc06 writes one register at a time"},
        FaultCase{"MapAndBlocks",
                  "[axis.drive]\nregisters={control=0}\n"
                  "map.control_word = {address=0}\nmap.status_word={address=1}\n"
                  "map.target_position={address=2}\nmap.position={address=4}\n",
                  ":17:11: ", "registers belongs to the standard map"},
        FaultCase{"AnAxisThatIsOnOrOff", "[axis.drive]\nkind = \"on_off\"\n",
                  ":17:8: ", "a drive that only runs or stops cannot move an axis"},
        FaultCase{"KindAgainstTheController", "[axis.drive]\nkind = \"velocity\"\n",
                  ":17:8: ", "kind and [axis.position_controller] feedback differ"},
        FaultCase{"PatternOutsideItsMask", "[axis.drive.words]\nstop=0\nrun=1\nrunning=[1,2]\n",
                  ":19:9: ", "running must be [mask, value]"},
        FaultCase{"WatchdogTooShort", "[axis.drive]\nwatchdog_ms = 250\n", ":17:15: ",
                  "E7010 watchdog_ms is 250; it must be longer than timeout_ms of [drives], 250"},
        FaultCase{"AddressOfAnAxis",
                  "[[spindle]]\nid = 1\nspeed_max = 1\ndrive = { address = 1 }\n",
                  ":19:9: ", "spindle 1: its drive has the address of axis X, 1"},
        FaultCase{"SpindleWithPositions",
                  "[[spindle]]\nid = 1\nspeed_max = 1\ndrive = { kind = \"position\" }\n",
                  ":19:18: ", "a spindle follows a velocity, or is on or off"},
        FaultCase{"SpindleWithABrake",
                  "[[spindle]]\nid = 1\nspeed_max = 1\ndrive = { brake_time = 1 }\n",
                  ":19:24: ", "brake_time belongs to an axis; remove it"},
        FaultCase{"OutputOnAnInput",
                  "[[signal]]\nkind=\"digital_output\"\nnumber=1\naddress=2\n"
                  "table=\"discrete_input\"\nregister=1\n",
                  ":20:7: ", "signal 1: an output cannot be written there"},
        FaultCase{"AnalogCoil",
                  "[[signal]]\nkind=\"analog_output\"\nnumber=1\naddress=2\n"
                  "table=\"coil\"\nregister=1\n",
                  ":20:7: ", "an analog value needs a holding_register"},
        FaultCase{"AnalogNumber",
                  "[[signal]]\nkind=\"analog_input\"\nnumber=16\naddress=2\n"
                  "table=\"input_register\"\nregister=1\n",
                  ":18:8: ", "number is 16; analog signals are 0 to 15"},
        FaultCase{"NumberTaken",
                  "[[signal]]\nkind=\"digital_input\"\nnumber=1\naddress=2\ntable=\"coil\"\n"
                  "register=1\n[[signal]]\nkind=\"digital_input\"\nnumber=1\naddress=2\n"
                  "table=\"coil\"\nregister=2\n",
                  ":24:8: ", "signal 2: another signal of this kind has the number"},
        FaultCase{"BlockShorterThanAPoll",
                  "[[vibration_sensor]]\nspindle=1\naddress=60\nregister=0\ncount=39\n", ":20:7: ",
                  "count is 39; with poll_ms = 10 the sensor takes 40 samples in a poll"},
        FaultCase{"UnknownBit", "[axis.drive.bits]\nhome_swich = 2\n",
                  ":17:1: ", "bits: unknown key 'home_swich'; did you mean 'home_switch'?"},
        FaultCase{"HalfASwitch", "[axis.plant]\nhome_switch_to = 2\n",
                  ":17:18: ", "home_switch_from is missing"},
        FaultCase{"SwitchReversed", "[axis.plant]\nhome_switch_from = 3\nhome_switch_to = 2\n",
                  ":17:20: ", "home_switch_from is 3; it must be below home_switch_to, 2"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace stanok::config
