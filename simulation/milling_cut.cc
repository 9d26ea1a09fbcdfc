#include "simulation/milling_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/swept_section.h"

namespace stanok::simulation {
namespace {

constexpr int steps_max = 1'000'000;
constexpr double turn_share = 0.1;  // of the tolerance, for what counts as no turn

Bounds bounds_of_move(const Body& body, const ToolMove& move) {
  Bounds bounds = bounds_of(body, move.begin);
  bounds.low += move.way.cwiseMin(0.0);
  bounds.high += move.way.cwiseMax(0.0);
  return bounds;
}

// Calls visit(ray, from, to) for every ray with material that the body covers a stretch of, until
// it returns false.
template <class Visitor>
void visit_covered(const Material& material, const Body& body, const ToolMove& move, int axis,
                   const Bounds& bounds, Visitor&& visit) {
  const Grid& grid = material.grid();
  const RayFamily& family = material.family(axis);
  const RayWindow window = material.window(axis, bounds);
  const int first_axis = (axis + 1) % 3;
  const int second_axis = (axis + 2) % 3;
  const auto low = static_cast<float>(bounds.low[axis]);
  const auto high = static_cast<float>(bounds.high[axis]);
  const SweptSection section(body, move.begin, move.way, axis);
  for (int second = window.second_from; second < window.second_to; ++second) {
    const double v = grid.middle(second_axis, second);
    double u_from = 0.0;
    double u_to = 0.0;
    if (!section.row(v, u_from, u_to)) continue;
    const int first_from = std::max(window.first_from, grid.first_behind(first_axis, u_from));
    const int first_to = std::min(window.first_to, grid.first_behind(first_axis, u_to));
    for (int first = first_from; first < first_to; ++first) {
      const std::size_t ray = material.ray(axis, first, second);
      if (!family.may_meet(ray, low, high)) continue;
      double from = 0.0;
      double to = 0.0;
      if (!section.meet(grid.middle(first_axis, first), v, from, to)) continue;
      if (!visit(ray, from, to)) return;
    }
  }
}

// The longest step across the axis behind which a segment leaves no more than `tolerance` over what
// it sweeps. Between two circles of radius w that are d apart, w - √(w² - d²/4) stays, of which a
// flank that leans by λ has the part cos λ across it; where d is wider than the circles, d/2 stays.
double step_across(const ProfileSegment& segment, double tolerance) {
  if (segment.c2 < 0.0) return std::sqrt(8.0 * segment.sphere_radius() * tolerance);
  const double radius = std::min(segment.radius_at(segment.from), segment.radius_at(segment.to));
  const double gap = tolerance * std::sqrt(1.0 + segment.c2);  // c2 of a cone: tan² λ
  return gap >= radius ? 2.0 * gap : 2.0 * std::sqrt(gap * (2.0 * radius - gap));
}

double step_across(const Body& body, double tolerance) {
  double step = std::numeric_limits<double>::infinity();
  for (const ProfileSegment& segment : body.segments)
    step = std::min(step, step_across(segment, tolerance));
  return step;
}

double parts_of_way(double way, double step) {
  return step > 0.0 ? way / step : 0.0;
}

}  // namespace

double remove(Material& material, const Body& body, const ToolMove& move) {
  const Bounds bounds = bounds_of_move(body, move);
  if (!bounds.meets(material.bounds())) return 0.0;
  double volume = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double length = 0.0;
    visit_covered(material, body, move, axis, bounds, [&](std::size_t ray, double from, double to) {
      length += material.subtract(axis, ray, from, to);
      return true;
    });
    volume += length * material.section(axis);
  }
  return volume / 3.0;
}

double covered(const Material& material, const Body& body, const ToolMove& move) {
  if (body.segments.empty()) return 0.0;
  const Bounds bounds = bounds_of_move(body, move);
  if (!bounds.meets(material.bounds())) return 0.0;
  double volume = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double length = 0.0;
    const RayFamily& family = material.family(axis);
    visit_covered(material, body, move, axis, bounds, [&](std::size_t ray, double from, double to) {
      length += family.overlap(ray, from, to);
      return true;
    });
    volume += length * material.section(axis);
  }
  return volume / 3.0;
}

bool touches(const Material& material, const Body& body, const ToolPlace& place) {
  const ToolMove move{place};
  const Bounds bounds = bounds_of_move(body, move);
  if (!bounds.meets(material.bounds())) return false;
  bool met = false;
  for (int axis = 0; axis < 3 && !met; ++axis) {
    const RayFamily& family = material.family(axis);
    visit_covered(material, body, move, axis, bounds, [&](std::size_t ray, double from, double to) {
      met = family.overlap(ray, from, to) > 0.0;
      return !met;
    });
  }
  return met;
}

int steps_between(const ToolSolid& tool, const ToolPlace& from, const ToolPlace& to,
                  double tolerance) {
  if (tool.bodies.empty()) return 1;
  const Vector axis = (from.axis + to.axis).normalized();
  const double turn = (to.axis - from.axis).norm();
  const double longest_step = step_across(tool.bodies.front(), tolerance);
  double parts = 1.0;
  for (const double height : {0.0, tool.bodies.front().top()}) {
    const Vector way = to.at(height) - from.at(height);
    const double along = std::abs(way.dot(axis));
    const double across = std::sqrt(std::max(0.0, way.squaredNorm() - along * along));
    parts = std::max(parts, parts_of_way(across, longest_step));
    if (height > 0.0) continue;  // the edge is at the tip
    const double lift = along + tool.radius * turn;
    const double length = std::hypot(lift, across);
    if (length <= 0.0) continue;
    double edge_parts = lift * across / length / tolerance;
    if (tool.edge_radius > 0.0) {
      edge_parts =
          std::min(edge_parts, parts_of_way(length, std::sqrt(8.0 * tool.edge_radius * tolerance)));
    }
    parts = std::max(parts, edge_parts);
  }
  return static_cast<int>(std::ceil(std::min(parts, static_cast<double>(steps_max))));
}

std::vector<ToolMove> moves_between(const ToolSolid& tool, const ToolPlace& from,
                                    const ToolPlace& to, double tolerance) {
  if (tool.bodies.empty()) return {};
  std::vector<ToolMove> moves;
  const Vector way = to.tip - from.tip;
  if ((to.axis - from.axis).norm() * tool.bodies.back().top() <= turn_share * tolerance) {
    const double longest = 2.0 * std::max(tool.radius, tolerance);
    const double count = std::clamp(std::ceil(way.norm() / longest), 1.0, double{steps_max});
    for (int i = 0; i < count; ++i)
      moves.push_back({{from.tip + i / count * way, to.axis}, way / count});
    return moves;
  }
  const int steps = steps_between(tool, from, to, tolerance);
  for (int i = 1; i <= steps; ++i)
    moves.push_back({place_between(from, to, static_cast<double>(i) / steps)});
  return moves;
}

ToolPlace place_between(const ToolPlace& from, const ToolPlace& to, double part) {
  return {from.tip + part * (to.tip - from.tip),
          (from.axis + part * (to.axis - from.axis)).normalized()};
}

bool may_touch(const Material& material, const Body& body, const ToolPlace& from,
               const ToolPlace& to) {
  Bounds bounds = bounds_of(body, from);
  const Bounds there = bounds_of(body, to);
  // The axis turns on a chord of the circle: its ends stay within their distance.
  const Vector margin = Vector::Constant((to.axis - from.axis).squaredNorm() * body.top());
  bounds.low = bounds.low.cwiseMin(there.low) - margin;
  bounds.high = bounds.high.cwiseMax(there.high) + margin;
  return bounds.meets(material.bounds());
}

}  // namespace stanok::simulation
