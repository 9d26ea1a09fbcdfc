#include "lang/pockets/pocket_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "lang/pockets/scan_lines.h"

namespace stanok::lang {
namespace {

// Corners of polygons and rounding; far above both, far below what counts on a machine.
constexpr double near_mm = 1e-2;

// Of a region; the search for ways from island to island goes with their square, a second or two.
constexpr std::size_t corners_max = 8'000;
constexpr double scan_lines_max = 10'000.0;

std::string text(const char* format, double first, double second, double third = 0.0) {
  std::array<char, 200> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, first, second, third);
  return buffer.data();
}

std::vector<ClosedLine> lines_of(const Region& region) {
  std::vector<ClosedLine> lines;
  for (const RegionPart& part : region)
    lines.insert(lines.end(), part.lines.begin(), part.lines.end());
  return lines;
}

std::vector<PlaneElement> elements_of(const PocketWish& wish) {
  std::vector<PlaneElement> elements;
  elements.reserve(wish.outline.size());
  for (const OutlineElement& one : wish.outline) elements.push_back(one.element);
  return elements;
}

// A wall of the pocket which the tool cannot touch anywhere: it is too wide for what leads there.
// Bridges to islands lie inside of the pocket and are no walls, but for their ends.
std::optional<std::uint32_t> line_of_untouched_wall(const PocketWish& wish, const Region& pocket,
                                                    const Region& middle) {
  const auto walls = lines_of(pocket);
  const auto reached = lines_of(middle);
  constexpr double parts = 32.0;
  for (const OutlineElement& one : wish.outline) {
    bool is_wall = false;
    bool is_touched = false;
    const double length = one.element.arc
                              ? norm(one.element.start - one.element.centre) * one.element.sweep
                              : norm(one.element.end - one.element.start);
    if (length < near_mm) continue;
    for (const PlanePoint& point : points_along(one.element, length / parts)) {
      if (nearest_point(walls, point).distance > near_mm) continue;
      is_wall = true;
      is_touched = is_touched || nearest_point(reached, point).distance < wish.radius_mm + near_mm;
    }
    if (is_wall && !is_touched) return one.line;
  }
  return std::nullopt;
}

std::optional<PocketFault> fault_of_regions(const PocketWish& wish, const Region& pocket,
                                            const Region& middle, const Region& rough) {
  if (pocket.empty()) {
    return PocketFault{"nothing is inside the outline",
                       "with G41 the outline runs counter-clockwise, with G42 clockwise", 0};
  }
  if (middle.empty()) {
    return PocketFault{
        text("a tool of radius %g mm does not fit into the pocket", wish.radius_mm, 0.0),
        "use a smaller tool", 0};
  }
  if (const auto line = line_of_untouched_wall(wish, pocket, middle)) {
    return PocketFault{
        text("a tool of radius %g mm cannot reach this part of the outline", wish.radius_mm, 0.0),
        "use a smaller tool, or a larger radius in the corner", *line};
  }
  if (rough.size() != 1) {
    const PlanePoint at = rough.size() > 1 ? rough.back().lines.front().front() : wish.start;
    return PocketFault{
        text(rough.empty() ? "a tool of radius %g mm does not fit when %g mm are left for finishing"
                           : "a tool of radius %g mm cannot pass a narrow place; the material at "
                             "%g, %g would remain",
             wish.radius_mm, rough.empty() ? wish.finish_mm : at.first, at.second),
        "use a smaller tool, leave less for finishing, or split the pocket", 0};
  }
  if (!contains(rough, wish.start)) {
    return PocketFault{
        text("the tool cannot plunge at %g, %g: it would touch the outline or an island",
             wish.start.first, wish.start.second),
        "choose a start point farther from the walls", 0};
  }
  return std::nullopt;
}

std::size_t corners_of(const Region& region) {
  std::size_t corners = 0;
  for (const ClosedLine& line : lines_of(region)) corners += line.size();
  return corners;
}

PocketFault too_fine() {
  return {"its walls have more than " + std::to_string(corners_max) +
              " corners, chords of arcs included",
          "split the pocket", 0};
}

// Around a closed line from a point on it, back to that point.
void go_around(const ClosedLine& line, const NearestPoint& from, PocketWay& way) {
  way.push_back(from.point);
  for (std::size_t k = 1; k <= line.size(); ++k) way.push_back(line[(from.edge + k) % line.size()]);
  way.push_back(from.point);
}

// The shortest way between two sets of closed lines. It begins or ends at a corner.
struct Bridge {
  NearestPoint from;
  NearestPoint to;
};

Bridge bridge_between(const std::vector<ClosedLine>& from, const ClosedLine& to) {
  Bridge best;
  best.from.distance = std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < to.size(); ++corner) {
    const NearestPoint near = nearest_point(from, to[corner]);
    if (near.distance < best.from.distance) best = {near, {near.distance, 0, corner, to[corner]}};
  }
  for (std::size_t line = 0; line < from.size(); ++line) {
    for (std::size_t corner = 0; corner < from[line].size(); ++corner) {
      const PlanePoint point = from[line][corner];
      const NearestPoint near = nearest_point({to}, point);
      if (near.distance < best.from.distance) best = {{near.distance, line, corner, point}, near};
    }
  }
  return best;
}

// From `start` to the nearest line and around it, then from line to line on the shortest way, which
// crosses none of the others. A bridge that begins elsewhere is a way of its own: its begin is cut.
std::vector<PocketWay> ways_around(const std::vector<ClosedLine>& lines, PlanePoint start) {
  std::vector<PocketWay> ways{{start}};
  NearestPoint entry = nearest_point(lines, start);
  std::size_t line = entry.line;
  std::vector<std::size_t> rest;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (k != line) rest.push_back(k);
  }
  std::vector<Bridge> bridges(lines.size());
  for (Bridge& bridge : bridges) bridge.from.distance = std::numeric_limits<double>::infinity();
  while (true) {
    go_around(lines[line], entry, ways.back());
    for (const std::size_t k : rest) {
      const Bridge bridge = bridge_between({lines[line]}, lines[k]);
      if (bridge.from.distance < bridges[k].from.distance) bridges[k] = bridge;
    }
    if (rest.empty()) return ways;
    const auto next =
        std::ranges::min_element(rest, {}, [&](std::size_t k) { return bridges[k].from.distance; });
    line = *next;
    rest.erase(next);
    entry = bridges[line].to;
    const PlanePoint begin = bridges[line].from.point;
    if (norm(ways.back().back() - begin) > same_point) ways.push_back({begin});
  }
}

// Each line of the finish from the nearest point of the lines that the rough passes left, and back.
std::vector<PocketWay> finishing_ways(const std::vector<ClosedLine>& finish,
                                      const std::vector<ClosedLine>& rough) {
  std::vector<PocketWay> ways;
  for (const ClosedLine& line : finish) {
    const Bridge bridge = bridge_between(rough, line);
    PocketWay& way = ways.emplace_back();
    way.push_back(bridge.from.point);
    go_around(line, bridge.to, way);
    way.push_back(bridge.from.point);
  }
  return ways;
}

// What no computer should be asked for, seen before anything of that size is made.
std::optional<PocketFault> excess_of(const PocketWish& wish) {
  const auto is_near = [](PlanePoint p) {
    return std::abs(p.first) <= pocket_reach_mm && std::abs(p.second) <= pocket_reach_mm;
  };
  double corners = 0.0;
  PlanePoint low = wish.start;
  PlanePoint high = wish.start;
  for (const auto& [element, line] : wish.outline) {
    if (!is_near(element.start) || !is_near(element.end) ||
        (element.arc && !is_near(element.centre)))
      return PocketFault{"it is more than 100 m away", "check the coordinates", line};
    const double radius = element.arc ? norm(element.start - element.centre) : 0.0;
    corners += element.arc ? element.sweep / std::sqrt(8.0 * chord_deviation_mm / radius) : 1.0;
    for (const PlanePoint point : {element.end, element.centre + PlanePoint{radius, radius},
                                   element.centre - PlanePoint{radius, radius}}) {
      if (!element.arc && norm(point - element.end) > 0.0) continue;
      low = {std::min(low.first, point.first), std::min(low.second, point.second)};
      high = {std::max(high.first, point.first), std::max(high.second, point.second)};
    }
  }
  if (!is_near(wish.start) || !(wish.radius_mm + wish.finish_mm <= pocket_reach_mm))
    return PocketFault{"it is more than 100 m away", "check the coordinates and the tool", 0};
  if (corners > corners_max) return too_fine();
  const PlanePoint size = high - low;
  const double across = wish.lines == ScanLines::along_first ? size.second : size.first;
  if (!(across / wish.step_mm <= scan_lines_max)) {
    return PocketFault{"its passes are too close together: more than " +
                           std::to_string(static_cast<int>(scan_lines_max)) + " would be needed",
                       "use a larger step between the passes, I or J", 0};
  }
  return std::nullopt;
}

}  // namespace

Expected<PocketPlan, PocketFault> plan_pocket(const PocketWish& wish) {
  if (auto fault = excess_of(wish)) return Unexpected(std::move(*fault));
  const Region pocket = region_inside(elements_of(wish));
  const Region middle = shrunk(pocket, wish.radius_mm);
  const Region rough =
      wish.finish_mm > 0.0 ? shrunk(pocket, wish.radius_mm + wish.finish_mm) : middle;
  for (const Region* const region : {&pocket, &middle, &rough}) {
    if (corners_of(*region) > corners_max) return Unexpected(too_fine());
  }
  if (auto fault = fault_of_regions(wish, pocket, middle, rough))
    return Unexpected(std::move(*fault));
  const std::vector<ClosedLine>& edges = rough.front().lines;
  PocketPlan plan;
  plan.level = ways_around(edges, wish.start);
  add_scan_lines(edges, wish.lines, wish.step_mm, plan.level);
  if (wish.finish_mm > 0.0) plan.finish = finishing_ways(lines_of(middle), edges);
  return plan;
}

}  // namespace stanok::lang
