"""jog_max: the highest velocity at which an axis is jogged."""
from recipe import Recipe, after, before, replaced

RECIPE = Recipe("An axis limit", [
    after("motion/path/path.h", "  double rapid_max = unlimited;", "  double jog_max = unlimited;"),
    after("motion/path/path.h", """
  [[nodiscard]] double rapid_speed_max() const RT_SAFE { return std::min(rapid_max, velocity_max); }
""", """
  // And of jogging.
  [[nodiscard]] double jog_speed_max() const RT_SAFE { return std::min(jog_max, velocity_max); }
"""),
    after("config/sections/axis_section.cc", """
       "mm/s, deg/s", "velocity of rapid moves", limit_of_motion, "velocity_max"},
""", """
      {"jog_max", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::jog_max>, optional,
       "mm/s, deg/s", "highest velocity of jogging", limit_of_motion, "velocity_max"},
"""),
    before("config/sections/axis_section.cc", """
  if (axis.modulo_deg > 0.0 && !axis.rotary) {
    scope.fault(place_of(table, "modulo"), "modulo is only for rotary axes; remove it");
""", """
  if (table.contains("jog_max") && axis.limits.jog_max > axis.limits.velocity_max) {
    scope.fault(place_of(table, "jog_max"), "jog_max is " + number_text(axis.limits.jog_max) +
                                                "; it must not exceed velocity_max, " +
                                                number_text(axis.limits.velocity_max));
  }
"""),
    replaced("channels/axes/manual_motion.cc",
             "  double speed = std::min(std::abs(jog.velocity), limits.velocity_max);",
             "  double speed = std::min(std::abs(jog.velocity), limits.jog_speed_max());"),
    replaced("channels/axes/straight_jog.cc",
             "    move.speed = std::min(move.speed, limits.velocity_max / share);",
             "    move.speed = std::min(move.speed, limits.jog_speed_max() / share);"),
    replaced("config/files/machine_remarks.cc", """
namespace stanok::config {

// Between two polls a drive goes on with the velocity of the one before, while a stop brakes: where
// that is farther than it may stray the drive may trip in each stop.
std::vector<std::string> remarks_on(const MachineFile& machine) {
  std::vector<std::string> remarks;
""", """
namespace stanok::config {
namespace {

// Nobody expects an axis to be faster by hand than in a program.
void remark_on_jogging(const channels::AxisConfig& axis, std::vector<std::string>& remarks) {
  const double jog_max = axis.limits.jog_max;
  if (std::isinf(jog_max) || jog_max <= axis.limits.rapid_max) return;
  remarks.push_back("axis " + axis.name + ": jog_max, " + number_text(jog_max) +
                    ", is above rapid_max, " + number_text(axis.limits.rapid_max) +
                    ": the axis is faster when it is jogged than in a program");
}

}  // namespace

// Between two polls a drive goes on with the velocity of the one before, while a stop brakes: where
// that is farther than it may stray the drive may trip in each stop.
std::vector<std::string> remarks_on(const MachineFile& machine) {
  std::vector<std::string> remarks;
  for (const channels::AxisConfig& axis : machine.machine.axes) remark_on_jogging(axis, remarks);
"""),
    before("config/files/machine_remarks.cc", '#include "channels/contract/machine_config.h"', "#include <cmath>\n\n"),
    after("python/native/machine_binding.cc", '          {"jerk_max", axis.limits.jerk_max},',
          '          {"jog_max", axis.limits.jog_speed_max()},'),
    after("python/stanok/machine.py", "    jerk_max: float | None", "    jog_max: float | None"),
    after("docs/reference/configuration.md", """
| `rapid_max` | number | mm/s, deg/s | velocity_max | 0.001 to 1e+09 | velocity of rapid moves |
""", """
| `jog_max` | number | mm/s, deg/s | velocity_max | 0.001 to 1e+09 | highest velocity of jogging |
"""),
    after("tests/channels/axes/manual_motion_test.cc", """
TEST_F(JogFrom, TheEndOfTheTravelGoesInwardsOnly) {
  EXPECT_EQ(jog(100.0, 10.0), "E6053");
  EXPECT_EQ(jog(100.0, -10.0, 5.0), "");
  EXPECT_EQ(end(100.0), 95.0);
}
""", """

TEST(JogLimit, HoldsBelowTheVelocityOfTheAxis) {
  ManualAxis axis;
  axis.limits = {.velocity_max = 200.0, .acceleration_max = 1e3, .jerk_max = 2e4, .jog_max = 50.0};
  ManualMotion manual;
  manual.set_up({&axis, 1}, 0.001);
  AxisFeedback drive;
  drive.valid = drive.referenced = true;
  ASSERT_EQ(manual.jog({.axis = 0, .velocity = 150.0, .increment = 40.0}, 0.0, drive), "");
  std::array<kinematics::Jet, 1> position{};
  double fastest = 0.0;
  while (manual.is_active()) {
    manual.advance({&drive, 1}, position);
    fastest = std::max(fastest, position[0].first);
  }
  EXPECT_NEAR(fastest, 50.0, 1e-9);
  EXPECT_EQ(position[0].value, 40.0);
}
"""),
    after("tests/channels/axes/straight_jog_test.cc", """
TEST_F(StraightJogTest, KeepsTheLimitsOfEveryAxis) {
  ASSERT_EQ(begin(1e5), "");
  run();
  EXPECT_LE(share, 1.0 + 1e-12);
  EXPECT_GT(share, 0.99);
}
""", """

// X makes 0.6 mm a millimetre: 30 mm/s of it are 50 mm/s, and 40 mm/s of Y.
TEST_F(StraightJogTest, KeepsTheLimitOfJogging) {
  axes[0].limits.jog_max = 30.0;
  ASSERT_EQ(begin(1e5), "");
  run(1000);
  EXPECT_NEAR(positions[0].first, 30.0, 1e-9);
  EXPECT_NEAR(positions[1].first, 40.0, 1e-9);
}
"""),
    after("tests/config/files/machine_file_test.cc", "rapid_max = 300.0", "jog_max = 100.0"),
    after("tests/config/files/machine_file_test.cc", "  EXPECT_EQ(axis.limits.rapid_max, 300.0);",
          "  EXPECT_EQ(axis.limits.jog_max, 100.0);"),
    after("tests/config/machine_faults_test.cc", '     "rapid_max is 101; it must not exceed velocity_max, 100"},', """
    {"JogAboveVelocity", 8, "velocity_max = 100\\njog_max = 101", 9, 11,
     "jog_max is 101; it must not exceed velocity_max, 100"},
"""),
    before("tests/config/sections/drive_section_test.cc", """
// a T^2 / 2 = 1.2 x 1000 mm/s2 x (50 ms)^2 / 2 = 1.5 mm.
""", """
TEST_F(DriveSectionTest, AJogThatIsFasterThanRapidIsRemarkedOn) {
  EXPECT_TRUE(remarks_on(read("rapid_max = 50\\n")).empty()) << "no limit of jogging";
  EXPECT_TRUE(remarks_on(read("rapid_max = 50\\njog_max = 50\\n")).empty());
  const std::vector<std::string> remarks = remarks_on(read("rapid_max = 50\\njog_max = 60\\n"));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_THAT(remarks[0], HasSubstr("axis X: jog_max, 60, is above rapid_max, 50"));
}

"""),
])
