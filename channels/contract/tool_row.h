// A row of the tool table as plain data, so that the cycle can tell which tool is at work with
// which values: all of the row but its name. Lengths mm, angles deg, as in ToolEdge.
#pragma once

#include <cstdint>

#include "base/fixed_text.h"
#include "channels/contract/machine_config.h"

namespace stanok::channels {

struct ToolRow {
  std::int32_t number = 0;  // 0: there is no tool, or no row of it
  std::int32_t edge = 1;
  FixedText<16> kind;
  std::int32_t orientation = 0;
  double length = 0.0, length_x = 0.0, length_y = 0.0;
  double radius = 0.0, corner_radius = 0.0;
  double wear_length = 0.0, wear_length_x = 0.0, wear_radius = 0.0, overhang = 0.0;
  double flute_length = 0.0, shank_diameter = 0.0, holder_diameter = 0.0, holder_length = 0.0;
  double angle_front = 0.0, angle_back = 0.0;
  double point_angle = 0.0, taper_angle = 0.0;

  friend bool operator==(const ToolRow&, const ToolRow&) = default;
};

[[nodiscard]] inline ToolRow row_of(const ToolEdge& tool) {
  return {.number = tool.number,
          .edge = tool.edge,
          .kind = FixedText<16>(tool.kind),
          .orientation = tool.orientation,
          .length = tool.length,
          .length_x = tool.length_x,
          .length_y = tool.length_y,
          .radius = tool.radius,
          .corner_radius = tool.corner_radius,
          .wear_length = tool.wear_length,
          .wear_length_x = tool.wear_length_x,
          .wear_radius = tool.wear_radius,
          .overhang = tool.overhang,
          .flute_length = tool.flute_length,
          .shank_diameter = tool.shank_diameter,
          .holder_diameter = tool.holder_diameter,
          .holder_length = tool.holder_length,
          .angle_front = tool.angle_front,
          .angle_back = tool.angle_back,
          .point_angle = tool.point_angle,
          .taper_angle = tool.taper_angle};
}

}  // namespace stanok::channels
