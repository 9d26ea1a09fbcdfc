// Where the rotary axes stand in tilted planes as JSON, the same in `stanok check --json`, in
// answers of the daemon and in Python.
#pragma once

#include <nlohmann/json.hpp>

#include "base/plane_position.h"

namespace stanok::protocol {

// [{"file", "line", "tool": [x, y, z], "axes": {"A": deg, ...}, "other": {"word": "P1" | "P2",
// "axes": {...}, "limit"}}]. "other" is absent where there is none; with "limit" its one axis
// cannot stand there, but only up to this angle.
[[nodiscard]] nlohmann::ordered_json plane_json(const PlanePositions& planes);

}  // namespace stanok::protocol
