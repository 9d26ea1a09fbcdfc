// Properties every scheme has, and the transform W -> B -> M around it.
#include "kinematics/scheme.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/no_allocation.h"

namespace stanok::kinematics {
namespace {

constexpr unsigned seed = 20031;

// Five axes X Y Z B C, complete for every type of scheme, with all constants different from zero.
SchemeConfig complete_config(const std::string& type) {
  SchemeConfig config;
  config.id = 1;
  config.type = type;
  config.axes = {0, 1, 2, 3, 4};
  config.zero = {12.5, -40.25, 7.75, 1.5, -30.0};
  config.linear = {0, 1, 2};
  config.head_axis = 3;
  config.table_axis = 4;
  config.pivot_to_spindle = {0.5, -0.25, -200.0};
  config.table_centre = {10.0, 20.0, -400.0};
  return config;
}

class Poses {
 public:
  AxisVector<double> next() {
    AxisVector<double> pose{};
    for (std::size_t axis = 0; axis < 3; ++axis) pose[axis] = millimetres_(engine_);
    for (std::size_t axis = 3; axis < axes_max; ++axis) pose[axis] = degrees_(engine_);
    return pose;
  }
  ToolVector tool() {
    return {{millimetres_(engine_) / 10.0, millimetres_(engine_) / 10.0, millimetres_(engine_)}};
  }
  Frame frame() {
    Frame frame;
    frame.offset = next();
    const std::array axis{millimetres_(engine_), millimetres_(engine_), millimetres_(engine_)};
    frame.rotation = Rotation::about(axis, degrees_(engine_));
    return frame;
  }

 private:
  std::mt19937 engine_{seed};
  std::uniform_real_distribution<double> millimetres_{-300.0, 300.0};
  std::uniform_real_distribution<double> degrees_{-400.0, 400.0};
};

class EveryScheme : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScheme, ForwardOfInverseIsThePointInBothModesWithToolAndFrame) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  const auto scheme = make_scheme(complete_config(GetParam()));
  ASSERT_NE(scheme, nullptr);
  Poses poses;
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
  const auto scheme = make_scheme(complete_config(GetParam()));
  Poses poses;
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
  const auto scheme = make_scheme(complete_config(GetParam()));
  Poses poses;
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
  const auto scheme = make_scheme(complete_config(GetParam()));
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
  SchemeConfig config = complete_config(GetParam());
  config.zero[3] = config.zero[4] = 0.0;
  const auto scheme = make_scheme(config);
  const AxisVector<double> point_B{10, 20, 30, 33.3, 1e6 + 0.1};
  AxisVector<double> axes_M{};
  scheme->inverse(PointMode::tip, ToolVector{{0, 0, -80}}, point_B, axes_M);
  EXPECT_EQ(axes_M[3], 33.3);
  EXPECT_EQ(axes_M[4], 1e6 + 0.1);
}

TEST_P(EveryScheme, AllocatesNothingInTheCycle) {
  const auto scheme = make_scheme(complete_config(GetParam()));
  const Transform transform{
      .scheme = scheme.get(), .frame = {}, .mode = PointMode::tip, .tool = {}};
  AxisVector<Jet> axes_M{};
  const testing::NoAllocation guard;
  inverse(transform, AxisVector<Jet>{}, axes_M);
}

INSTANTIATE_TEST_SUITE_P(Types, EveryScheme, ::testing::ValuesIn(scheme_types()),
                         [](const auto& type) { return type.param; });

TEST(Scheme, UnknownTypeIsNoSchemeAndSaysSo) {
  EXPECT_EQ(make_scheme(complete_config("hexapod")), nullptr);
  EXPECT_EQ(scheme_defect(complete_config("hexapod")), "unknown type 'hexapod'");
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
