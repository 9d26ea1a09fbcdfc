// Wrong machine files: every fault is found once, at its place, in words that say how to correct
// it.
//
// Each case replaces one line of a small valid file (or appends after its end), so that the line
// numbers can be counted here.
#include "tests/config/machine_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <random>
#include <sstream>

#include "config/files/machine_file.h"
#include "config/text/fault_list.h"
#include "tests/config/temporary_files.h"

namespace stanok::config {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view valid_file =
    "[machine]\n"               // 1
    "name = \"m\"\n"            // 2
    "[[axis]]\n"                // 3
    "name = \"X\"\n"            // 4
    "kind = \"linear\"\n"       // 5
    "min = -10\n"               // 6
    "max = 10.0\n"              // 7
    "velocity_max = 100\n"      // 8
    "acceleration_max = 1e3\n"  // 9
    "jerk_max = 2e4\n"          // 10
    "[[axis]]\n"                // 11
    "name = \"C\"\n"            // 12
    "kind = \"rotary\"\n"       // 13
    "velocity_max = 90\n"       // 14
    "acceleration_max = 900\n"  // 15
    "jerk_max = 9000\n"         // 16
    "[[spindle]]\n"             // 17
    "id = 1\n"                  // 18
    "speed_max = 6000\n"        // 19
    "[[channel]]\n"             // 20
    "id = 1\n"                  // 21
    "name = \"work\"\n"         // 22
    "axes = [\"X\", \"C\"]\n"   // 23
    "spindles = [1]\n"          // 24
    "[[channel.scheme]]\n"      // 25
    "id = 1\n"                  // 26
    "type = \"cartesian\"\n"    // 27
    "axes = [\"X\", \"C\"]\n";  // 28
constexpr int end_of_file = 29;

std::string with_line(int line, std::string_view replacement) {
  std::istringstream stream{std::string(valid_file)};
  std::string text;
  int number = 1;
  for (std::string each; std::getline(stream, each); ++number) {
    text += number == line ? std::string(replacement) : each;
    text += '\n';
  }
  return line == end_of_file ? text + std::string(replacement) + '\n' : text;
}

struct Case {
  const char* name;
  int line;                 // that is replaced
  const char* replacement;  // may hold several lines
  unsigned fault_line;
  unsigned fault_column;
  const char* words;
};

void PrintTo(const Case& wrong, std::ostream* stream) {
  *stream << wrong.name;
}

class WrongMachineFile : public ::testing::TestWithParam<Case> {};

TEST_P(WrongMachineFile, NamesPlaceAndRemedyOfItsOneFault) {
  const Case& wrong = GetParam();
  const TemporaryFiles files;
  const auto path = files.write("m.toml", with_line(wrong.line, wrong.replacement));
  const std::vector<ConfigFault> faults = faults_of_machine(path);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].file, path.string());
  EXPECT_EQ(faults[0].line, wrong.fault_line) << faults[0].text;
  EXPECT_EQ(faults[0].column, wrong.fault_column) << faults[0].text;
  EXPECT_THAT(faults[0].text, HasSubstr(wrong.words));
  EXPECT_EQ(faults.size(), 1U) << "also: " << to_string(faults.back());
}

const Case cases[] = {
    // Keys and kinds
    {"UnknownKeyWithNearest", 8, "velocity_max = 100\nvelosity_max = 1", 9, 1,
     "axis X: unknown key 'velosity_max'; did you mean 'velocity_max'?"},
    {"UnknownKeyFarFromAll", 19, "speed_max = 6000\ncolour = \"red\"", 20, 1,
     "spindle 1: unknown key 'colour'; the keys here are id, speed_max"},
    {"UnknownTable", end_of_file, "[drive]\nbus = \"modbus-tcp\"", 29, 2,
     "machine file: unknown key 'drive'; did you mean 'drives'?"},
    {"MissingKey", 9, "", 3, 1,
     "axis X: key 'acceleration_max' is missing; add it (highest "
     "acceleration, mm/s2, deg/s2)"},
    {"MissingName", 2, "", 1, 1, "[machine]: key 'name' is missing"},
    {"EncodingThatIsNone", 2, "name = \"m\"\nprogram_encoding = \"cp12510\"", 3, 20,
     "`cp12510` is not a known encoding that contains ASCII"},
    {"EncodingWithoutAscii", 2, "name = \"m\"\nprogram_encoding = \"UTF-16\"", 3, 20,
     "`iconv --list` shows the names"},
    {"EmptyName", 2, "name = \"\"", 2, 8, "[machine]: name is empty"},
    {"NameOfAnotherFolder", 2, "name = \"../m\"", 2, 8, "[machine]: name is '../m'; it must have"},
    {"NameWithAFolder", 2, "name = \"a/m\"", 2, 8, "no '/'"},
    {"NameLongerThanAPath", 2,
     "name = \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\"", 2, 8,
     "1 to 64 bytes"},
    {"NameOfTwoLines", 2, "name = \"m\\nX\"", 2, 8,
     "[machine]: name is 'm?X'; write it without control characters"},
    {"NameThatSteersATerminal", 22, "name = \"w\\u001b[2J\"", 22, 8,
     "name is 'w?[2J'; write it without control characters"},
    {"ControlCharacterInAList", 23, "axes = [\"X\", \"C\\t\"]", 23, 14,
     "axes is 'C?'; write it without control characters"},
    {"LimitOfNextToNothing", 10, "jerk_max = 5e-324", 10, 12,
     "axis X: jerk_max is 5e-324; it must be 0.001 to 1e+09"},
    {"LimitOfAnything", 9, "acceleration_max = 1e300", 9, 20,
     "axis X: acceleration_max is 1e+300; it must be 0.001 to 1e+09"},
    {"TextForNumber", 8, "velocity_max = \"fast\"", 8, 16,
     "axis X: velocity_max is a text; write a number (highest velocity, mm/s, deg/s)"},
    {"NumberForText", 4, "name = 5", 4, 8, "axis 1: name is an integer; write a text in quotes"},
    {"NumberForInteger", 2, "name = \"m\"\ncycle_us = 1000.5", 3, 12,
     "[machine]: cycle_us is a number; write an integer"},
    {"NumberForTrueOrFalse", 19, "speed_max = 6000\nwait_at_speed = 1", 20, 17,
     "wait_at_speed is an integer; write true or false"},
    {"TableForTables", 17, "[spindle]", 17, 1,
     "spindle is a table; write tables, each under "
     "[[spindle]]"},
    {"TextForList", 23, "axes = \"X\"", 23, 8, "axes is a text; write a list of texts in quotes"},
    {"NumberInListOfTexts", 28, "axes = [\"X\", 4]", 28, 14, "axes is an integer; write a list"},
    {"Infinite", 10, "jerk_max = inf", 10, 12, "axis X: jerk_max is not finite"},
    {"NotANumber", 10, "jerk_max = nan", 10, 12, "axis X: jerk_max is not finite"},
    {"TooLarge", 18, "id = 99999999999", 18, 6, "id is too large; write an integer"},
    {"NotPositive", 8, "velocity_max = 0", 8, 16,
     "axis X: velocity_max is 0; it must be 0.001 to 1e+09 (highest velocity"},
    {"OutOfRange", 2, "name = \"m\"\ncycle_us = 50", 3, 12,
     "cycle_us is 50; it must be 100 to 20000"},
    {"NotOneOfTheNames", 5, "kind = \"lineal\"", 5, 8,
     "kind is 'lineal'; it must be one of linear, rotary"},
    {"DuplicateKey", 8, "velocity_max = 100\nvelocity_max = 200", 9, 16, "not valid TOML"},
    {"Syntax", 8, "velocity_max = ", 8, 16, "not valid TOML"},
    // Axes
    {"AxisNameTaken", 12, "name = \"X\"\nmin = 0\nmax = 1", 12, 8, "axis X: the name is taken"},
    {"AxisNameOfAnotherWord", 4, "name = \"S1\"", 4, 8, "'S1' is not an axis name; use A, B, C"},
    {"LimitsReversed", 6, "min = 20", 6, 7, "min is 20, max is 10; min must be below max"},
    {"OneEndOfTravel", 6, "", 7, 7, "min is missing; give both ends of travel"},
    {"LinearAxisWithoutTravel", 6, "velocity_max = 1 #", 8, 16, "not valid TOML"},
    {"StartOutsideTravel", 7, "max = 10.0\nstart = 11", 8, 9,
     "start is 11; it must lie between min and max"},
    {"RapidAboveVelocity", 8, "velocity_max = 100\nrapid_max = 101", 9, 13,
     "rapid_max is 101; it must not exceed velocity_max, 100"},
    {"StopLimitsBelowTheLimits", 8, "velocity_max = 100\nstop_limits = 0.9", 9, 15,
     "stop_limits is 0.9; it must be 1 to 2"},
    {"ModuloOfLinearAxis", 8, "velocity_max = 100\nmodulo = 360", 9, 10,
     "modulo is only for rotary axes"},
    {"HomingWithoutVelocity", 10, "jerk_max = 2e4\n[axis.homing]\norder = 1", 11, 1,
     "axis X: homing: velocity of the search is missing"},
    {"HomingTooFast", 10, "jerk_max = 2e4\n[axis.homing]\norder = 1\nvelocity = -200", 13, 12,
     "velocity exceeds velocity_max, 100"},
    {"HomingEndsOutside", 10,
     "jerk_max = 2e4\n[axis.homing]\norder = 1\nvelocity = 10\nposition = 11", 14, 12,
     "E7011 the homing ends at 11.0"},
    {"HomingStopsOutside", 10,
     "jerk_max = 2e4\n[axis.homing]\norder = 1\nvelocity = 10\nvelocity_slow = 10\nposition = 9.99",
     15, 12, "E7011 the homing ends at 10."},
    {"HomingLeavesTheSwitchTooLittle", 10,
     "jerk_max = 2e4\n[axis.homing]\norder = 1\nvelocity = 10\nhome_switch = \"limit\"\nposition = "
     "12",
     15, 12, "E7011 the homing ends at 11.7"},
    {"FormerNameOfTheController", 10, "jerk_max = 2e4\n[axis.regulator]\nkp = 60", 11, 1,
     "axis X: 'regulator' is called 'position_controller' now"},
    {"FormerNameOfTheHomeSwitch", 10,
     "jerk_max = 2e4\n[axis.homing]\norder = 1\nvelocity = 10\nmark = \"limit\"", 14, 8,
     "axis X: homing: 'mark' is called 'home_switch' now"},
    {"CycleLoopWithoutGain", 10, "jerk_max = 2e4\n[axis.position_controller]\nfeedback = \"cycle\"",
     11, 1, "axis X: position_controller: kp is 0"},
    {"CycleLoopTooFastForItsBus", 10,
     "jerk_max = 2e4\n[axis.position_controller]\nfeedback = \"cycle\"\nkp = 60\n"
     "[drives]\nbus = \"modbus-tcp\"\npoll_ms = 10",
     13, 6, "kp is 60; with poll_ms = 10 the loop is well damped up to about 47;"},
    {"UnknownKeyOfADrive", 10, "jerk_max = 2e4\n[axis.drive]\nadress = 4", 12, 1,
     "axis X: drive: unknown key 'adress'; did you mean 'address'?"},
    {"UnknownRegister", 10, "jerk_max = 2e4\n[axis.drive]\nregisters = { controll = 4 }", 12, 15,
     "axis X: drive: registers: unknown key 'controll'; did you mean 'control'?"},
    // Spindles
    {"SpindleIdTaken", 19, "speed_max = 6000\n[[spindle]]\nid = 1\nspeed_max = 1", 21, 6,
     "spindle 1: the id is taken"},
    {"SpindleSpeedsReversed", 19, "speed_max = 6000\nspeed_min = 7000", 20, 13,
     "speed_min exceeds speed_max, 6000"},
    {"SpindleBecomesNoAxis", 19, "speed_max = 6000\naxis = \"C1\"", 20, 8,
     "'C1' is not a rotary axis of the machine"},
    {"SpindleBecomesLinearAxis", 19, "speed_max = 6000\naxis = \"X\"", 20, 8,
     "'X' is not a rotary axis of the machine"},
    // Channels
    {"AxisUnknown", 23, "axes = [\"X\", \"Y\"]", 23, 14,
     "channel 1: 'Y' is not an axis of the machine"},
    {"AxisTwice", 23, "axes = [\"X\", \"X\"]", 23, 14, "axis 'X' appears twice in axes"},
    {"WordsAndAxesDiffer", 23, "axes = [\"X\", \"C\"]\nwords = [\"X\"]", 24, 9,
     "words and axes differ in number (1 and 2)"},
    {"WordTwice", 23, "axes = [\"X\", \"C\"]\nwords = [\"X\", \"X\"]", 24, 15,
     "word 'X' appears twice"},
    {"SpindleUnknown", 24, "spindles = [1, 2]", 24, 16, "there is no spindle 2"},
    {"ActiveSchemeUnknown", 24, "scheme = 7", 24, 10,
     "there is no scheme 7; name one of [[channel.scheme]]"},
    {"PlainCornersOnMill", 24, "plain_corners = true", 24, 17,
     "plain_corners has a meaning only on lathes"},
    {"MeasuringWithinTooFar", 24, "measuring_within = 6", 24, 20,
     "measuring_within is larger than measuring_before"},
    {"MasterWithSpindle", end_of_file,
     "[[channel]]\nid = 2\nname = \"m\"\nkind = \"master\"\n"
     "spindles = [1]",
     33, 12, "channel 2: spindles has no meaning in a master channel"},
    {"MillWithoutAxes", end_of_file, "[[channel]]\nid = 2\nname = \"m\"", 29, 1,
     "channel 2: the channel has no axes"},
    {"ChannelIdTaken", end_of_file, "[[channel]]\nid = 1\nname = \"m\"\nkind = \"master\"", 30, 6,
     "channel 1: the id is taken"},
    {"AxisOfAnotherChannel", end_of_file, "[[channel]]\nid = 2\nname = \"b\"\naxes = [\"C\"]", 32,
     8, "axis 'C' takes part in the power-on scheme of channel 1, too"},
    {"CodeThatIsNone", 24, "spindles = [1]\n[channel.codes]\nX200 = \"a.nc\"", 26, 1,
     "'X200' is not a G or M code"},
    {"AliasOfTwoLetters", 24, "spindles = [1]\n[channel.address_alias]\nEE = \"dS\"", 26, 1,
     "'EE' is not a single capital letter"},
    {"AliasOfAnAxis", 24, "spindles = [1]\n[channel.address_alias]\nC = \"dS\"", 26, 1,
     "'C' is an axis of the channel"},
    {"AliasOfALetterOfCodes", 24, "spindles = [1]\n[channel.address_alias]\nF = \"dS\"", 26, 1,
     "'F' has a meaning in every program; only A, B, C and E can be free, or V and W"},
    {"AliasOfAnIncrement", 24,
     "spindles = [1]\nkind = \"lathe\"\n[channel.address_alias]\nW = \"dS\"", 27, 1,
     "'W' has a meaning in every program; only A, B, C and E can be free"},
    {"AliasOfNoAddress", 24, "spindles = [1]\n[channel.address_alias]\nE = \"depth\"", 26, 1,
     "'depth' is not a named address"},
    {"AliasOfAnAddressOfLaterReleases", 24, "spindles = [1]\n[channel.address_alias]\nE = \"SPOS\"",
     26, 1, "'SPOS' is not a named address"},
    {"AliasOfANumber", 24, "spindles = [1]\n[channel.address_alias]\nE = 1", 26, 5,
     "address_alias is an integer; write a text in quotes"},
    // Schemes
    {"TypeUnknown", 27, "type = \"hexapod\"", 27, 8,
     "channel 1: scheme 1: type is 'hexapod'; it must be one of cartesian, lathe, "},
    {"ParkedAndJoined", end_of_file, "[[channel.scheme.parked]]\naxis = \"C\"", 30, 8,
     "axis 'C' takes part and is parked as well"},
    {"ParkedTwice", 28,
     "axes = [\"X\"]\n[[channel.scheme.parked]]\naxis = \"C\"\n[[channel.scheme.parked]]\n"
     "axis = \"C\"",
     32, 8, "axis 'C' is parked twice"},
    {"NeitherParkedNorJoined", 28, "axes = [\"X\"]", 28, 8,
     "axis 'C' neither takes part nor is parked; name it in axes or add [[parked]] axis = \"C\""},
    {"ParkedOutsideTravel", 28,
     "axes = [\"C\"]\n[[channel.scheme.parked]]\naxis = \"X\"\nposition = 20", 31, 12,
     "axis 'X' cannot reach 20; its travel is -10 to 10"},
    {"ParkedTooFast", 28, "axes = [\"C\"]\n[[channel.scheme.parked]]\naxis = \"X\"\nvelocity = 101",
     31, 12, "velocity is 101; the axis reaches at most 100"},
    {"SchemeAxisUnknown", 28, "axes = [\"X\", \"C\", \"Q\"]", 28, 19,
     "'Q' is not an axis of the channel; its axes are X, C"},
    {"ZeroOfParkedAxis", 28,
     "axes = [\"X\"]\nzero = { X = 1, C = 2 }\n[[channel.scheme.parked]]\naxis = \"C\"", 29, 17,
     "axis 'C' does not take part; a parked axis has no zero"},
    {"ZeroOfUnknownAxis", end_of_file, "zero = { Q = 1 }", 29, 10,
     "'Q' is not an axis of the channel"},
    {"ZeroIsNoNumber", end_of_file, "zero = { X = \"a\" }", 29, 14, "X is a text; write a number"},
    {"RetractOutsideTravel", end_of_file, "retract = { X = 50 }", 29, 17,
     "axis 'X' cannot reach 50"},
    {"GeometryOfAnotherType", end_of_file, "table_centre = [0, 0, 0]", 29, 16,
     "table_centre belongs to a scheme of type head_table or table_table"},
    {"SchemeIdTaken", end_of_file,
     "[[channel.scheme]]\nid = 1\ntype = \"cartesian\"\naxes = [\"X\", \"C\"]", 30, 6,
     "channel 1: scheme 1: the id is taken"},
    {"SchemeFileMissing", end_of_file, "[[channel.scheme]]\nid = 2\nfile = \"none.toml\"", 31, 8,
     "none.toml' does not exist; its path is relative to the machine file"},
    {"FileAndInlineScheme", end_of_file,
     "[[channel.scheme]]\nid = 2\nfile = \"m.toml\"\ntype = \"cartesian\"", 32, 1,
     "unknown key 'type'; the keys here are id, file"},
    // Automatic feed laws
    {"AutomaticLawUnknown", end_of_file,
     "[[channel.automatic_feed]]\nlaw = \"curve\"\nlevel = 5\nfeed_min = 0.5", 30, 7,
     "law is 'curve'; it must be one of modulated, linear"},
    {"AutomaticLawWithoutLevel", end_of_file,
     "[[channel.automatic_feed]]\nlaw = \"linear\"\nfeed_min = 0.5", 29, 1,
     "automatic_feed: key 'level' is missing"},
    {"AutomaticLawNeverLetsGo", end_of_file,
     "[[channel.automatic_feed]]\nlaw = \"linear\"\nlevel = 5\nrelease = 6\nfeed_min = 0.5", 32, 11,
     "release exceeds level, 5; the law would never release the feed"},
    {"AutomaticLawStepTooLarge", end_of_file,
     "[[channel.automatic_feed]]\nlaw = \"linear\"\nlevel = 5\nfeed_min = 0.75\nfeed_step = 0.5",
     33, 13, "one increment leads below feed_min, 0.75; use at most 0.25"},
    {"AutomaticLawFeedZero", end_of_file,
     "[[channel.automatic_feed]]\nlaw = \"linear\"\nlevel = 5\nfeed_min = 0", 32, 12,
     "feed_min is 0; it must be"},
    {"AutomaticLawTwice", end_of_file,
     "[[channel.automatic_feed]]\nlaw = \"linear\"\nlevel = 5\nfeed_min = 0.5\n"
     "[[channel.automatic_feed]]\nlaw = \"linear\"\nlevel = 9\nfeed_min = 0.5",
     34, 7, "the law appears twice; a channel has at most one of each"},
    // Services
    {"ContactOfUnknownAxis", end_of_file, "[[contact]]\ninput = 1\naxis = \"Q\"\nto = 0", 31, 8,
     "'Q' is not an axis of the machine; write the name of an [[axis]]"},
    {"ContactAlwaysOn", end_of_file, "[[contact]]\ninput = 1\naxis = \"X\"", 29, 1,
     "neither from nor to is given; the input would always be on"},
    {"ContactNeverOn", end_of_file, "[[contact]]\ninput = 1\naxis = \"X\"\nfrom = 1\nto = 0", 33, 6,
     "to is below from, 1; the input would never be on"},
    {"SkipInputUnknown", 23, "axes = [\"X\", \"C\"]\nskip_inputs = [7, 64]", 24, 19,
     "there is no digital input 64; they are 0 to 63"},
    {"RealToolUnknown", end_of_file, "[[simulation.tool]]\nnumber = 4", 30, 10,
     "the tables file has no such tool and edge; give it a [[tool]] there"},
    {"SetterWithoutProbeInput", end_of_file,
     "[simulation.tool_setter]\nchannel = 1\nx = 0\ny = 0\nz = 0\ndiameter = 8", 30, 11,
     "channel 1 has no probe_input; add one to the channel"},
    {"BusUnknown", end_of_file, "[drives]\nbus = \"ethercat\"", 30, 7,
     "bus is 'ethercat'; it must be one of modbus-tcp, modbus-rtu"},
    {"SerialBusWithoutDevice", end_of_file, "[drives]\nbus = \"modbus-rtu\"", 30, 7,
     "[drives]: key 'device' is missing"},
    {"TimeoutBelowPoll", end_of_file,
     "[drives]\nbus = \"modbus-tcp\"\npoll_ms = 50\ntimeout_ms = 20", 32, 14,
     "timeout_ms is shorter than poll_ms, 50"},
    {"LeastLengthAboveTheLargest", end_of_file,
     "[entry_limits]\ntool_length_min = 50\ntool_length_max = 50", 30, 19,
     "[entry_limits]: tool_length_min is not less than tool_length_max, 50"},
    {"WearBelowZero", end_of_file, "[entry_limits]\nwear_max = -1", 30, 12,
     "[entry_limits]: wear_max is -1"},
    {"TablesMissing", 2, "name = \"m\"\ntables = \"none.toml\"", 3, 10,
     "none.toml' does not exist; its path is relative to the machine file"},
    {"FeedClampsReversed", end_of_file, "[process]\nfeed_min = 20\nfeed_max = 10", 30, 12,
     "[process]: feed_min exceeds feed_max, 10"},
    {"LcmWithoutUrl", end_of_file, "[lcm]", 29, 1, "[lcm]: key 'url' is missing"},
};

INSTANTIATE_TEST_SUITE_P(Cases, WrongMachineFile, ::testing::ValuesIn(cases),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

TEST(MachineFaults, TheValidFileHasNone) {
  const TemporaryFiles files;
  EXPECT_THAT(faults_of_machine(files.write("m.toml", valid_file)), ::testing::IsEmpty());
}

TEST(MachineFaults, AxisOfASpindleBelongsToOneChannelAndAllItsSchemes) {
  const TemporaryFiles files;
  const std::string spindle_axis = with_line(19, "speed_max = 6000\naxis = \"C\"");
  const auto shared = faults_of_machine(files.write(
      "shared.toml", spindle_axis + "[[channel]]\nid = 2\nname = \"b\"\naxes = [\"C\"]\n"));
  ASSERT_FALSE(shared.empty());
  EXPECT_EQ(shared[0].line, 24U);
  EXPECT_THAT(shared[0].text, HasSubstr("axis 'C' is spindle 1; only one channel can have it"));
  std::string parked = spindle_axis;
  parked.replace(parked.rfind("axes = [\"X\", \"C\"]"), std::string::npos,
                 "axes = [\"X\"]\n[[channel.scheme.parked]]\naxis = \"C\"\n");
  const auto left_out = faults_of_machine(files.write("parked.toml", parked));
  ASSERT_EQ(left_out.size(), 1U);
  EXPECT_EQ(left_out[0].line, 25U);
  EXPECT_THAT(left_out[0].text, HasSubstr("scheme 1 leaves out axis 'C', which is spindle 1"));
}

TEST(MachineFaults, ASchemeMayLeaveOutAnAxisThatAnotherChannelHas) {
  const TemporaryFiles files;
  const std::string text = std::string(valid_file) +
                           "[[channel]]\nid = 2\nname = \"b\"\naxes = [\"Y\", \"C\"]\n"
                           "[[channel.scheme]]\nid = 1\ntype = \"cartesian\"\naxes = [\"Y\"]\n"
                           "[[axis]]\nname = \"Y\"\nkind = \"linear\"\nmin = 0\nmax = 1\n"
                           "velocity_max = 1\nacceleration_max = 1\njerk_max = 1\n";
  EXPECT_THAT(faults_of_machine(files.write("m.toml", text)), ::testing::IsEmpty());
}

TEST(MachineFaults, LinearAxisNeedsItsTravel) {
  const TemporaryFiles files;
  std::string text = with_line(6, "");
  text.erase(text.find("max = 10.0"), std::string_view("max = 10.0").size());
  const auto faults = faults_of_machine(files.write("m.toml", text));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].line, 3U);
  EXPECT_THAT(faults[0].text, HasSubstr("axis X: keys 'min' and 'max' are missing"));
}

TEST(MachineFaults, AreAllShownInTheOrderOfTheFile) {
  const TemporaryFiles files;
  const auto path = files.write("m.toml",
                                "[machine]\n"
                                "nme = \"m\"\n"
                                "[[axis]]\n"
                                "name = \"X\"\n"
                                "kind = \"linear\"\n"
                                "min = 10\n"
                                "max = -10\n"
                                "velocity_max = -1\n"
                                "acceleration_max = 1000\n"
                                "jerk_max = 20000\n"
                                "[[channel]]\n"
                                "id = 1\n"
                                "name = \"work\"\n"
                                "axes = [\"X\"]\n"
                                "tool_change = \"m5\"\n");
  const std::string name = path.string();
  try {
    static_cast<void>(read_machine_file(path));
    FAIL() << "a wrong file was accepted";
  } catch (const ConfigError& error) {
    const std::string text = error.what();
    EXPECT_EQ(
        text,
        name +
            ":1:1: [machine]: key 'name' is missing; add it (name of the machine, of its files, "
            "and on "
            "the LCM bus)\n" +
            name + ":2:1: [machine]: unknown key 'nme'; did you mean 'name'?\n" + name +
            ":6:7: axis X: min is 10, max is -10; min must be below max\n" + name +
            ":8:16: axis X: velocity_max is -1; it must be 0.001 to 1e+09 (highest velocity, mm/s, "
            "deg/s)\n" +
            name + ":15:15: channel 1: tool_change is 'm5'; it must be one of m6, t_word");
  }
}

TEST(MachineFaults, OfASchemeFileNameThatFile) {
  const TemporaryFiles files;
  const auto scheme = files.write("schemes/table.toml",
                                  "type = \"head_table\"\n"
                                  "axes = [\"X\", \"C\"]\n"
                                  "pivot_to_spindle = [0, 0]\n");
  const auto path = files.write(
      "m.toml",
      with_line(end_of_file, "[[channel.scheme]]\nid = 2\nfile = \"schemes/table.toml\""));
  const auto faults = faults_of_machine(path);
  ASSERT_EQ(faults.size(), 3U);
  for (const ConfigFault& fault : faults) EXPECT_EQ(fault.file, scheme.string());
  EXPECT_EQ(to_string(faults[0]),
            scheme.string() +
                ":1:1: channel 1: scheme 2: key 'table_centre' is missing; a head_table "
                "scheme needs it");
  EXPECT_EQ(faults[1].text,
            "channel 1: scheme 2: 'B' is not an axis of the channel; its axes are X, C");
  EXPECT_EQ(faults[2].line, 3U);
  EXPECT_EQ(faults[2].column, 20U);
  EXPECT_THAT(faults[2].text,
              HasSubstr("pivot_to_spindle is a list; write a list of three numbers"));
}

// 20,000 tools without a number: the first faults are told, the others cost no memory.
TEST(MachineFaults, AreKeptAsLongAsPeopleReadOn) {
  std::string text = "tool = [";
  for (int k = 0; k < 20'000; ++k) text += "{}, ";
  const TemporaryFiles files;
  files.write("tables.toml", text + "]\n");
  const auto path = files.write("m.toml", with_line(2, "name = \"m\"\ntables = \"tables.toml\""));
  const auto faults = faults_of_machine(path);
  ASSERT_EQ(faults.size(), FaultList::kept_max + 1);
  EXPECT_THAT(faults[0].text, HasSubstr("key 'number' is missing"));
  EXPECT_THAT(faults.back().text, HasSubstr("more faults than the 1000"));
}

TEST(MachineFaults, OfTheTablesNameThatFile) {
  const TemporaryFiles files;
  const auto tables = files.write("tables.toml",
                                  "[[tool]]\n"
                                  "number = 1\n"
                                  "radius = 3\n"
                                  "corner_radius = 4\n"
                                  "[[tool]]\n"
                                  "number = 1\n"
                                  "[offset.G54]\n"
                                  "Y = 1\n"
                                  "[offset.G60]\n"
                                  "X = 1\n");
  const auto path = files.write("m.toml", with_line(2, "name = \"m\"\ntables = \"tables.toml\""));
  const auto faults = faults_of_machine(path);
  ASSERT_EQ(faults.size(), 4U);
  const std::string file = tables.string();
  EXPECT_EQ(to_string(faults[0]), file + ":4:17: tool 1: corner_radius exceeds radius, 3");
  EXPECT_THAT(to_string(faults[1]),
              HasSubstr(file + ":6:10: tool 1: edge 1 of this tool appears twice"));
  EXPECT_THAT(to_string(faults[2]), HasSubstr(file + ":8:1: offset G54: unknown key 'Y'"));
  EXPECT_THAT(to_string(faults[3]), HasSubstr(file + ":9:9: offset G60: no such work offset"));
}

TEST(MachineFaults, OfAFileThatCannotBeReadNameItAndTheCause) {
  const TemporaryFiles files;
  const auto missing = files.folder() / "none.toml";
  const auto faults = faults_of_machine(missing);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(to_string(faults[0]), missing.string() +
                                      ": cannot read the file: No such file or directory; check "
                                      "the path");
  const auto folder_faults = faults_of_machine(files.folder());
  ASSERT_EQ(folder_faults.size(), 1U);
  EXPECT_THAT(folder_faults[0].text, HasSubstr("it is a directory"));
}

// Whatever a file holds, the reader returns or throws ConfigError: characters replaced and lines
// dropped at random.
TEST(MachineFaults, OfADamagedFileAreNeverMoreThanConfigErrors) {
  constexpr unsigned seed = 7106;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  constexpr std::string_view characters = "[]{}=\"'\n#.,-0123456789aXeinf\t\\\x80";
  std::mt19937 engine(seed);
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine);
  };
  const TemporaryFiles files;
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    std::string text =
        i % 3 == 0 ? with_line(static_cast<int>(below(28)) + 1, "") : std::string(valid_file);
    for (std::size_t damages = below(3); damages > 0; --damages) {
      text[below(text.size())] = characters[below(characters.size())];
    }
    refused += faults_of_machine(files.write("m.toml", text)).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 150);  // the damage does reach the reader
}

TEST(MachineFaults, OfOneDriveAddressForTwoAxes) {
  const TemporaryFiles files;
  const auto path =
      files.write("m.toml", with_line(10, "jerk_max = 2e4\n[axis.drive]\naddress = 2") +
                                "[drives]\nbus = \"modbus-tcp\"\n");
  const auto faults = faults_of_machine(path);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].line, 13U);
  EXPECT_THAT(faults[0].text, HasSubstr("axis C: its drive has the address of axis X, 2"));
}

}  // namespace
}  // namespace stanok::config
