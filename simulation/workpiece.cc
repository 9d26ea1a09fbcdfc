#include "simulation/workpiece.h"

#include <algorithm>
#include <cmath>

namespace stanok::simulation {
namespace {

// The finding that a contact makes; the cutting part may touch at feed.
FindingKind kind_of(Part part) {
  switch (part) {
    case Part::cutting:
      return FindingKind::rapid;
    case Part::shank:
      return FindingKind::shank;
    case Part::holder:
      break;
  }
  return FindingKind::holder;
}

}  // namespace

Workpiece::Workpiece(const Blank& blank, const Grid& grid)
    : blank_(blank), material_(blank, grid), report_(grid.cell.prod()) {}

MillingTool Workpiece::milling_tool(const ToolShape& shape) const {
  const double rounding = rounding_deviation * blank_.resolution;
  return {solid_of(shape, rounding), solid_of(shape, rounding, core_depth * blank_.resolution)};
}

TurningTool Workpiece::turning_tool(const ToolShape& shape, DirectionOfZ direction) const {
  TurningTool tool{insert_of(shape), insert_of(shape, core_depth * blank_.resolution)};
  if (direction == DirectionOfZ::same) return tool;
  for (Polygon* polygon : {&tool.insert, &tool.core}) {
    for (PlanePoint& point : *polygon) point.z = -point.z;
    std::ranges::reverse(*polygon);
  }
  return tool;
}

void Workpiece::mill(const MillingTool& tool, const ToolPlace& from, const ToolPlace& to,
                     const Circumstances& circumstances) {
  const bool touches = std::ranges::any_of(
      tool.solid.bodies, [&](const Body& body) { return may_touch(material_, body, from, to); });
  if (!touches) return;
  if (CutMarks* marks = material_.marks()) marks->set_tool(circumstances.tool);
  for (const ToolMove& move : moves_between(tool.solid, from, to, deviation()))
    mill_along(tool, move, circumstances);
}

void Workpiece::mill_along(const MillingTool& tool, const ToolMove& move,
                           const Circumstances& circumstances) {
  double removed = 0.0;
  for (std::size_t i = 0; i < tool.solid.bodies.size(); ++i) {
    const Body& body = tool.solid.bodies[i];
    if (body.part != Part::cutting || circumstances.rapid) {
      const double contact = covered(material_, tool.core.bodies[i], move);
      if (contact <= 0.0) continue;
      find(kind_of(body.part), contact, move.end(), circumstances);
    }
    removed += remove(material_, body, move);
  }
  if (removed <= 0.0) return;
  count(removed, circumstances);
  if (!circumstances.spindle_turns && !circumstances.rapid)
    find(FindingKind::spindle_stood, removed, move.end(), circumstances);
}

// Nothing is removed; what the report leaves out as rounding is less than a cell.
void Workpiece::find_probe_at_rapid(const Vector& place_K, const Circumstances& circumstances) {
  find(FindingKind::probe, material_.grid().cell.prod(), place_K, circumstances);
}

bool Workpiece::touches(const ToolSolid& probe, const ToolPlace& place) const {
  return std::ranges::any_of(probe.bodies, [&](const Body& body) {
    return body.part != Part::holder && simulation::touches(material_, body, place);
  });
}

void Workpiece::turn(const TurningTool& tool, const SpindleAxis& axis, PlanePoint from,
                     PlanePoint to, const Circumstances& circumstances) {
  const Vector place_K{axis.x + to.x, axis.y, to.z};
  if (circumstances.rapid) {
    const double volume = covered_by_ring(material_, swept(tool.core, from, to), axis);
    if (volume <= 0.0) return;
    find(FindingKind::rapid, volume, place_K, circumstances);
  }
  if (CutMarks* marks = material_.marks()) marks->set_tool(circumstances.tool);
  const double removed = remove_ring(material_, swept(tool.insert, from, to), axis);
  if (removed <= 0.0) return;
  count(removed, circumstances);
  if (!circumstances.spindle_turns && !circumstances.rapid)
    find(FindingKind::spindle_stood, removed, place_K, circumstances);
}

void Workpiece::count(double removed_mm3, const Circumstances& circumstances) {
  for (const Share& share : circumstances.shares)
    report_.add_removal(share.origin, share.part * removed_mm3);
}

void Workpiece::find(FindingKind kind, double volume, const Vector& place_K,
                     const Circumstances& circumstances) {
  report_.add_finding({.kind = kind,
                       .origin = circumstances.shares.back().origin,
                       .tool = circumstances.tool,
                       .time_s = circumstances.time_s,
                       .place_K = place_K,
                       .volume_mm3 = volume});
}

}  // namespace stanok::simulation
