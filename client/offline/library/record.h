// Records that pass between processes and lie in the cache: CBOR (RFC 8949), since names and texts
// of programs need not be UTF-8.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace stanok::client {

[[nodiscard]] std::string bytes_of(const nlohmann::json& record);

// Nothing where the bytes are no record, or nested deeper than one is: a file may be damaged, and
// the reader goes down the stack once for each level.
[[nodiscard]] std::optional<nlohmann::json> record_in(std::string_view bytes);

}  // namespace stanok::client
