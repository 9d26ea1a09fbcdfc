#include "simulation/tool_shape.h"

#include <algorithm>
#include <array>
#include <utility>

namespace stanok::simulation {

std::optional<ToolKind> tool_kind_named(std::string_view name) {
  constexpr auto names =
      std::to_array<std::pair<std::string_view, ToolKind>>({{"flat", ToolKind::flat},
                                                            {"ball", ToolKind::ball},
                                                            {"bull", ToolKind::bull},
                                                            {"drill", ToolKind::drill},
                                                            {"taper", ToolKind::taper},
                                                            {"insert", ToolKind::insert},
                                                            {"probe", ToolKind::probe}});
  const auto* found = std::ranges::find(names, name, &std::pair<std::string_view, ToolKind>::first);
  if (found == names.end()) return std::nullopt;
  return found->second;
}

std::string defect_of(const ToolShape& tool) {
  if (tool.kind == ToolKind::insert) {
    const bool has_sides = tool.orientation >= 1 && tool.orientation <= 8;
    if (!has_sides && tool.angle_front == tool.angle_back)
      return "an insert needs its orientation, or its two angles";
    return "";
  }
  if (tool.radius <= 0.0) return "its radius is 0";
  if (tool.kind == ToolKind::taper && (tool.taper_angle <= 0.0 || tool.taper_angle >= 90.0))
    return "a taper needs its taper_angle, above 0 and below 90 deg";
  return "";
}

}  // namespace stanok::simulation
