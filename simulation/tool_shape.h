// The shape of a tool as the tool table describes it. Lengths mm, angles deg.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stanok::simulation {

// A probe touches with its ball and stylus and cuts nothing.
enum class ToolKind : std::uint8_t { flat, ball, bull, drill, taper, insert, probe };

[[nodiscard]] std::optional<ToolKind> tool_kind_named(std::string_view name);

struct ToolShape {
  ToolKind kind = ToolKind::flat;
  double radius = 0.0;          // of the cutter; insert: of the nose; probe: of the ball
  double corner_radius = 0.0;   // bull; taper: of the rounded tip
  double flute_length = 0.0;    // 0: as far as the shank or holder begins; insert: of an edge
  double overhang = 0.0;        // out of the holder; 0: to the nose, less the holder
  double shank_diameter = 0.0;  // 0: as the cutter; probe: 0.6 of the ball
  double holder_diameter = 0.0;
  double holder_length = 0.0;
  double length = 0.0;       // from tip to spindle nose
  double point_angle = 0.0;  // drill: between its lips; 0: 118
  double taper_angle = 0.0;  // taper: between axis and flank
  int orientation = 0;       // insert: where its imaginary tip is, 1 to 9
  double angle_front = 0.0;  // insert: of its edges, from Z towards X
  double angle_back = 0.0;   // both 0: by the orientation
};

// "" or what the tool lacks to be seen.
[[nodiscard]] std::string defect_of(const ToolShape& tool);

}  // namespace stanok::simulation
