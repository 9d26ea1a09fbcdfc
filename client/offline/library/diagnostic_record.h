// Diagnostics as values that pass between processes and lie in the cache: all of their fields.
#pragma once

#include <nlohmann/json.hpp>

#include "base/diagnostic.h"

namespace stanok::client {

// Texts are bytes, which need not be UTF-8: to be written as CBOR, not as JSON.
[[nodiscard]] nlohmann::json diagnostics_record(const Diagnostics& diagnostics);
// Throws nlohmann::json::exception where it is none.
[[nodiscard]] Diagnostics diagnostics_of(const nlohmann::json& record);

}  // namespace stanok::client
