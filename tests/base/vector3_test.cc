// Vectors of space: zero without values, and products in a fixed order.
#include "base/vector3.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace stanok {
namespace {

struct Place {
  Vector3<double> point{};
};

TEST(Vector3, IsZeroWithoutValues) {
  const Place place;
  EXPECT_EQ(place.point, Vector3<double>(0.0, 0.0, 0.0));
  EXPECT_EQ(Place{}.point, Vector3<double>(0.0, 0.0, 0.0));
}

TEST(Vector3, GoesToPlainNumbersAndBack) {
  const std::array<double, 3> numbers{0.1, -0.0, 1e300};
  EXPECT_EQ(components(vector3(numbers)), numbers);
  EXPECT_TRUE(std::signbit(components(vector3(numbers))[1]));
}

// |a x b|^2 + (a b)^2 = |a|^2 |b|^2 (Lagrange); the cross product is perpendicular to both.
TEST(Vector3, ProductsObeyLagrangesIdentity) {
  constexpr unsigned seed = 20261123;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> any(-10.0, 10.0);
  for (int i = 0; i < 10'000; ++i) {
    const Vector3<double> a{any(engine), any(engine), any(engine)};
    const Vector3<double> b{any(engine), any(engine), any(engine)};
    const Vector3<double> across = a.cross(b);
    ASSERT_NEAR(dot(across, across) + dot(a, b) * dot(a, b), dot(a, a) * dot(b, b), 1e-10)
        << "seed " << seed;
    ASSERT_NEAR(dot(across, a), 0.0, 1e-11);
    ASSERT_NEAR(dot(across, b), 0.0, 1e-11);
  }
}

// 1 is lost beside 1e16 when it is added first, and is not when the great ones cancel first.
TEST(Vector3, DotSumsUpFromXToZ) {
  const Vector3<double> ones{1.0, 1.0, 1.0};
  EXPECT_EQ(dot(ones, Vector3<double>{1e16, -1e16, 1.0}), 1.0);
  EXPECT_EQ(dot(ones, Vector3<double>{1.0, 1e16, -1e16}), 0.0);
}

}  // namespace
}  // namespace stanok
