#include "web/server/answer.h"

#include <nlohmann/json.hpp>

#include "protocol/contract/json_text.h"

namespace stanok::web {
namespace {

namespace http = boost::beast::http;

// What the page shows comes from here, its styles and pictures, too; nothing stands in its text.
constexpr auto content_policy =
    "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

void add_security_fields(Response& response, Scheme scheme) {
  response.set("Content-Security-Policy", content_policy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  if (scheme == Scheme::https) response.set("Strict-Transport-Security", "max-age=31536000");
}

}  // namespace

Answer text_answer(Status status, std::string text) {
  return {.status = status,
          .media_type = "text/plain; charset=utf-8",
          .content = std::make_shared<const std::string>(std::move(text))};
}

Answer json_answer(Status status, const nlohmann::json& value) {
  return {.status = status,
          .media_type = "application/json",
          .content = std::make_shared<const std::string>(protocol::json_text(value) + "\n"),
          .fields = {{Field::cache_control, "no-store"}}};
}

Answer refusal(Status status, const std::string& text) {
  return json_answer(status, {{"error", text}});
}

Response response_of(const Answer& answer, const Request& request, Scheme scheme) {
  Response response{answer.status, request.version()};
  response.set(Field::server, "stanok-web");
  add_security_fields(response, scheme);
  if (!answer.media_type.empty()) response.set(Field::content_type, answer.media_type);
  for (const auto& [name, value] : answer.fields) response.insert(name, value);
  response.keep_alive(request.keep_alive());
  const bool has_content = answer.content != nullptr;
  if (answer.status != Status::no_content && answer.status != Status::not_modified)
    response.content_length(has_content ? answer.content->size() : 0);
  if (has_content && request.method() != http::verb::head)
    response.body() = {answer.content->data(), answer.content->size()};
  return response;
}

std::string cookie_of(const Request& request, std::string_view name) {
  const auto field = request[Field::cookie];
  std::string_view rest(field.data(), field.size());
  while (!rest.empty()) {
    const auto end = std::min(rest.find(';'), rest.size());
    std::string_view cookie = rest.substr(0, end);
    cookie.remove_prefix(std::min(cookie.find_first_not_of(' '), cookie.size()));
    if (cookie.starts_with(name) && cookie.substr(name.size()).starts_with('='))
      return std::string(cookie.substr(name.size() + 1));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

}  // namespace stanok::web
