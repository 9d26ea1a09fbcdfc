// Positions of the rotary axes for a direction of the tool, against the forward map: where the tips
// of two tools of different length stand in B, the tool points.
#include "kinematics/tool_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/kinematics/test_machines.h"

namespace stanok::kinematics {
namespace {

constexpr double rad_of_direction = std::numbers::pi / 180.0;
constexpr double direction_tolerance = 1e-9;

using Vector = Vector3<double>;

// Of the tilted plane with the Euler angles I and J: the normal, as the third turn leaves it.
Vector normal_of(double i_deg, double j_deg) {
  return {std::sin(j_deg * rad_of_direction) * std::sin(i_deg * rad_of_direction),
          -std::sin(j_deg * rad_of_direction) * std::cos(i_deg * rad_of_direction),
          std::cos(j_deg * rad_of_direction)};
}

double angle_between(const Vector& a, const Vector& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Where the tool points in B with the rotary axes at `angles`: from the tip of a tool of 1 m to
// that of one without length.
Vector pointed_to(const Scheme& scheme, const std::array<AxisIndex, 2>& axes,
                  const std::array<double, 2>& angles) {
  AxisVector<double> axes_M{};
  for (std::size_t k = 0; k < 2; ++k) axes_M[axes[k]] = angles[k] + scheme.config().zero[axes[k]];
  AxisVector<double> nose{};
  AxisVector<double> tip{};
  scheme.forward(PointMode::tip, {}, axes_M, nose);
  scheme.forward(PointMode::tip, {{0.0, 0.0, -1000.0}}, axes_M, tip);
  return Vector{nose[0] - tip[0], nose[1] - tip[1], nose[2] - tip[2]} / 1000.0;
}

void expect_points(const Scheme& scheme, const DirectionSolution& solution, const Vector& wanted) {
  ASSERT_GE(solution.count, 1U);
  for (std::size_t k = 0; k < solution.count; ++k) {
    const DirectionBranch& branch = solution.branches[k];
    for (const double free : {0.0, 77.0}) {
      std::array<double, 2> angles = branch.angles_deg;
      for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_TRUE(std::isfinite(angles[i])) << "branch " << k;
        ASSERT_GT(angles[i], -180.0);
        ASSERT_LE(angles[i], 180.0);
        if (branch.is_free[i]) angles[i] = free;
      }
      const Vector pointed = pointed_to(scheme, solution.axes, angles);
      EXPECT_LT(angle_between(pointed, wanted), direction_tolerance)
          << "branch " << k << ": " << angles[0] << " " << angles[1];
    }
  }
}

bool has_chains_of_rotary_axes(const TestMachine& machine) {
  const std::string& type = machine.config.type;
  return type == "head_table" || type == "head_head" || type == "table_table";
}

std::vector<TestMachine> inclining_machines() {
  std::vector<TestMachine> machines = test_machines();
  std::erase_if(machines, std::not_fn(has_chains_of_rotary_axes));
  return machines;
}

class ToolDirection : public ::testing::TestWithParam<TestMachine> {
 protected:
  std::unique_ptr<const Scheme> scheme_ = GetParam().scheme();
};

TEST_P(ToolDirection, IsReachedByEveryBranchOfEveryOrientation) {
  int reached = 0;
  for (int i = 0; i < 360; i += 5) {
    for (int j = 0; j < 360; j += 5) {
      const Vector wanted = normal_of(i, j);
      const DirectionSolution solution = scheme_->directions(wanted);
      SCOPED_TRACE(::testing::Message() << "I" << i << " J" << j);
      if (solution.kind == DirectionSolution::Kind::reached) {
        ++reached;
        expect_points(*scheme_, solution, wanted);
        continue;
      }
      ASSERT_EQ(solution.kind, DirectionSolution::Kind::out_of_reach);
      EXPECT_GT(solution.off_deg, 0.0);
      EXPECT_NEAR(solution.nearest_B.norm(), 1.0, direction_tolerance);
      EXPECT_NEAR(angle_between(solution.nearest_B, wanted), solution.off_deg * rad_of_direction,
                  direction_tolerance);
      const DirectionSolution nearest = scheme_->directions(solution.nearest_B);
      ASSERT_EQ(nearest.kind, DirectionSolution::Kind::reached);
      expect_points(*scheme_, nearest, solution.nearest_B);
    }
  }
  RecordProperty("reached", reached);
  EXPECT_GT(reached, 0);
}

// At the poles and as near to them as numbers go.
TEST_P(ToolDirection, HasNoNumberThatIsNoneNearPoles) {
  const Vector pole = pointed_to(*scheme_, scheme_->directions({0, 0, 1}).axes, {0.0, 0.0});
  for (int power = -16; power < -2; ++power) {
    const double tilt = std::pow(10.0, power);
    for (int i = 0; i < 360; i += 15) {
      const Vector wanted = (pole + tilt * Vector(std::cos(i * rad_of_direction),
                                                  std::sin(i * rad_of_direction), 0.0))
                                .normalized();
      const DirectionSolution solution = scheme_->directions(wanted);
      SCOPED_TRACE(::testing::Message() << "tilt " << tilt << " at " << i);
      if (solution.kind == DirectionSolution::Kind::out_of_reach) {
        EXPECT_TRUE(std::isfinite(solution.off_deg) && solution.nearest_B.allFinite());
      } else {
        expect_points(*scheme_, solution, wanted);
      }
    }
  }
}

// Both angles of any position are among the branches of the direction to which they lead.
TEST_P(ToolDirection, FindsThePositionFromWhichItComes) {
  const auto axes = scheme_->directions({0.0, 0.0, 1.0}).axes;
  Poses poses(GetParam(), 20261123);
  for (int n = 0; n < 2000; ++n) {
    const std::array<double, 2> angles{poses.between(-180.0, 180.0), poses.between(-180.0, 180.0)};
    const DirectionSolution solution = scheme_->directions(pointed_to(*scheme_, axes, angles));
    ASSERT_EQ(solution.kind, DirectionSolution::Kind::reached);
    double nearest = 360.0;
    for (std::size_t k = 0; k < solution.count; ++k) {
      double way = 0.0;
      for (std::size_t i = 0; i < 2; ++i) {
        const double difference = solution.branches[k].angles_deg[i] - angles[i];
        way = std::max(way, std::abs(std::remainder(difference, 360.0)));
      }
      nearest = std::min(nearest, way);
    }
    EXPECT_LT(nearest, 1e-4) << angles[0] << " " << angles[1];
  }
}

// No direction of a grid over both angles comes nearer to one that is out of reach.
TEST_P(ToolDirection, KnowsTheNearestOneThatIsReached) {
  const auto axes = scheme_->directions({0.0, 0.0, 1.0}).axes;
  for (int i = 0; i < 360; i += 45) {
    for (int j = 0; j < 360; j += 15) {
      const DirectionSolution solution = scheme_->directions(normal_of(i, j));
      if (solution.kind != DirectionSolution::Kind::out_of_reach) continue;
      for (int a = 0; a < 360; a += 4) {
        for (int b = 0; b < 360; b += 4) {
          const Vector pointed = pointed_to(*scheme_, axes, {a * 1.0, b * 1.0});
          ASSERT_GT(angle_between(pointed, normal_of(i, j)),
                    solution.off_deg * rad_of_direction - direction_tolerance);
        }
      }
    }
  }
}

TEST_P(ToolDirection, IsThatOfTheSpindleAxes) {
  const auto axes = scheme_->directions({0.0, 0.0, 1.0}).axes;
  Poses poses(GetParam(), 7);
  for (int n = 0; n < 200; ++n) {
    AxisVector<double> point_B{};
    for (const AxisIndex axis : axes) point_B[axis] = poses.between(-180.0, 180.0);
    const auto spindle = scheme_->spindle_axes(point_B);
    const Vector pointed = pointed_to(*scheme_, axes, {point_B[axes[0]], point_B[axes[1]]});
    EXPECT_LT(angle_between(spindle[2], pointed), direction_tolerance);
    EXPECT_LT((spindle[0].cross(spindle[1]) - spindle[2]).norm(), direction_tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Machines, ToolDirection, ::testing::ValuesIn(inclining_machines()),
                         [](const auto& info) { return info.param.name; });

TEST(ToolDirectionOfTypes, ThreeTypesInclineTheToolAndTheOthersSaySo) {
  for (const TestMachine& machine : test_machines()) {
    const bool inclines = has_chains_of_rotary_axes(machine);
    const DirectionSolution solution = machine.scheme()->directions({0.0, 0.6, 0.8});
    EXPECT_EQ(solution.kind != DirectionSolution::Kind::no_rotary_axes, inclines) << machine.name;
  }
}

TEST(ToolDirectionOfTypes, ParallelAxesAreNoPair) {
  const TestMachine machine{.name = "parallel",
                            .config = test_machine::head_table({0, 0, 1}, {0, 0, 1}),
                            .tip = reference::head_table,
                            .axes = reference::shifted};
  EXPECT_EQ(machine.scheme()->directions({0.0, 0.0, 1.0}).kind,
            DirectionSolution::Kind::no_rotary_axes);
}

// B tilts the head about Y, C turns the table about Z: upright, C does not matter; B20 leans the
// tool to +X, and B-20 does it with the table half round.
TEST(ToolDirectionOfTypes, OfHeadAndTableAreThoseOfTheDrawing) {
  const auto scheme = make_scheme(test_machine::head_table({0, 1, 0}, {0, 0, 1}));
  const DirectionSolution upright = scheme->directions({0.0, 0.0, 1.0});
  ASSERT_EQ(upright.count, 1U);
  EXPECT_EQ(upright.branches[0].is_free, (std::array{false, true}));
  EXPECT_NEAR(upright.branches[0].angles_deg[0], 0.0, 1e-12);
  const DirectionSolution leaning = scheme->directions(
      {std::sin(20.0 * rad_of_direction), 0.0, std::cos(20.0 * rad_of_direction)});
  ASSERT_EQ(leaning.count, 2U);
  for (const DirectionBranch& branch : leaning.branches) {
    const bool ahead = branch.angles_deg[0] > 0.0;
    EXPECT_NEAR(branch.angles_deg[0], ahead ? 20.0 : -20.0, 1e-12);
    EXPECT_NEAR(std::abs(branch.angles_deg[1]), ahead ? 0.0 : 180.0, 1e-12);
  }
}

}  // namespace
}  // namespace stanok::kinematics
