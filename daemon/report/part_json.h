// Places on the part as clients get them (docs/reference/protocol.md): mm, poses row by row with
// the shift as the fourth number of each row.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "simulation/machine_geometry.h"

namespace stanok::daemon {

// A system that the base of a scheme carries.
[[nodiscard]] nlohmann::json carried_json(int scheme, const simulation::Pose& in_base);
// Where the tool is, and how the active workpiece system and the machine lie there; nothing: it is
// not known.
[[nodiscard]] nlohmann::json on_part_json(const simulation::ToolPlace& tool,
                                          const std::optional<simulation::Pose>& work,
                                          const std::optional<simulation::Pose>& machine);

}  // namespace stanok::daemon
