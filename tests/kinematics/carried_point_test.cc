// Points of a table against rotation matrices about its drawn axes.
#include "kinematics/carried_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "tests/kinematics/test_machines.h"

namespace stanok::kinematics {
namespace {

using Point = Eigen::Vector3d;

Eigen::Matrix3d turn(const Vector3<double>& about, double angle_deg) {
  const Point axis(about.x(), about.y(), about.z());
  return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180.0, axis).toRotationMatrix();
}

Point place(const Vector3<double>& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Point linear(const AxisVector<double>& point) {
  return {point[0], point[1], point[2]};
}

// The point is where the tip of a head without turn stands: its place on the table is turned back
// by the angles of before, and turned by those of after.
Point expected(const SchemeConfig& config, const AxisVector<double>& from,
               const AxisVector<double>& to) {
  if (const auto* const trunnion = std::get_if<TableTable::Geometry>(&config.geometry)) {
    const Point centre = place(trunnion->table_centre);
    const Point between = place(trunnion->centre_to_centre);
    const Point tip = linear(from) + linear(config.zero) - centre;
    const Point on_rocker = turn(trunnion->outer_vector, from[3]).transpose() * tip - between;
    const Point on_plate = turn(trunnion->inner_vector, from[4]).transpose() * on_rocker;
    return turn(trunnion->outer_vector, to[3]) *
               (between + turn(trunnion->inner_vector, to[4]) * on_plate) +
           centre - linear(config.zero);
  }
  const auto& mixed = std::get<HeadTable::Geometry>(config.geometry);
  const Point upright =
      place(mixed.pivot_to_spindle) + linear(config.zero) - place(mixed.table_centre);
  return turn(mixed.table_vector, to[4] - from[4]) * (linear(from) + upright) - upright;
}

TEST(CarriedPoint, TurnsWithTheTableOfItsScheme) {
  std::mt19937 random(54);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int tables = 0;
  for (const TestMachine& machine : test_machines()) {
    if (machine.config.type != "table_table" && machine.config.type != "head_table") continue;
    ++tables;
    const auto scheme = machine.scheme();
    for (int n = 0; n < 300; ++n) {
      AxisVector<double> from{};
      AxisVector<double> to{};
      for (std::size_t k = 0; k < 5; ++k) {
        from[k] = (k < 3 ? 300.0 : 180.0) * part(random);
        to[k] = (k < 3 ? 300.0 : 180.0) * part(random);
      }
      const auto carried = carried_point(*scheme, from, to);
      ASSERT_TRUE(carried);
      EXPECT_LT((linear(*carried) - expected(machine.config, from, to)).norm(), 1e-9)
          << machine.name;
      EXPECT_EQ((*carried)[3], from[3]);
      EXPECT_EQ((*carried)[4], from[4]);
    }
  }
  EXPECT_EQ(tables, 3);
}

TEST(CarriedPoint, NeedsATable) {
  for (const TestMachine& machine : test_machines()) {
    if (machine.config.type == "table_table" || machine.config.type == "head_table") continue;
    EXPECT_FALSE(carried_point(*machine.scheme(), {}, {})) << machine.name;
  }
}

}  // namespace
}  // namespace stanok::kinematics
