// The command table as documents: OpenRPC for programs, Markdown for docs/reference/protocol.md.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace stanok::protocol {

// Number of the protocol; grows when a client written for the number before would break.
inline constexpr int api_version = 1;

// Answer of `rpc.discover`, after the OpenRPC specification 1.2 (open-rpc.org).
[[nodiscard]] nlohmann::json discovery_document(std::string_view version);

// The tables of docs/reference/protocol.md, "Methods".
[[nodiscard]] std::string methods_markdown();

}  // namespace stanok::protocol
