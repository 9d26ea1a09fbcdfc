// Properties every scheme has, and the transform W -> B -> M around it.
#include "kinematics/scheme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kinematics/test_machines.h"
#include "tests/support/no_allocation.h"

namespace stanok::kinematics {
namespace {

constexpr unsigned scheme_seed = 20031;

// The axis whose place in B holds a length in mm; -1: none.
int length_axis(const SchemeConfig& config) {
  return std::visit(
      [](const auto& geometry) {
        if constexpr (requires { geometry.rotary_axis; }) {
          return geometry.rotary_axis;
        } else {
          return -1;
        }
      },
      config.geometry);
}

class EveryScheme : public ::testing::TestWithParam<TestMachine> {};

TEST_P(EveryScheme, ForwardOfInverseIsThePointInBothModesWithToolAndFrame) {
  SCOPED_TRACE(::testing::Message() << "seed " << scheme_seed);
  const auto scheme = GetParam().scheme();
  ASSERT_NE(scheme, nullptr);
  Poses poses(GetParam(), scheme_seed);
  for (int i = 0; i < 100'000; ++i) {
    const AxisVector<double> point_W = poses.next();
    const Transform transform{.scheme = scheme.get(),
                              .frame = i % 3 == 0 ? Frame{} : poses.frame(),
                              .mode = i % 2 == 0 ? PointMode::tip : PointMode::axes,
                              .tool = i % 5 == 0 ? ToolVector{} : poses.tool()};
    AxisVector<double> axes_M{};
    AxisVector<double> back_W{};
    inverse(transform, point_W, axes_M);
    forward(transform, axes_M, back_W);
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      ASSERT_NEAR(back_W[axis], point_W[axis], 1e-9) << "axis " << axis << ", pose " << i;
    }
  }
}

TEST_P(EveryScheme, JetOfAConstantPointIsTheDoubleResultWithoutDerivatives) {
  const auto scheme = GetParam().scheme();
  Poses poses(GetParam(), scheme_seed);
  for (int i = 0; i < 10'000; ++i) {
    const AxisVector<double> point_B = poses.next();
    const PointMode mode = i % 2 == 0 ? PointMode::tip : PointMode::axes;
    const ToolVector tool = poses.tool();
    AxisVector<Jet> point_jet{};
    for (std::size_t axis = 0; axis < axes_max; ++axis) point_jet[axis] = point_B[axis];
    AxisVector<double> axes_M{};
    AxisVector<Jet> axes_jet{};
    scheme->inverse(mode, tool, point_B, axes_M);
    scheme->inverse(mode, tool, point_jet, axes_jet);
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      ASSERT_EQ(axes_jet[axis].value, axes_M[axis]) << "axis " << axis;
      ASSERT_EQ(axes_jet[axis].first, 0.0);
      ASSERT_EQ(axes_jet[axis].second, 0.0);
      ASSERT_EQ(axes_jet[axis].third, 0.0);
    }
  }
}

TEST_P(EveryScheme, ResultMayOverwriteTheArgument) {
  const auto scheme = GetParam().scheme();
  Poses poses(GetParam(), scheme_seed);
  for (int i = 0; i < 1000; ++i) {
    const AxisVector<double> point_B = poses.next();
    const ToolVector tool = poses.tool();
    AxisVector<double> axes_M{};
    scheme->inverse(PointMode::tip, tool, point_B, axes_M);
    AxisVector<double> in_place = point_B;
    scheme->inverse(PointMode::tip, tool, in_place, in_place);
    ASSERT_EQ(in_place, axes_M);
    AxisVector<double> back_B{};
    scheme->forward(PointMode::tip, tool, axes_M, back_B);
    scheme->forward(PointMode::tip, tool, in_place, in_place);
    ASSERT_EQ(in_place, back_B);
  }
}

TEST_P(EveryScheme, AxesThatDoNotTakePartPassThroughToTheBit) {
  const auto scheme = GetParam().scheme();
  AxisVector<double> point_B{1, 2, 3, 4, 5, 0.1, 33.3, -1e-300};
  AxisVector<double> axes_M{};
  for (const PointMode mode : {PointMode::axes, PointMode::tip}) {
    scheme->inverse(mode, ToolVector{{1, 2, -80}}, point_B, axes_M);
    for (std::size_t axis = 5; axis < axes_max; ++axis) EXPECT_EQ(axes_M[axis], point_B[axis]);
    EXPECT_TRUE(scheme->takes_part(4));
    EXPECT_FALSE(scheme->takes_part(5));
  }
}

TEST_P(EveryScheme, RotaryValuesAreKeptToTheBitWhenTheirZeroIsZero) {
  SchemeConfig config = GetParam().config;
  config.zero[3] = config.zero[4] = 0.0;
  const auto scheme = GetParam().make(config);
  const AxisVector<double> point_B{10, 20, 30, 33.3, 1e6 + 0.1};
  AxisVector<double> axes_M{};
  scheme->inverse(PointMode::tip, ToolVector{{0, 0, -80}}, point_B, axes_M);
  for (const std::size_t axis : {3U, 4U}) {
    if (static_cast<int>(axis) == length_axis(config)) continue;
    EXPECT_EQ(axes_M[axis], point_B[axis]);
  }
}

TEST_P(EveryScheme, PointModesAgreeAtZeroAnglesWithTheZeroThatFollowsFromTheGeometry) {
  SCOPED_TRACE(::testing::Message() << "seed " << scheme_seed);
  SchemeConfig config = GetParam().config;
  config.zero = zero_default(config);
  const auto scheme = GetParam().make(config);
  Poses poses(GetParam(), scheme_seed);
  for (int i = 0; i < 1000; ++i) {
    AxisVector<double> point_B = poses.next();
    point_B[3] = point_B[4] = 0.0;
    const ToolVector tool = poses.tool();
    AxisVector<double> tip{};
    AxisVector<double> axes{};
    scheme->inverse(PointMode::tip, tool, point_B, tip);
    scheme->inverse(PointMode::axes, tool, point_B, axes);
    for (std::size_t axis = 0; axis < axes_max; ++axis) ASSERT_NEAR(tip[axis], axes[axis], 1e-12);
  }
}

TEST_P(EveryScheme, AllocatesNothingInTheCycle) {
  const auto scheme = GetParam().scheme();
  const Transform transform{
      .scheme = scheme.get(), .frame = {}, .mode = PointMode::tip, .tool = {}};
  AxisVector<Jet> axes_jet{};
  AxisVector<double> axes_M{};
  const testing::NoAllocation guard;
  inverse(transform, AxisVector<Jet>{1.0, 2.0, 3.0, 4.0, 5.0}, axes_jet);
  inverse(transform, AxisVector<double>{}, axes_M);
  forward(transform, axes_M, axes_M);
  EXPECT_GE(scheme->distance_to_singularity(axes_M), 0.0);
  EXPECT_LT(scheme->winding_axes(), 1U << static_cast<unsigned>(axes_max));
}

INSTANTIATE_TEST_SUITE_P(TestMachines, EveryScheme, ::testing::ValuesIn(test_machines()),
                         [](const auto& machine) { return machine.param.name; });

TEST(Scheme, EveryTypeHasATestMachine) {
  for (const TypeOfScheme& type : scheme_types()) {
    EXPECT_TRUE(std::ranges::any_of(test_machines(), [&](const TestMachine& machine) {
      return machine.config.type == type.name;
    })) << type.name;
  }
}

TEST(Scheme, TypesOfAProgramCannotStandInAFile) {
  for (const TypeOfScheme& type : scheme_types()) {
    const bool is_of_a_program = type.name == "polar_face" || type.name == "cylinder";
    EXPECT_EQ(type.chosen_by == ChosenBy::program, is_of_a_program) << type.name;
  }
}

// Every kind of value goes to the geometry that listed the key, and to no other copy of it.
TEST(Scheme, KeysWriteToTheGeometryThatListedThem) {
  for (const TypeOfScheme& type : scheme_types()) {
    SchemeGeometry geometry = type.geometry;
    for (const SchemeKey& key : keys_of(geometry)) {
      EXPECT_FALSE(key.meaning.empty()) << key.name;
      if (const auto* axis = std::get_if<AxisName>(&key.value)) {
        EXPECT_EQ(axis->axis, -1) << key.name;
        axis->axis.get() = 4;
      }
    }
    for (const SchemeKey& key : keys_of(geometry)) {
      if (const auto* axis = std::get_if<AxisName>(&key.value)) {
        EXPECT_EQ(axis->axis, 4) << key.name;
      }
    }
  }
}

TEST(Scheme, ChoicesGoByTheOrderOfTheirNames) {
  SchemeGeometry geometry = Lathe::Geometry{};
  for (const SchemeKey& key : keys_of(geometry)) {
    const auto& choice = std::get<Choice>(key.value);
    EXPECT_EQ(choice.chosen, 0U);
    choice.choose(1);
  }
  EXPECT_EQ(std::get<Lathe::Geometry>(geometry).x_reading, XReading::diameter);
  EXPECT_EQ(std::get<Lathe::Geometry>(geometry).turret, Turret::front);
}

TEST(Scheme, GeometryOfAnotherTypeIsADefect) {
  SchemeConfig config;
  config.type = "lathe";
  config.axes = {0, 1};
  config.linear = {0, -1, 1};
  config.geometry = HeadTable::Geometry{};
  EXPECT_EQ(scheme_defect(config), "its geometry is that of another type");
  EXPECT_EQ(make_scheme(config), nullptr);
}

TEST(Scheme, UnknownTypeIsNoSchemeAndSaysSo) {
  SchemeConfig config;
  config.type = "hexapod";
  EXPECT_EQ(make_scheme(config), nullptr);
  EXPECT_EQ(scheme_defect(config), "unknown type 'hexapod'");
  EXPECT_EQ(zero_default(config), AxisVector<double>{});
}

TEST(Transform, IsTheIdentityWithoutScheme) {
  const Transform transform{.scheme = nullptr,
                            .frame = {.offset = {1, 2, 3},
                                      .rotation = Rotation::about({0, 0, 1}, 90),
                                      .geometry = {0, 1, 2}},
                            .mode = PointMode::tip,
                            .tool = {{0, 0, -80}}};
  const AxisVector<double> point{0.1, 0.2, 0.3, 33.3, -7, 1e9, 0, -1};
  AxisVector<double> result{};
  inverse(transform, point, result);
  EXPECT_EQ(result, point);
  forward(transform, point, result);
  EXPECT_EQ(result, point);
}

TEST(Transform, TurnsXyzThenAddsTheOffset) {
  SchemeConfig config;
  config.type = "cartesian";
  config.axes = {0, 1, 2};
  config.linear = {0, 1, 2};
  const auto scheme = make_scheme(config);
  // G68 by 30 deg in the plane Z, X (G18: Z towards X): unit vector of Z turns to (z, x) = (cos 30,
  // sin 30).
  Transform transform{.scheme = scheme.get(), .frame = {}, .mode = PointMode::axes, .tool = {}};
  transform.frame.offset = {100, 200, 300};
  transform.frame.rotation = Rotation::about({0, 1, 0}, 30);
  AxisVector<double> axes_M{};
  inverse(transform, AxisVector<double>{0, 5, 1}, axes_M);
  EXPECT_DOUBLE_EQ(axes_M[0], 100.5);
  EXPECT_DOUBLE_EQ(axes_M[1], 205.0);
  EXPECT_DOUBLE_EQ(axes_M[2], 300.0 + std::sqrt(3.0) / 2.0);
  AxisVector<Jet> axes_jet{};
  inverse(transform, AxisVector<Jet>{Jet(), Jet(), Jet(1, 2, 4, 8)}, axes_jet);
  EXPECT_DOUBLE_EQ(axes_jet[0].first, 1.0);
  EXPECT_DOUBLE_EQ(axes_jet[0].third, 4.0);
  EXPECT_DOUBLE_EQ(axes_jet[2].second, 4.0 * std::sqrt(3.0) / 2.0);
}

}  // namespace
}  // namespace stanok::kinematics
