// Two turns that lead one vector to another: see tool_direction.h.
//
// Between both turns the vector stands at p = R(inner, b) from = R(outer, -a) to: where the cone of
// `from` about `inner` meets that of `to` about `outer`. With the cosines c = axis . vector, the
// sines s = |axis x vector|, d = outer . inner and q = |outer x inner|,
//   p = c1 outer + s1 (cos(f) e + sin(f) (outer x e)),   cos(f) = (c2 - d c1) / (q s1)
// where e is the part of `inner` square to `outer`. The cone with the smaller s is the one that is
// written so: its radius is kept to the last bit, however near to the pole it is. Source: M.
// Murray, Z. Li, S. Sastry, A Mathematical Introduction to Robotic Manipulation (1994), 3.2, second
// subproblem.
#include "kinematics/tool_direction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/angle_units.h"

namespace stanok::kinematics {
namespace {

using Vector = Vector3<double>;

// Nearer to a pole than this (rad) the free angle is free; the tool is off by no more.
constexpr double pole_width = 1e-10;
constexpr double parallel_sine = 1e-6;  // of axes that are no pair
constexpr double same_branch = 1e-9;    // sin(f) below: both cones touch

// Where a vector stands about an axis.
struct Cone {
  Vector axis;
  Vector vector;
  double cosine = 0.0;
  double sine = 0.0;

  Cone(const Vector& about, const Vector& of) RT_SAFE : axis(about),
                                                        vector(of),
                                                        cosine(dot(about, of)),
                                                        sine(length_of(about.cross(of))) {}
  [[nodiscard]] static double length_of(const Vector& v) RT_SAFE {
    return std::hypot(v.x(), v.y(), v.z());
  }
  [[nodiscard]] double angle() const RT_SAFE { return std::atan2(sine, cosine); }
  [[nodiscard]] bool is_pole() const RT_SAFE { return sine < pole_width; }
};

// What a vector has square to an axis.
Vector square_to(const Vector& axis, const Vector& v) RT_SAFE {
  return v - axis * dot(axis, v);
}

// From `a` to `b` about `axis`, deg in (-180, 180]. Of what is square to the axis, which is small
// near a pole.
double turn_deg(const Vector& axis, const Vector& a, const Vector& b) RT_SAFE {
  const Vector before = square_to(axis, a);
  const Vector after = square_to(axis, b);
  const double sine = dot(axis, Vector(before.cross(after)));
  const double angle = deg_per_rad * std::atan2(sine, dot(before, after));
  return angle <= -180.0 ? 180.0 : angle;
}

// The unit vector square to `axis` in its plane with `towards`.
Vector square_part(const Vector& axis, const Vector& towards) RT_SAFE {
  const Vector part = square_to(axis, towards);
  return part / Cone::length_of(part);
}

struct Meeting {
  std::array<Vector, 2> points{};
  std::size_t count = 0;
};

// Of the cone `one` with another one whose cosine about `other_axis` is known.
Meeting points_of(const Cone& one, const Vector& other_axis, double other_cosine) RT_SAFE {
  const Vector centre = one.axis * one.cosine;
  if (one.is_pole()) return {{one.cosine < 0.0 ? Vector(-one.axis) : one.axis}, 1};
  const Vector e = square_part(one.axis, other_axis);
  const double q = Cone::length_of(one.axis.cross(other_axis));
  const double d = dot(one.axis, other_axis);
  const double cosine = std::clamp((other_cosine - d * one.cosine) / (q * one.sine), -1.0, 1.0);
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  const Vector across = one.axis.cross(e) * sine;
  if (sine < same_branch) return {{centre + e * (cosine * one.sine)}, 1};
  return {{centre + (e * cosine + across) * one.sine, centre + (e * cosine - across) * one.sine},
          2};
}

// The vector of `cone` led to another angle from its axis; square to it towards `spare` at a pole.
Vector inclined(const Cone& cone, double angle, const Vector& spare) RT_SAFE {
  const Vector side = square_part(cone.axis, cone.is_pole() ? spare : cone.vector);
  return cone.axis * std::cos(angle) + side * std::sin(angle);
}

}  // namespace

DirectionSolution solve(const TwoTurns& turns) RT_SAFE {
  DirectionSolution solution;
  const Cone outer(turns.outer, turns.to);
  const Cone inner(turns.inner, turns.from);
  const Cone axes(turns.outer, turns.inner);
  if (axes.sine < parallel_sine) return solution;
  const bool wants_to = turns.wanted == TwoTurns::Wanted::to;
  const Cone& wanted = wants_to ? outer : inner;
  const double given = (wants_to ? inner : outer).angle();
  const double between = axes.angle();
  const double lowest = std::abs(between - given);
  const double highest = std::min(between + given, 2.0 * std::numbers::pi - between - given);
  const double angle = wanted.angle();
  if (angle < lowest - pole_width || angle > highest + pole_width) {
    const double nearest = std::clamp(angle, lowest, highest);
    solution.kind = DirectionSolution::Kind::out_of_reach;
    solution.nearest_B = inclined(wanted, nearest, wants_to ? turns.inner : turns.outer);
    solution.off_deg = deg_per_rad * std::abs(angle - nearest);
    return solution;
  }
  solution.kind = DirectionSolution::Kind::reached;
  const Meeting meeting = outer.sine <= inner.sine ? points_of(outer, turns.inner, inner.cosine)
                                                   : points_of(inner, turns.outer, outer.cosine);
  solution.count = meeting.count;
  for (std::size_t k = 0; k < meeting.count; ++k) {
    const Vector& p = meeting.points[k];
    DirectionBranch& branch = solution.branches[k];
    branch.is_free = {outer.is_pole(), inner.is_pole()};
    if (!branch.is_free[0]) branch.angles_deg[0] = turn_deg(turns.outer, p, turns.to);
    if (!branch.is_free[1]) branch.angles_deg[1] = turn_deg(turns.inner, turns.from, p);
  }
  return solution;
}

}  // namespace stanok::kinematics
