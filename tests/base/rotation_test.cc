// Rotations: against the geometry of known turns, and their group properties over random axes.
#include "base/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stanok {
namespace {

using Vector = Vector3<double>;

TEST(Rotation, QuarterTurnsAreExact) {
  EXPECT_EQ(Rotation::about({0, 0, 2}, 90).turned(Vector{1, 0, 5}), (Vector{0, 1, 5}));
  EXPECT_EQ(Rotation::about({1, 0, 0}, 90).turned(Vector{5, 1, 0}), (Vector{5, 0, 1}));
  EXPECT_EQ(Rotation::about({0, 3, 0}, -90).turned(Vector{0, 5, 1}), (Vector{-1, 5, 0}));
  EXPECT_EQ(Rotation::about({0, 0, 1}, 540).turned(Vector{1, 2, 3}), (Vector{-1, -2, 3}));
}

TEST(Rotation, FullTurnIsTheIdentityAndLeavesBitsAlone) {
  EXPECT_TRUE(Rotation::about({0, 0, 1}, 360).is_identity());
  EXPECT_FALSE(Rotation::about({0, 0, 1}, 1e-9).is_identity());
  EXPECT_EQ(Rotation().turned(Vector{0.1, -0.0, 1e300}), (Vector{0.1, -0.0, 1e300}));
}

// A third of a turn about the space diagonal exchanges the axes: X to Y to Z.
TEST(Rotation, ThirdOfATurnAboutTheDiagonalPermutesTheAxes) {
  const Vector turned = Rotation::about({1, 1, 1}, 120).turned(Vector{1, 2, 3});
  EXPECT_NEAR(turned[0], 3.0, 1e-15);
  EXPECT_NEAR(turned[1], 1.0, 1e-15);
  EXPECT_NEAR(turned[2], 2.0, 1e-15);
}

// Rows times the vector, summed up from X to Z: the order is part of the setpoints (ADR 0020).
TEST(Rotation, SumsUpFromXToZInBothDirections) {
  constexpr unsigned seed = 20261123;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> any(-300.0, 300.0);
  for (int i = 0; i < 10'000; ++i) {
    const Vector v{any(engine), any(engine), any(engine)};
    const Rotation rotation = Rotation::about({any(engine), any(engine), any(engine)}, any(engine));
    const auto& [x, y, z] = rotation.rows();
    const auto sum = [&](double a, double b, double c) {
      return a * v.x() + b * v.y() + c * v.z();
    };
    ASSERT_EQ(rotation.turned(v),
              Vector(sum(x[0], x[1], x[2]), sum(y[0], y[1], y[2]), sum(z[0], z[1], z[2])))
        << "seed " << seed;
    ASSERT_EQ(rotation.turned_back(v),
              Vector(sum(x[0], y[0], z[0]), sum(x[1], y[1], z[1]), sum(x[2], y[2], z[2])));
  }
}

TEST(Rotation, TurnAboutZLeavesZAlone) {
  constexpr double z = 0.1 + 0.2;
  for (const double angle_deg : {1e-3, 33.3, 120.0, -271.5}) {
    const Rotation rotation = Rotation::about({0, 0, 7}, angle_deg);
    EXPECT_EQ(rotation.turned(Vector{1.0, 2.0, z}).z(), z);
    EXPECT_EQ(rotation.turned_back(Vector{1.0, 2.0, z}).z(), z);
  }
}

// What crosses into the cycle by value is plain data.
static_assert(std::is_trivially_copyable_v<Rotation>);

TEST(Rotation, KeepsLengthsItsAxisAndComesBack) {
  constexpr unsigned seed = 20240617;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> any(-10.0, 10.0);
  for (int i = 0; i < 10'000; ++i) {
    const Vector axis{any(engine), any(engine), any(engine)};
    const Vector v{any(engine), any(engine), any(engine)};
    const double angle = 50.0 * any(engine);
    const Rotation rotation = Rotation::about(axis, angle);
    const Vector turned = rotation.turned(v);
    ASSERT_NEAR(dot(turned, turned), dot(v, v), 1e-11) << "seed " << seed;
    ASSERT_NEAR(dot(turned, axis), dot(v, axis), 1e-11);
    const Vector back = rotation.turned_back(turned);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(back[k], v[k], 1e-13);
    const Vector half_twice =
        (Rotation::about(axis, angle / 2) * Rotation::about(axis, angle / 2)).turned(v);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(half_twice[k], turned[k], 1e-12);
  }
}

}  // namespace
}  // namespace stanok
