#include "protocol/contract/json_rpc.h"

#include <algorithm>

#include "base/text_bounds.h"
#include "protocol/contract/json_text.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

constexpr const char* not_a_request = "E9001";

Unexpected<BadRequest> bad(json id, FailureKind kind, std::string message) {
  return Unexpected<BadRequest>(
      BadRequest{std::move(id), Failure{kind, not_a_request, std::move(message), 0, {}}});
}

std::string to_line(const json& message) {
  return json_text(message) + "\n";
}

// Looks like the first line of a web browser's request: somebody is on the wrong door.
bool looks_like_http(std::string_view line) {
  return line.find(" HTTP/1.") != std::string_view::npos && !line.starts_with('{');
}

bool is_id(const json& value) {
  return value.is_number() || value.is_string() || value.is_null();
}

}  // namespace

json json_from_text(std::string_view text) {
  if (json_excess(text)) return {json::value_t::discarded};
  return json::parse(text.begin(), text.end(), nullptr, false);
}

Expected<RpcRequest, BadRequest> parse_request(std::string_view line) {
  if (looks_like_http(line))
    return bad(nullptr, FailureKind::parse_error, "this is not an HTTP server");
  if (const auto excess = json_excess(line))
    return bad(nullptr, FailureKind::parse_error, "not a request: " + excess->text);
  const json message = json_from_text(line);
  if (message.is_discarded()) return bad(nullptr, FailureKind::parse_error, "not a JSON text");
  if (message.is_array()) {
    return bad(nullptr, FailureKind::invalid_request,
               "batches are not supported: send one request per line");
  }
  if (!message.is_object())
    return bad(nullptr, FailureKind::invalid_request, "a request is a JSON object");

  RpcRequest request;
  request.wants_answer = message.contains("id");
  if (request.wants_answer) {
    if (!is_id(message["id"])) {
      return bad(nullptr, FailureKind::invalid_request, "id must be a number, a string or null");
    }
    request.id = message["id"];
  }
  if (message.value("jsonrpc", json()) != "2.0") {
    return bad(request.id, FailureKind::invalid_request, "member \"jsonrpc\" must be \"2.0\"");
  }
  const auto method = message.find("method");
  if (method == message.end() || !method->is_string()) {
    return bad(request.id, FailureKind::invalid_request, "member \"method\" must be a string");
  }
  request.method = method->get<std::string>();
  request.parameters = message.value("params", json::object());
  if (!request.parameters.is_structured()) {
    return bad(request.id, FailureKind::invalid_request,
               "member \"params\" must be an object or an array");
  }
  return request;
}

std::string answer_line(const json& id, const json& result) {
  return to_line({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
}

std::string failure_line(const json& id, const Failure& failure) {
  return to_line({{"jsonrpc", "2.0"}, {"id", id}, {"error", to_json(failure)}});
}

std::string notification_line(std::string_view method, const json& parameters) {
  return to_line({{"jsonrpc", "2.0"}, {"method", method}, {"params", parameters}});
}

std::string request_line(int id, std::string_view method, const json& parameters) {
  return to_line({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", parameters}});
}

}  // namespace stanok::protocol
