#include "lang/pockets/pocket_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <polyclipping/clipper.hpp>

namespace stanok::lang {
namespace {

namespace clip = ClipperLib;

clip::IntPoint whole(PlanePoint p) {
  return {std::llround(p.first / clipper_step_mm), std::llround(p.second / clipper_step_mm)};
}

PlanePoint point_of(const clip::IntPoint& p) {
  return {clipper_step_mm * static_cast<double>(p.X), clipper_step_mm * static_cast<double>(p.Y)};
}

PlanePoint on_circle(PlanePoint centre, double radius, double angle) {
  return centre + radius * PlanePoint{std::cos(angle), std::sin(angle)};
}

// Of an arc without its first point. What lies to the left of the arc is taken: of one that turns
// counter-clockwise the inside, whose chords lie in it; of the other the outside, around which a
// polygon of tangents lies.
void append_arc(const PlaneElement& arc, clip::Path& path) {
  const PlanePoint from = arc.start - arc.centre;
  const double radius = norm(from);
  const double widest = 2.0 * std::acos(1.0 - std::min(chord_deviation_mm / radius, 0.5));
  const int steps = std::max(2, static_cast<int>(std::ceil(arc.sweep / widest)));
  const double step = (arc.counter_clockwise ? arc.sweep : -arc.sweep) / steps;
  const double begin = std::atan2(from.second, from.first);
  if (arc.counter_clockwise) {
    for (int k = 1; k < steps; ++k)
      path.push_back(whole(on_circle(arc.centre, radius, begin + k * step)));
  } else {
    const double outside = radius / std::cos(step / 2.0);
    for (int k = 0; k < steps; ++k)
      path.push_back(whole(on_circle(arc.centre, outside, begin + (k + 0.5) * step)));
  }
  path.push_back(whole(arc.end));
}

clip::Paths paths_of(const Region& region) {
  clip::Paths paths;
  for (const RegionPart& part : region) {
    for (const ClosedLine& line : part.lines) {
      clip::Path& path = paths.emplace_back();
      for (const PlanePoint& point : line) path.push_back(whole(point));
    }
  }
  return paths;
}

ClosedLine line_of(const clip::Path& path) {
  ClosedLine line;
  for (const clip::IntPoint& point : path) line.push_back(point_of(point));
  return line;
}

// An outer line, the islands in it, and what lies in these.
void add_part(const clip::PolyNode& outer, Region& region) {
  RegionPart part;
  part.lines.push_back(line_of(outer.Contour));
  for (const clip::PolyNode* const island : outer.Childs)
    part.lines.push_back(line_of(island->Contour));
  region.push_back(std::move(part));
  for (const clip::PolyNode* const island : outer.Childs) {
    for (const clip::PolyNode* const inner : island->Childs) add_part(*inner, region);
  }
}

Region region_of(const clip::PolyTree& tree) {
  Region region;
  for (const clip::PolyNode* const outer : tree.Childs) add_part(*outer, region);
  return region;
}

PlanePoint nearest_of_edge(PlanePoint a, PlanePoint b, PlanePoint to) {
  const PlanePoint way = b - a;
  const double length2 = dot(way, way);
  if (length2 <= 0.0) return a;
  return a + std::clamp(dot(to - a, way) / length2, 0.0, 1.0) * way;
}

}  // namespace

Region region_inside(const std::vector<PlaneElement>& outline) {
  clip::Path path;
  for (const PlaneElement& element : outline) {
    if (element.arc) {
      append_arc(element, path);
    } else {
      path.push_back(whole(element.end));
    }
  }
  clip::Clipper clipper;
  clipper.AddPath(path, clip::ptSubject, true);
  clip::PolyTree tree;
  clipper.Execute(clip::ctUnion, tree, clip::pftPositive, clip::pftPositive);
  return region_of(tree);
}

// Round corners of an offset are chords of circles about the corners of the line: farther away by
// twice what they may deviate, they take nothing.
Region shrunk(const Region& region, double distance_mm) {
  if (distance_mm <= 0.0) return region;
  constexpr double miter_limit = 2.0;
  constexpr double arc_deviation_mm = 5e-4;
  clip::ClipperOffset offset(miter_limit, arc_deviation_mm / clipper_step_mm);
  offset.AddPaths(paths_of(region), clip::jtRound, clip::etClosedPolygon);
  clip::PolyTree tree;
  offset.Execute(tree, -(distance_mm + 2.0 * arc_deviation_mm) / clipper_step_mm);
  return region_of(tree);
}

bool contains(const RegionPart& part, PlanePoint point) {
  bool inside = false;
  for (const ClosedLine& line : part.lines) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const PlanePoint& a = line[k];
      const PlanePoint& b = line[(k + 1) % line.size()];
      if ((a.second <= point.second) == (b.second <= point.second)) continue;
      const double part_of_edge = (point.second - a.second) / (b.second - a.second);
      if (point.first < a.first + part_of_edge * (b.first - a.first)) inside = !inside;
    }
  }
  return inside;
}

bool contains(const Region& region, PlanePoint point) {
  return std::ranges::any_of(region, [&](const RegionPart& part) { return contains(part, point); });
}

NearestPoint nearest_point(const std::vector<ClosedLine>& lines, PlanePoint to) {
  NearestPoint nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (std::size_t line = 0; line < lines.size(); ++line) {
    for (std::size_t edge = 0; edge < lines[line].size(); ++edge) {
      const PlanePoint a = lines[line][edge];
      const PlanePoint b = lines[line][(edge + 1) % lines[line].size()];
      const PlanePoint point = nearest_of_edge(a, b, to);
      const double distance = norm(to - point);
      if (distance < nearest.distance) nearest = {distance, line, edge, point};
    }
  }
  return nearest;
}

std::vector<PlanePoint> points_along(const PlaneElement& element, double step_mm) {
  const double radius = element.arc ? norm(element.start - element.centre) : 0.0;
  const double length = element.arc ? radius * element.sweep : norm(element.end - element.start);
  const int steps = std::max(2, static_cast<int>(std::ceil(length / step_mm)));
  std::vector<PlanePoint> points;
  const PlanePoint from = element.start - element.centre;
  const double begin = std::atan2(from.second, from.first);
  for (int k = 1; k < steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    const double turned = (element.counter_clockwise ? part : -part) * element.sweep;
    points.push_back(element.arc ? on_circle(element.centre, radius, begin + turned)
                                 : element.start + part * (element.end - element.start));
  }
  return points;
}

}  // namespace stanok::lang
