// Which branch is taken for a direction of the tool, and what is said when none is.
#include "kinematics/direction_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/kinematics/test_machines.h"

namespace stanok::kinematics {
namespace {

using Outcome = DirectionChoice::Outcome;
using Vector = Vector3<double>;

constexpr double rad_of_choice = std::numbers::pi / 180.0;
constexpr int axis_B = 3;
constexpr int axis_C = 4;

std::unique_ptr<const Scheme> head_and_table() {
  return make_scheme(test_machine::head_table({0, 1, 0}, {0, 0, 1}));
}

// Tool leaning by `tilt` to the direction `towards` in the XY plane.
Vector leaning(double tilt_deg, double towards_deg) {
  return {std::sin(tilt_deg * rad_of_choice) * std::cos(towards_deg * rad_of_choice),
          std::sin(tilt_deg * rad_of_choice) * std::sin(towards_deg * rad_of_choice),
          std::cos(tilt_deg * rad_of_choice)};
}

DirectionWish wish_of(const Vector& tool, double from_b = 0.0, double from_c = 0.0) {
  DirectionWish wish;
  wish.tool_B = tool;
  wish.from_B[axis_B] = from_b;
  wish.from_B[axis_C] = from_c;
  return wish;
}

void expect_angles(const DirectionChoice& choice, double b, double c) {
  ASSERT_EQ(choice.outcome, Outcome::found);
  EXPECT_NEAR(choice.angles_deg[0], b, 1e-9);
  EXPECT_NEAR(choice.angles_deg[1], c, 1e-9);
}

// The table turns the workpiece: a tool that leans to +X at C0 leans to -Y of the workpiece at C90.
TEST(DirectionChoice, TakesTheNearestBranch) {
  const auto scheme = head_and_table();
  expect_angles(choose_direction(*scheme, wish_of(leaning(20, -60))), 20, 60);
  expect_angles(choose_direction(*scheme, wish_of(leaning(20, -60), -30, -100)), -20, -120);
  expect_angles(choose_direction(*scheme, wish_of(leaning(20, -60), 0, 340)), 20, 420);
}

TEST(DirectionChoice, TakesThePositiveFirstAngleOfTwoEquallyNear) {
  expect_angles(choose_direction(*head_and_table(), wish_of(leaning(20, -90))), 20, 90);
  expect_angles(choose_direction(*head_and_table(), wish_of(leaning(20, 90))), 20, -90);
}

TEST(DirectionChoice, ObeysTheSignOfTheFirstAxis) {
  DirectionWish wish = wish_of(leaning(20, -60));
  wish.first = FirstAngle::negative;
  expect_angles(choose_direction(*head_and_table(), wish), -20, -120);
  wish.from_B[axis_B] = -90.0;
  wish.first = FirstAngle::positive;
  expect_angles(choose_direction(*head_and_table(), wish), 20, 60);
}

TEST(DirectionChoice, LeavesTheFreeAngleOfAPoleWhereItIs) {
  expect_angles(choose_direction(*head_and_table(), wish_of({0, 0, 1}, 35, 123.5)), 0, 123.5);
}

TEST(DirectionChoice, TakesTheOtherBranchWhenALimitForbidsOne) {
  DirectionWish wish = wish_of(leaning(20, -60));
  wish.travel[axis_B] = {-100.0, 10.0};
  expect_angles(choose_direction(*head_and_table(), wish), -20, -120);
  wish = wish_of(leaning(20, -60));
  wish.travel[axis_C] = {-170.0, 50.0};
  expect_angles(choose_direction(*head_and_table(), wish), -20, -120);
}

TEST(DirectionChoice, AddsWholeTurnsOnlyWithinTheTravel) {
  DirectionWish wish = wish_of(leaning(20, -60), 0, 355);
  wish.travel[axis_C] = {-10.0, 400.0};
  wish.first = FirstAngle::positive;
  expect_angles(choose_direction(*head_and_table(), wish), 20, 60);
}

TEST(DirectionChoice, NamesTheAxisItsLimitAndTheNearestDirection) {
  DirectionWish wish = wish_of(leaning(50, 0));
  wish.travel[axis_B] = {-30.0, 40.0};
  const DirectionChoice choice = choose_direction(*head_and_table(), wish);
  ASSERT_EQ(choice.outcome, Outcome::beyond_limit);
  EXPECT_EQ(choice.axis, AxisIndex(axis_B));
  EXPECT_NEAR(choice.needed_deg, 50.0, 1e-9);
  EXPECT_NEAR(choice.limit_deg, 40.0, 1e-9);
  EXPECT_NEAR(choice.off_deg, 10.0, 1e-6);
  EXPECT_LT((choice.nearest_B - leaning(40, 0)).norm(), 1e-6);
}

TEST(DirectionChoice, SaysThatNoBranchHasTheSign) {
  DirectionWish wish = wish_of(leaning(0, 0));
  wish.first = FirstAngle::negative;
  expect_angles(choose_direction(*head_and_table(), wish), 0, 0);
  wish = wish_of(leaning(20, 0));
  wish.travel[axis_B] = {0.0, 100.0};
  wish.first = FirstAngle::negative;
  EXPECT_EQ(choose_direction(*head_and_table(), wish).outcome, Outcome::beyond_limit);
}

// An inclined inner axis reaches a cone only. A tool that lies level is out of it by what its
// normal misses: inner at 45 deg to the tool, outer upright, so the tool leans by up to 90 deg.
TEST(DirectionChoice, ReachesWhatTheGeometryAllows) {
  SchemeConfig config = test_machine::head_head();
  auto& geometry = std::get<HeadHead::Geometry>(config.geometry);
  const double half_root = std::sqrt(0.5);
  geometry.inner_vector = {0.0, half_root, half_root};
  const auto scheme = make_scheme(config);
  const DirectionChoice choice = choose_direction(*scheme, wish_of(leaning(100, 30)));
  ASSERT_EQ(choice.outcome, Outcome::out_of_reach);
  EXPECT_NEAR(choice.off_deg, 10.0, 1e-6);
  EXPECT_LT((choice.nearest_B - leaning(90, 30)).norm(), 1e-6);
  EXPECT_EQ(choose_direction(*scheme, wish_of(leaning(89, 30))).outcome, Outcome::found);
}

TEST(DirectionChoice, SaysThatASchemeHasNoRotaryAxes) {
  const auto scheme = make_scheme(test_machine::config_of("cartesian"));
  EXPECT_EQ(choose_direction(*scheme, wish_of({0, 0, 1})).outcome, Outcome::no_rotary_axes);
}

// Random limits and starts: what is found is within the limits and points as wanted; what is not
// found is not on a grid of angles within the limits either.
TEST(DirectionChoice, FindsADirectionWithinTheLimitsWheneverThereIsOne) {
  for (const TestMachine& machine : test_machines()) {
    const auto scheme = machine.scheme();
    const auto axes = scheme->directions({0.0, 0.0, 1.0}).axes;
    if (!axes[0].exists()) continue;
    Poses poses(machine, 3);
    for (int n = 0; n < 100; ++n) {
      DirectionWish wish = wish_of(leaning(poses.between(0, 180), poses.between(-180, 180)));
      for (const AxisIndex axis : axes) {
        const double low = poses.between(-200.0, 100.0);
        wish.travel[axis] = {low, low + poses.between(10.0, 200.0)};
        wish.from_B[axis] = poses.between(wish.travel[axis].min_deg, wish.travel[axis].max_deg);
      }
      const DirectionChoice choice = choose_direction(*scheme, wish);
      AxisVector<double> point_B{};
      for (std::size_t k = 0; k < 2; ++k) {
        const AngleTravel& travel = wish.travel[axes[k]];
        EXPECT_GE(choice.angles_deg[k], travel.min_deg);
        EXPECT_LE(choice.angles_deg[k], travel.max_deg);
        point_B[axes[k]] = choice.angles_deg[k];
      }
      const bool found = choice.outcome == Outcome::found;
      const Vector pointed = scheme->spindle_axes(point_B)[2];
      const double cosine = pointed.dot(wish.tool_B);
      if (found) {
        EXPECT_LT(pointed.cross(wish.tool_B).norm(), 1e-9) << machine.name;
        EXPECT_GT(cosine, 0.0);
        continue;
      }
      constexpr int steps = 40;
      for (int i = 0; i <= steps * steps; ++i) {
        const std::array parts{i / steps, i % steps};
        for (std::size_t k = 0; k < 2; ++k) {
          const AngleTravel& travel = wish.travel[axes[k]];
          const double width = travel.max_deg - travel.min_deg;
          point_B[axes[k]] = travel.min_deg + width * parts[k] / steps;
        }
        ASSERT_LT(scheme->spindle_axes(point_B)[2].dot(wish.tool_B), cosine + 1e-6)
            << machine.name << " " << n;
      }
    }
  }
}

}  // namespace
}  // namespace stanok::kinematics
