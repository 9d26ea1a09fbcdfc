// A diagnostic as JSON, the same in `stanok check --json` and in answers of the daemon.
#pragma once

#include <nlohmann/json.hpp>

#include "base/diagnostic.h"

namespace stanok::protocol {

[[nodiscard]] nlohmann::ordered_json diagnostic_json(const Diagnostic& diagnostic);

}  // namespace stanok::protocol
