// Parts whose volume and surface are known from formulas, and the motions that cut them.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "simulation/workpiece.h"

namespace stanok::simulation::testing {

inline constexpr double pi = std::numbers::pi;

struct AnalyticPart {
  std::string name;
  Blank blank;  // its resolution is set by the test
  std::function<void(Workpiece&)> cut;
  double removed_mm3 = 0.0;
  // Distances of a point in K to the faces, as they would go on.
  std::vector<std::function<double(const Vector&)>> faces;

  [[nodiscard]] double distance(const Vector& point) const {
    double nearest = distance_to_surface(blank, point);
    for (const auto& face : faces) nearest = std::min(nearest, std::abs(face(point)));
    return nearest;
  }
};

inline Blank box(double x, double y, double z) {
  Blank blank;
  blank.size = {x, y, z};
  return blank;
}

inline Blank bar(double diameter, double inner, double length) {
  Blank blank;
  blank.kind = BlankKind::cylinder;
  blank.size = {diameter, inner, length};
  return blank;
}

inline ToolShape rotating(ToolKind kind, double radius) {
  ToolShape tool;
  tool.kind = kind;
  tool.radius = radius;
  tool.flute_length = 60.0;
  return tool;
}

inline Circumstances at_feed(std::uint64_t block) {
  Circumstances circumstances;
  circumstances.shares = {{Origin{1, 1, block, static_cast<std::uint32_t>(block), 0}, 1.0}};
  return circumstances;
}

// The tip from point to point, the axis as given.
inline void mill_along(Workpiece& workpiece, const ToolShape& shape, const Vector& axis,
                       const std::vector<Vector>& tips) {
  const MillingTool tool = workpiece.milling_tool(shape);
  for (std::size_t i = 1; i < tips.size(); ++i)
    workpiece.mill(tool, {tips[i - 1], axis}, {tips[i], axis}, at_feed(i));
}

inline void turn_along(Workpiece& workpiece, const ToolShape& shape,
                       const std::vector<PlanePoint>& tips) {
  const TurningTool tool = workpiece.turning_tool(shape, DirectionOfZ::same);
  for (std::size_t i = 1; i < tips.size(); ++i)
    workpiece.turn(tool, {}, tips[i - 1], tips[i], at_feed(i));
}

inline ToolShape right_hand_insert(double nose) {
  ToolShape tool;
  tool.kind = ToolKind::insert;
  tool.radius = nose;
  tool.orientation = 2;
  tool.flute_length = 40.0;
  return tool;
}

// 30 x 20 x 8 with the corners of a mill of 10.
inline AnalyticPart pocket() {
  AnalyticPart part{"box pocket", box(61.0, 41.3, 20.7), {}, 0.0, {}};
  const double floor = 20.7 - 8.0;
  part.cut = [floor](Workpiece& workpiece) {
    std::vector<Vector> tips{{20.1, 15.2, 30.0}, {20.1, 15.2, floor}};
    for (const auto& [x, y] : {std::pair{40.1, 15.2},
                               {40.1, 25.2},
                               {20.1, 25.2},
                               {20.1, 15.2},
                               {20.1, 20.2},
                               {40.1, 20.2}})
      tips.emplace_back(x, y, floor);
    mill_along(workpiece, rotating(ToolKind::flat, 5.0), Vector::UnitZ(), tips);
  };
  part.removed_mm3 = (30.0 * 20.0 - (4.0 - pi) * 25.0) * 8.0;
  part.faces = {[floor](const Vector& p) { return p.z() - floor; },
                [](const Vector& p) {
                  // A rounded rectangle is a rectangle of tool centres, thickened by 5.
                  const double x = std::abs(p.x() - 30.1) - 10.0;
                  const double y = std::abs(p.y() - 20.2) - 5.0;
                  const double outside = std::hypot(std::max(x, 0.0), std::max(y, 0.0));
                  return outside + std::min(std::max(x, y), 0.0) - 5.0;
                }};
  return part;
}

// Radius 10, height 6, in a ring that a mill of 10 leaves round it.
inline AnalyticPart boss() {
  AnalyticPart part{"cylinder boss", box(50.3, 50.3, 15.1), {}, 0.0, {}};
  const Vector centre(25.2, 25.1, 0.0);
  const double floor = 15.1 - 6.0;
  part.cut = [=](Workpiece& workpiece) {
    std::vector<Vector> tips{centre + Vector(15.0, 0.0, 20.0)};
    constexpr int chords = 720;
    for (int i = 0; i <= chords; ++i) {
      const double angle = 2.0 * pi * i / chords;
      tips.push_back(centre + Vector(15.0 * std::cos(angle), 15.0 * std::sin(angle), floor));
    }
    mill_along(workpiece, rotating(ToolKind::flat, 5.0), Vector::UnitZ(), tips);
  };
  part.removed_mm3 = pi * (20.0 * 20.0 - 10.0 * 10.0) * 6.0;
  const auto radius = [=](const Vector& p) { return std::hypot(p.x() - 25.2, p.y() - 25.1); };
  part.faces = {[floor](const Vector& p) { return p.z() - floor; },
                [radius](const Vector& p) { return radius(p) - 10.0; },
                [radius](const Vector& p) { return radius(p) - 20.0; }};
  return part;
}

// 30 long, 2 deep, with a ball mill of 6.
inline AnalyticPart groove() {
  AnalyticPart part{"ball-mill groove", box(50.3, 20.2, 10.4), {}, 0.0, {}};
  const Vector from(10.1, 10.15, 8.4);
  const Vector to(40.1, 10.15, 8.4);
  part.cut = [=](Workpiece& workpiece) {
    mill_along(workpiece, rotating(ToolKind::ball, 3.0), Vector::UnitZ(),
               {from + Vector(0.0, 0.0, 10.0), from, to});
  };
  const double r = 3.0;
  const double depth = 2.0;
  const double segment =
      r * r * std::acos((r - depth) / r) - (r - depth) * std::sqrt(2.0 * r * depth - depth * depth);
  part.removed_mm3 = 30.0 * segment + pi * depth * depth * (3.0 * r - depth) / 3.0;
  part.faces = {[=](const Vector& p) {
    const double x = std::clamp(p.x(), from.x(), to.x());
    return (p - Vector(x, from.y(), from.z() + r)).norm() - r;
  }};
  return part;
}

// 30 long along X, with a mill that stands upright; q is the distance from the way of its axis. The
// cross-section without the ends, and the two half tools at the ends as one.
struct StraightGroove {
  double area_mm2 = 0.0;
  double ends_mm3 = 0.0;
  std::vector<std::function<double(double q, double above_floor)>> faces;
};

inline AnalyticPart groove_of(std::string name, const ToolShape& tool, double depth,
                              const StraightGroove& shape) {
  AnalyticPart part{std::move(name), box(50.3, 20.2, 10.4), {}, 0.0, {}};
  const Vector from(10.1, 10.15, 10.4 - depth);
  const Vector to = from + Vector(30.0, 0.0, 0.0);
  part.cut = [=](Workpiece& workpiece) {
    mill_along(workpiece, tool, Vector::UnitZ(), {from + Vector(0.0, 0.0, 10.0), from, to});
  };
  part.removed_mm3 = 30.0 * shape.area_mm2 + shape.ends_mm3;
  for (const auto& face : shape.faces) {
    part.faces.emplace_back([=](const Vector& p) {
      const double x = std::clamp(p.x(), from.x(), to.x());
      return face(std::hypot(p.x() - x, p.y() - from.y()), p.z() - from.z());
    });
  }
  return part;
}

// 3 deep, with a mill of 8 whose corners are rounded by 1.5.
inline AnalyticPart bull_nose_groove() {
  const double r = 4.0;
  const double c = 1.5;
  const double depth = 3.0;
  ToolShape tool = rotating(ToolKind::bull, r);
  tool.corner_radius = c;
  StraightGroove shape;
  shape.area_mm2 = 2.0 * ((r - c) * depth + pi * c * c / 4.0 + c * (depth - c));
  const double flat = r - c;
  shape.ends_mm3 = pi * (flat * flat * c + flat * pi * c * c / 2.0 + 2.0 * c * c * c / 3.0) +
                   pi * r * r * (depth - c);
  shape.faces = {[](double, double a) { return a; }, [=](double q, double) { return q - r; },
                 [=](double q, double a) { return std::hypot(q - flat, a - c) - c; }};
  return groove_of("bull-nose groove", tool, depth, shape);
}

// 4 deep, with an engraver of 2 at its tip and flanks of 15 deg.
inline AnalyticPart tapered_groove() {
  const double r = 1.0;
  const double depth = 4.0;
  const double lean = 15.0 * pi / 180.0;
  const double slope = std::tan(lean);
  ToolShape tool = rotating(ToolKind::taper, r);
  tool.taper_angle = 15.0;
  StraightGroove shape;
  shape.area_mm2 = 2.0 * (r * depth + depth * depth * slope / 2.0);
  const double top = r + depth * slope;
  shape.ends_mm3 = pi / (3.0 * slope) * (top * top * top - r * r * r);
  shape.faces = {[](double, double a) { return a; },
                 [=](double q, double a) { return (q - r - a * slope) * std::cos(lean); }};
  return groove_of("tapered groove", tool, depth, shape);
}

// 2 deep, with a countersink of 90 deg that is led along.
inline AnalyticPart vee_groove() {
  const double depth = 2.0;
  ToolShape tool = rotating(ToolKind::drill, 4.0);
  tool.point_angle = 90.0;
  StraightGroove shape;
  shape.area_mm2 = depth * depth;
  shape.ends_mm3 = pi * depth * depth * depth / 3.0;
  shape.faces = {[](double q, double a) { return (q - a) / std::numbers::sqrt2; }};
  return groove_of("vee groove", tool, depth, shape);
}

// 118 deg, diameter 8, 12 deep to the shoulder of the point.
inline AnalyticPart hole() {
  AnalyticPart part{"drilled hole", box(25.3, 25.1, 20.2), {}, 0.0, {}};
  const double point = 4.0 / std::tan(59.0 * pi / 180.0);
  const Vector tip(12.6, 12.4, 20.2 - 12.0 - point);
  part.cut = [=](Workpiece& workpiece) {
    mill_along(workpiece, rotating(ToolKind::drill, 4.0), Vector::UnitZ(),
               {tip + Vector(0.0, 0.0, 30.0), tip});
  };
  part.removed_mm3 = pi * 16.0 * 12.0 + pi * 16.0 * point / 3.0;
  const auto radius = [=](const Vector& p) { return std::hypot(p.x() - tip.x(), p.y() - tip.y()); };
  part.faces = {[=](const Vector& p) { return radius(p) - 4.0; },
                [=](const Vector& p) {
                  const double along = radius(p) / std::tan(59.0 * pi / 180.0);
                  return (p.z() - tip.z() - along) * std::sin(59.0 * pi / 180.0);
                }};
  return part;
}

// From a bar of 40: diameter 24 over the first 30 mm, with the nose of 0.8 in the corner.
inline AnalyticPart stepped_shaft() {
  AnalyticPart part{"turned stepped shaft", bar(40.0, 0.0, 60.1), {}, 0.0, {}};
  const double shoulder = 30.1;
  const double nose = 0.8;
  part.cut = [=](Workpiece& workpiece) {
    std::vector<PlanePoint> tips;
    for (double x = 18.0; x >= 12.0; x -= 2.0) {
      tips.push_back({62.0, x});
      tips.push_back({shoulder, x});
      tips.push_back({shoulder, 21.0});
      tips.push_back({62.0, 21.0});
    }
    turn_along(workpiece, right_hand_insert(nose), tips);
  };
  // Pappus: the corner that the nose leaves is a square less a quarter of a circle; its moment
  // about the axis is that of the square less that of the quarter.
  const double square = nose * nose * (12.0 + nose / 2.0);
  const double quarter = pi / 4.0 * nose * nose * (12.0 + nose - 4.0 * nose / (3.0 * pi));
  part.removed_mm3 =
      pi * (20.0 * 20.0 - 12.0 * 12.0) * (60.1 - shoulder) - 2.0 * pi * (square - quarter);
  part.faces = {
      [](const Vector& p) { return std::hypot(p.x(), p.y()) - 12.0; },
      [=](const Vector& p) { return p.z() - shoulder; },
      [=](const Vector& p) {
        return std::hypot(p.z() - shoulder - nose, std::hypot(p.x(), p.y()) - 12.0 - nose) - nose;
      }};
  return part;
}

// A tube of 40 by 16: bored to 24 over the first 20 mm, with the nose of 0.8 in the corner.
inline AnalyticPart bored_tube() {
  AnalyticPart part{"bored tube", bar(40.0, 16.0, 40.3), {}, 0.0, {}};
  const double shoulder = 20.3;
  const double nose = 0.8;
  ToolShape bar_tool = right_hand_insert(nose);
  bar_tool.orientation = 3;     // cuts towards -Z and outwards
  bar_tool.flute_length = 6.0;  // does not reach the other side of the bore
  part.cut = [=](Workpiece& workpiece) {
    std::vector<PlanePoint> tips;
    for (const double x : {10.0, 12.0}) {
      tips.push_back({42.0, x});
      tips.push_back({shoulder, x});
      tips.push_back({shoulder, 6.0});
      tips.push_back({42.0, 6.0});
    }
    turn_along(workpiece, bar_tool, tips);
  };
  // Pappus, as for the shaft; the corner lies within the radius of 12.
  const double square = nose * nose * (12.0 - nose / 2.0);
  const double quarter = pi / 4.0 * nose * nose * (12.0 - nose + 4.0 * nose / (3.0 * pi));
  part.removed_mm3 =
      pi * (12.0 * 12.0 - 8.0 * 8.0) * (40.3 - shoulder) - 2.0 * pi * (square - quarter);
  part.faces = {
      [](const Vector& p) { return std::hypot(p.x(), p.y()) - 12.0; },
      [=](const Vector& p) { return p.z() - shoulder; },
      [=](const Vector& p) {
        return std::hypot(p.z() - shoulder - nose, std::hypot(p.x(), p.y()) - 12.0 + nose) - nose;
      }};
  return part;
}

// From radius 8 at the face to 20, 24 mm behind it.
inline AnalyticPart turned_cone() {
  AnalyticPart part{"turned cone", bar(40.0, 0.0, 50.2), {}, 0.0, {}};
  part.cut = [](Workpiece& workpiece) {
    // Behind the end of the cone it goes on in its direction, to leave the bar whole.
    std::vector<PlanePoint> tips;
    for (double lift = 12.0; lift >= 0.0; lift -= 3.0) {
      tips.push_back({54.2, 6.0 + lift});
      tips.push_back({24.2, 21.0 + lift});
      tips.push_back({54.2, 21.0 + lift});
    }
    turn_along(workpiece, right_hand_insert(0.0), tips);
  };
  part.removed_mm3 = pi * 24.0 * (400.0 - (64.0 + 160.0 + 400.0) / 3.0);
  part.faces = {[](const Vector& p) {
    const double radius = 8.0 + (50.2 - p.z()) / 2.0;
    return (std::hypot(p.x(), p.y()) - radius) * 2.0 / std::sqrt(5.0);
  }};
  return part;
}

// A plane that leans by 25 deg over X, faced with the end of a mill that leans with it.
inline AnalyticPart leaning_plane() {
  AnalyticPart part{"5-axis swept plane", box(40.2, 30.3, 25.4), {}, 0.0, {}};
  const double lean = 25.0 * pi / 180.0;
  const Vector axis(std::sin(lean), 0.0, std::cos(lean));
  const Vector on_plane(0.0, 0.0, 23.4);
  const Vector down(std::cos(lean), 0.0, -std::sin(lean));
  part.cut = [=](Workpiece& workpiece) {
    std::vector<Vector> tips;
    for (int row = -1; row < 8; ++row) {
      const double y = row % 2 == 0 ? -8.0 : 38.0;
      const Vector start = on_plane + 6.0 * row * down;
      tips.push_back(start + Vector(0.0, y, 0.0));
      tips.push_back(start + Vector(0.0, 30.0 - y, 0.0));
    }
    mill_along(workpiece, rotating(ToolKind::flat, 5.0), axis, tips);
  };
  // Above the plane: z from 23.4 - x tan(lean) to 25.4.
  part.removed_mm3 = 30.3 * (2.0 * 40.2 + std::tan(lean) * 40.2 * 40.2 / 2.0);
  part.faces = {[=](const Vector& p) { return (p - on_plane).dot(axis); }};
  return part;
}

inline std::vector<AnalyticPart> analytic_parts() {
  return {pocket(),         boss(),        groove(),       bull_nose_groove(),
          tapered_groove(), vee_groove(),  hole(),         stepped_shaft(),
          bored_tube(),     turned_cone(), leaning_plane()};
}

}  // namespace stanok::simulation::testing
