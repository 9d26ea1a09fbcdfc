// JSON-RPC 2.0 as the operator protocol speaks it: one JSON text per line, no batches, no sockets
// here.
//
// A line that is not a request still gets an answer, so that the connection lives. Source:
// JSON-RPC 2.0 Specification (jsonrpc.org), sections 4 and 5.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/expected.h"
#include "protocol/contract/failure.h"
#include "protocol/contract/method_table.h"

namespace stanok::protocol {

// The value of a JSON text; a discarded one when it is none, or deeper or longer than
// base/text_bounds.h allows.
[[nodiscard]] nlohmann::json json_from_text(std::string_view text);

struct RpcRequest {
  nlohmann::json id;         // number, string or null
  bool wants_answer = true;  // false: a notification, without the member `id`
  std::string method;
  nlohmann::json parameters;  // object or array; an empty object when absent
};

// A request that cannot be read, with the id as far as it could be read.
struct BadRequest {
  nlohmann::json id;
  Failure failure;
};

[[nodiscard]] Expected<RpcRequest, BadRequest> parse_request(std::string_view line);

// The parameters by name, complete and of the right type and range. A list is taken by position.
[[nodiscard]] Expected<nlohmann::json, Failure> checked_parameters(
    const Method& method, const nlohmann::json& parameters);

// Lines, each with its line end. Text that is not UTF-8 is repaired, never thrown on.
[[nodiscard]] std::string answer_line(const nlohmann::json& id, const nlohmann::json& result);
[[nodiscard]] std::string failure_line(const nlohmann::json& id, const Failure& failure);
[[nodiscard]] std::string notification_line(std::string_view method,
                                            const nlohmann::json& parameters);
[[nodiscard]] std::string request_line(int id, std::string_view method,
                                       const nlohmann::json& parameters);

}  // namespace stanok::protocol
