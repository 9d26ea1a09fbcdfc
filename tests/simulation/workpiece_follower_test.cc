// Tools over a workpiece by the readings of the axes: through schemes, switches and new places.
#include "simulation/workpiece_follower.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace stanok::simulation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double rad_per_deg = std::numbers::pi / 180.0;

// Axes X Y Z B C. Scheme 1: a vise, B and C stand at 0. Scheme 2: head B, table C.
kinematics::SchemeConfig vise() {
  kinematics::SchemeConfig config;
  config.id = 1;
  config.type = "cartesian";
  config.axes = {0, 1, 2};
  config.linear = {0, 1, 2};
  config.zero = {-300.0, -40.0, -100.0};
  return config;
}

kinematics::SchemeConfig table() {
  kinematics::SchemeConfig config;
  config.id = 2;
  config.type = "head_table";
  config.axes = {0, 1, 2, 3, 4};
  config.linear = {0, 1, 2};
  config.geometry = kinematics::HeadTable::Geometry{.head_axis = 3,
                                                    .table_axis = 4,
                                                    .pivot_to_spindle = {0.0, 0.0, -200.0},
                                                    .table_centre = {5.0, 7.0, -350.0}};
  config.zero = kinematics::zero_default(config);
  return config;
}

ChannelGeometry two_schemes() {
  ChannelGeometry geometry;
  geometry.schemes.emplace(1, kinematics::make_scheme(vise()));
  geometry.schemes.emplace(2, kinematics::make_scheme(table()));
  return geometry;
}

ToolMount mount(double length) {
  return {Vector(0.0, 0.0, -length)};
}

Eigen::Matrix3d turn(double angle_deg, const Vector& axis) {
  return Eigen::AngleAxisd(angle_deg * rad_per_deg, axis).toRotationMatrix();
}

// The drawing of the machine: the tip hangs under the pivot of the head, which turns by B; the part
// stands on the table, which turns by C.
Vector tip_over_bed(const Axes& axes_M, double length) {
  const Vector pivot(axes_M[0], axes_M[1], axes_M[2]);
  return pivot + turn(axes_M[3], Vector::UnitY()) * Vector(0.0, 0.0, -200.0 - length);
}

TEST(MachineGeometry, PutsTheTipWhereTheDrawingHasIt) {
  const MachineGeometry machine(two_schemes());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> way(-200.0, 200.0);
  std::uniform_real_distribution<double> angle(-90.0, 90.0);
  for (int trial = 0; trial < 50; ++trial) {
    const Axes axes_M{way(random), way(random), way(random), angle(random), angle(random)};
    const Vector over_bed = tip_over_bed(axes_M, 75.0);
    const Vector axis = turn(axes_M[3], Vector::UnitY()) * Vector::UnitZ();
    const Eigen::Matrix3d on_table = turn(axes_M[4], Vector::UnitZ()).transpose();
    const Vector centre(5.0, 7.0, -350.0);

    const ToolPlace table_place = machine.place_in(2, 2, axes_M, mount(75.0));
    EXPECT_TRUE(table_place.tip.isApprox(on_table * (over_bed - centre), 1e-9));
    EXPECT_TRUE(table_place.axis.isApprox(on_table * axis, 1e-9));

    // In the vise: its base lies at its zero, which is a reading of the pivot, 200 above the nose.
    const Vector vise_zero(-300.0, -40.0, -100.0 - 200.0);
    const ToolPlace vise_place = machine.place_in(1, 2, axes_M, mount(75.0));
    EXPECT_TRUE(vise_place.tip.isApprox(over_bed - vise_zero, 1e-9));
    EXPECT_TRUE(vise_place.axis.isApprox(axis, 1e-9));

    // Driven by the vise's scheme the head is upright; the table stays where it was turned to.
    Axes upright_M = axes_M;
    upright_M[3] = 0.0;
    const ToolPlace upright = machine.place_in(2, 1, upright_M, mount(75.0));
    EXPECT_TRUE(upright.tip.isApprox(on_table * (tip_over_bed(upright_M, 75.0) - centre), 1e-9));
  }
}

TEST(ToolMount, PointsAlongItsLongestPart) {
  EXPECT_EQ(mount(80.0).axis(), Vector::UnitZ());
  EXPECT_EQ(ToolMount{}.axis(), Vector::UnitZ());
  EXPECT_EQ(ToolMount{Vector(90.0, 0.0, -30.0)}.axis(), -Vector::UnitX());
}

// A lathe's spindle as an axis turns the part under a standing tool: seen from the part, the tool
// goes round it (docs/integrator/kinematics.md, polar_face).
TEST(MachineGeometry, TurnsThePartOfALathe) {
  ChannelGeometry geometry = two_schemes();
  geometry.turning_axis = 4;
  const MachineGeometry machine(geometry);
  const ToolPlace place{{10.0, 0.0, 3.0}, Vector::UnitX()};
  const ToolPlace turned = machine.turned_with_workpiece(1, {0, 0, 0, 0, 90.0}, place);
  EXPECT_TRUE(turned.tip.isApprox(Vector(0.0, 10.0, 3.0), 1e-12));
  EXPECT_TRUE(turned.axis.isApprox(Vector::UnitY(), 1e-12));
}

// A follower with a flat mill of 6 as tool 1, and what it complains of.
class Following : public ::testing::Test {
 protected:
  static ToolRecords tools() {
    ToolRecord record;
    record.shape.radius = 3.0;
    record.shape.flute_length = 20.0;
    record.mount = mount(80.0);
    ToolRecord shapeless = record;
    shapeless.shape.radius = 0.0;
    return {{{1, 1}, record}, {{2, 1}, shapeless}};
  }

  Announcement block() const {
    Announcement announcement;
    announcement.blank.size = {40.0, 30.0, 10.0};
    announcement.blank.zero = {20.0, 15.0, 10.0};
    announcement.blank.resolution = 0.5;
    announcement.program_in_base.translation() = Vector(50.0, 60.0, 70.0);
    return announcement;
  }

  // The reading of the axes with the tip of tool 1 at a point of the vise's base.
  Sample at(double x, double y, double z, std::uint32_t line) const {
    Sample sample;
    sample.axes_M = {x - 300.0, y - 40.0, z - 100.0 + 80.0, 0.0, 0.0};
    sample.scheme = 1;
    sample.tool = 1;
    sample.spindle_turns = true;
    sample.origin = {1, 1, line, line, 0};
    return sample;
  }
  double removed() const {
    double sum = 0.0;
    for (const auto& workpiece : follower.workpieces()) sum += workpiece->report().removed_mm3();
    return sum;
  }
  // 2 deep along X at this distance from the middle of the block, seen from the base.
  void cut_groove(double x, double y, double z) {
    follower.follow(at(x - 30.0, y, z, 1));
    follower.follow(at(x + 30.0, y, z, 2));
    follower.follow(at(x + 30.0, y, z + 50.0, 3));
    follower.flush();
  }

  std::vector<std::string> complaints;
  WorkpieceFollower follower{
      two_schemes(), tools(), memory_default,
      [this](const std::string& code, const std::string&) { complaints.push_back(code); }};
};

TEST_F(Following, CutsWhereTheProgramHasItsZero) {
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  cut_groove(50.0, 60.0, 70.0 - 2.0);
  EXPECT_NEAR(removed(), 40.0 * 6.0 * 2.0, 10.0);
  EXPECT_THAT(complaints, IsEmpty());
}

// Its zero is put to X 110, Y 60, Z 70 of the base, turned half round about Z: a groove off the
// middle lies on the other side afterwards, and is still there when it comes back.
TEST_F(Following, MovesTheCutBlank) {
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  cut_groove(50.0, 66.0, 68.0);
  const double one_groove = removed();
  EXPECT_GT(one_groove, 100.0);
  follower.place({{110.0 - 300.0, 60.0 - 40.0, 70.0 - 100.0}, {180.0, 0.0, 0.0}},
                 at(0.0, 0.0, 200.0, 5));
  cut_groove(110.0, 54.0, 68.0);
  EXPECT_NEAR(removed(), one_groove, 2.0);
  cut_groove(110.0, 66.0, 68.0);
  EXPECT_NEAR(removed(), 2.0 * one_groove, 10.0);
  follower.place({{50.0 - 300.0, 60.0 - 40.0, 70.0 - 100.0}, Vector::Zero()},
                 at(0.0, 0.0, 200.0, 9));
  cut_groove(50.0, 66.0, 68.0);
  cut_groove(50.0, 54.0, 68.0);
  EXPECT_NEAR(removed(), 2.0 * one_groove, 12.0);
  EXPECT_EQ(follower.workpieces().size(), 1U);
}

// On its side: Z-X'-Z'' by (0, 90, 0) turns Y to Z.
TEST_F(Following, TakesEulerAngles) {
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  follower.place({{50.0 - 300.0, 60.0 - 40.0, 70.0 - 100.0}, {0.0, 90.0, 0.0}},
                 at(0.0, 0.0, 200.0, 5));
  // Its face at Y 15 of the program looks up, 15 above the zero; it is 10 thick along -Y now,
  // from Y 60 to 70.
  cut_groove(50.0, 65.0, 70.0 + 15.0 - 2.0);
  EXPECT_NEAR(removed(), 40.0 * 6.0 * 2.0, 10.0);
}

// Over the first half of the block with a radius of 3, then, without a stop, with 2 and 1 deeper.
TEST_F(Following, ChangesTheToolInTheMiddleOfAMotion) {
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  for (int x = -30; x <= 0; x += 10) follower.follow(at(50.0 + x, 60.0, 68.0, 1));
  ToolRecord changed = tools().at({1, 1});
  changed.shape.radius = 2.0;
  changed.mount = mount(81.0);
  follower.change_tool(1, 1, changed);
  follower.change_tool(7, 1, changed);
  for (int x = 10; x <= 30; x += 10) follower.follow(at(50.0 + x, 60.0, 68.0, 1));
  follower.flush();
  // Half a disk of the first reaches into the second half, part of it beside the narrow groove;
  // half a disk of the second lies in the wide one, 1 deeper.
  const double pi = std::numbers::pi;
  const double in_both = 2.0 * std::sqrt(5.0) + 9.0 * std::asin(2.0 / 3.0);
  const double upper = 20.0 * 6.0 + 4.5 * pi + 20.0 * 4.0 - in_both;
  const double lower = 20.0 * 4.0 + 2.0 * pi;
  EXPECT_NEAR(removed(), upper * 2.0 + lower * 1.0, 10.0);
  EXPECT_THAT(complaints, IsEmpty());
}

// One that could not be seen, and one that can no longer be.
TEST_F(Following, SeesAToolFromItsRowOn) {
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  ToolRecord record = tools().at({1, 1});
  const auto groove = [&](double y) {
    for (const double x : {20.0, 80.0}) {
      Sample sample = at(x, y, 68.0, 1);
      sample.tool = 2;
      follower.follow(sample);
    }
    Sample above = at(80.0, y, 200.0, 1);
    above.tool = 2;
    follower.follow(above);
    follower.flush();
  };
  groove(52.0);
  EXPECT_EQ(removed(), 0.0);
  follower.change_tool(2, 1, record);
  groove(60.0);
  EXPECT_NEAR(removed(), 40.0 * 6.0 * 2.0, 10.0);
  const double one_groove = removed();
  record.shape.radius = 0.0;
  follower.change_tool(2, 1, record);
  groove(68.0);
  EXPECT_EQ(removed(), one_groove);
  EXPECT_THAT(complaints, ElementsAre("W925"));
}

TEST_F(Following, SaysWhatItCannotFollow) {
  follower.place({}, at(0.0, 0.0, 0.0, 7));
  EXPECT_THAT(complaints, ElementsAre("W926"));
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  Sample sample = at(50.0, 60.0, 68.0, 8);
  for (const int tool : {2, 3, 2, 3}) {
    ++sample.origin.line;
    sample.tool = tool;
    follower.follow(sample);
  }
  EXPECT_THAT(complaints, ElementsAre("W926", "W925", "W925"));
  Announcement none = block();
  none.blank.size.x() = 0.0;
  follower.announce(none, at(0.0, 0.0, 200.0, 9));
  EXPECT_THAT(complaints, ElementsAre("W926", "W925", "W925", "E9202"));
}

// Samples a hundredth of a millimetre apart along an arc cut what the arc does.
TEST_F(Following, JoinsSamplesOnOneWay) {
  follower.announce(block(), at(0.0, 0.0, 200.0, 1));
  follower.follow(at(60.0, 60.0, 80.0, 1));
  for (int i = 0; i <= 6000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 6000.0;
    follower.follow(at(50.0 + 10.0 * std::cos(angle), 60.0 + 10.0 * std::sin(angle), 68.0, 2));
  }
  follower.flush();
  EXPECT_NEAR(removed(), std::numbers::pi * (13.0 * 13.0 - 7.0 * 7.0) * 2.0, 12.0);
  EXPECT_THAT(follower.workpieces().front()->report().findings(), IsEmpty());
}

}  // namespace
}  // namespace stanok::simulation
