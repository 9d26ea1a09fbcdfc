// Where a rotating tool that goes on will cut: the heights and angles of its envelope at which
// there is material in front of it.
//
// Frame K; angles count from the left of the feed on, seen from the spindle, in the sense of its
// rotation. The tool stands a little further on its way than it has cut; at each place of its
// envelope the nearest ray of the family that is least flat on it is asked whether it has material
// where it enters the tool. Places that go away from the material (behind the feed) cut nothing.
// What lies at right angles to the axis, as the face of a flat end mill, is not looked at.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/tool_solid.h"

namespace stanok::simulation {

enum class SpindleSense : std::uint8_t { clockwise, counter_clockwise };

// The cutting part of the tool between two heights.
struct EngagementSlice {
  double height = 0.0;  // of its middle over the tip
  double width = 0.0;   // along the axis
  double radius = 0.0;
  double slope = 0.0;               // of the radius over the height
  std::vector<std::uint8_t> meets;  // by angle; 0: air
};

inline constexpr int engagement_angles = 180;  // of a turn

// `feed_K`: direction of the way. Slices that meet nothing are left out.
[[nodiscard]] std::vector<EngagementSlice> engagement_of(const Material& material,
                                                         const ToolSolid& tool,
                                                         const ToolPlace& ahead,
                                                         const Vector& feed_K, SpindleSense sense);

}  // namespace stanok::simulation
