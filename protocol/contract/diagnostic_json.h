// A diagnostic as JSON, the same in `stanok check --json` and in answers of the daemon.
#pragma once

#include <nlohmann/json.hpp>

#include "base/diagnostic.h"

namespace stanok::protocol {

[[nodiscard]] nlohmann::ordered_json diagnostic_json(const Diagnostic& diagnostic);

// The same read back, without its source line, which JSON has not. What is missing, or of another
// type, as of an older or newer daemon, is left empty.
[[nodiscard]] Diagnostic diagnostic_of(const nlohmann::json& json);

}  // namespace stanok::protocol
