// Failure: why a request was not done, as the operator protocol tells it.
//
// The kind becomes the JSON-RPC error code and the exit code of `stanok`; the catalogue code gives
// reaction and remedy (base/catalogue.h). `data` of the JSON error always has the same seven
// members, null where unknown.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/diagnostic.h"

namespace stanok::protocol {

enum class FailureKind : std::uint8_t {
  parse_error,         // -32700
  invalid_request,     // -32600
  method_not_found,    // -32601
  invalid_parameters,  // -32602
  internal,            // -32603
  refused,             // -32001 the machine's state does not allow it
  not_permitted,       // -32002 the session's role does not allow it
  timed_out,           // -32003
  program_error,       // -32004 codes E and U
  machine_fault,       // -32005 codes A
};

struct Failure {
  FailureKind kind = FailureKind::refused;
  std::string code;     // of the catalogue: "E9003"; may be empty
  std::string message;  // one line
  int channel = 0;      // 0: the machine
  Place place;          // line 0: no place in a program
};

[[nodiscard]] int rpc_code(FailureKind kind);
// The kind of a JSON-RPC error code; codes of other makers count as `internal`.
[[nodiscard]] FailureKind kind_of_rpc_code(int code);
// Exit code of a command that failed so (docs/reference/command-line.md, "Exit codes").
[[nodiscard]] int exit_code(FailureKind kind);

// A machine fault for codes A, a program error for all others.
[[nodiscard]] FailureKind kind_of_alarm(std::string_view code);

// The member `error` of a JSON-RPC answer, and back.
[[nodiscard]] nlohmann::json to_json(const Failure& failure);
[[nodiscard]] Failure failure_from_json(const nlohmann::json& error);

}  // namespace stanok::protocol
