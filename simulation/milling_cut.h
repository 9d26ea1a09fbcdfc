// A rotating tool on its way through the material: swept exactly while its axis keeps its
// direction, else in positions so close that what they leave between them is below a tolerance.
#pragma once

#include "simulation/tool_solid.h"

namespace stanok::simulation {

// A tool from a place along a straight way, its axis as it is.
struct ToolMove {
  ToolPlace begin;
  Vector way = Vector::Zero();

  [[nodiscard]] Vector end() const { return begin.tip + way; }
};

// Takes away what the body sweeps; mm³, by the mean of the three families.
double remove(Material& material, const Body& body, const ToolMove& move);

// What the body sweeps; mm³.
[[nodiscard]] double covered(const Material& material, const Body& body, const ToolMove& move);

// Whether the body covers anything; ends with the first ray that it does.
[[nodiscard]] bool touches(const Material& material, const Body& body, const ToolPlace& place);

// Into how many equal steps the way from one place to the other falls. Between two positions a
// flank leaves cusps, the higher the thinner the tool is there; a sharp edge that moves both along
// and across the tool's axis leaves steps of d sin θ cos θ.
[[nodiscard]] int steps_between(const ToolSolid& tool, const ToolPlace& from, const ToolPlace& to,
                                double tolerance);

// The moves that stand for the way from one place to the other: straight ones where the axis keeps
// its direction within `tolerance`, so short that a finding has a place, else the steps between.
[[nodiscard]] std::vector<ToolMove> moves_between(const ToolSolid& tool, const ToolPlace& from,
                                                  const ToolPlace& to, double tolerance);

[[nodiscard]] ToolPlace place_between(const ToolPlace& from, const ToolPlace& to, double part);

// Whether the body may touch the material anywhere between the two places.
[[nodiscard]] bool may_touch(const Material& material, const Body& body, const ToolPlace& from,
                             const ToolPlace& to);

}  // namespace stanok::simulation
