// The forms of a tilted plane against matrices that are multiplied by hand.
#include "lang/planes/tilted_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace stanok::lang {
namespace {

constexpr double plane_noise = 1e-12;

Eigen::Matrix3d turn(const Eigen::Vector3d& axis, double angle_deg) {
  return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180.0, axis).toRotationMatrix();
}

const Eigen::Vector3d along_x = Eigen::Vector3d::UnitX();
const Eigen::Vector3d along_y = Eigen::Vector3d::UnitY();
const Eigen::Vector3d along_z = Eigen::Vector3d::UnitZ();

void expect_rotation(const EulerAngles& angles, const Eigen::Matrix3d& expected) {
  const Rotation rotation = rotation_of(angles);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      EXPECT_NEAR(rotation.rows()[row][column],
                  expected(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)),
                  plane_noise);
    }
  }
}

TEST(TiltedPlane, IsTurnedAboutZThenTheNewXThenTheNewZ) {
  expect_rotation({30.0, 50.0, -20.0},
                  turn(along_z, 30.0) * turn(along_x, 50.0) * turn(along_z, -20.0));
  EXPECT_TRUE(rotation_of({}).is_identity());
}

TEST(TiltedPlane, GivesItsAnglesBackForEveryOrientation) {
  for (int i = -180; i < 180; i += 15) {
    for (int j = 0; j <= 180; j += 15) {
      for (int k = -180; k < 180; k += 45) {
        const Eigen::Matrix3d wanted = turn(along_z, i) * turn(along_x, j) * turn(along_z, k);
        expect_rotation(euler_angles(rotation_of({i * 1.0, j * 1.0, k * 1.0})), wanted);
      }
    }
  }
}

TEST(TiltedPlane, RollPitchAndYawAreAboutAxesThatStand) {
  const std::array<double, 3> angles{10.0, 20.0, 30.0};
  const Eigen::Matrix3d x = turn(along_x, 10.0);
  const Eigen::Matrix3d y = turn(along_y, 20.0);
  const Eigen::Matrix3d z = turn(along_z, 30.0);
  expect_rotation(*roll_pitch_yaw(angles, 123), z * y * x);
  expect_rotation(*roll_pitch_yaw(angles, 321), x * y * z);
  expect_rotation(*roll_pitch_yaw(angles, 231), x * z * y);
  for (const int wrong : {112, 124, 12, 333}) EXPECT_FALSE(roll_pitch_yaw(angles, wrong)) << wrong;
}

// A roof that falls by 45 deg to +X: from the ridge along Y, down the slope.
TEST(TiltedPlane, GoesThroughThreePoints) {
  const auto roof = through_points({Vector3<double>{10, 0, 20}, {10, 5, 20}, {0, 0, 30}});
  ASSERT_TRUE(roof);
  const double half_root = std::sqrt(0.5);
  Eigen::Matrix3d expected;
  expected.col(0) = along_y;
  expected.col(1) = Eigen::Vector3d(-half_root, 0.0, half_root);
  expected.col(2) = Eigen::Vector3d(half_root, 0.0, half_root);
  expect_rotation(*roof, expected);
  EXPECT_FALSE(through_points({Vector3<double>{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(through_points({Vector3<double>{1, 0, 0}, {1, 0, 0}, {2, 2, 2}}));
}

TEST(TiltedPlane, KeepsTheNormalOfTwoVectors) {
  Eigen::Matrix3d expected;
  expected.col(0) = along_y;
  expected.col(1) = along_z;
  expected.col(2) = along_x;
  expect_rotation(*along_vectors({0, 3, 0}, {5, 0, 0}), expected);
  expect_rotation(*along_vectors({0.05, 1, 0}, {1, 0, 0}), expected);
  EXPECT_FALSE(along_vectors({0.1, 1, 0}, {1, 0, 0}));
  EXPECT_FALSE(along_vectors({0, 0, 0}, {1, 0, 0}));
}

TEST(TiltedPlane, LiesInTwoProjectedLines) {
  expect_rotation(*projected({30.0, 0.0, 0.0}), turn(along_y, 30.0));
  expect_rotation(*projected({0.0, 40.0, 0.0}), turn(along_x, 40.0));
  const Eigen::Vector3d x = turn(along_y, 30.0) * along_x;
  const Eigen::Vector3d z = x.cross(turn(along_x, 40.0) * along_y).normalized();
  Eigen::Matrix3d expected;
  expected.col(0) = x;
  expected.col(1) = z.cross(x);
  expected.col(2) = z;
  expect_rotation(*projected({30.0, 40.0, 25.0}), expected * turn(along_z, 25.0));
  EXPECT_FALSE(projected({90.0, 90.0, 0.0}));
}

}  // namespace
}  // namespace stanok::lang
