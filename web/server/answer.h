// Request and Answer: HTTP as the rest of the server sees it.
//
// Every answer leaves with the same security headers: the page may load what this server has and
// nothing else, and no other page may show it in a frame.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/string_body.hpp>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "web/access/request_origin.h"

namespace stanok::web {

using Request = boost::beast::http::request<boost::beast::http::string_body>;
using Status = boost::beast::http::status;
using Field = boost::beast::http::field;
// Refers to the content of its answer.
using Response = boost::beast::http::response<boost::beast::http::span_body<const char>>;

struct Answer {
  Status status = Status::ok;
  std::string media_type{};
  std::shared_ptr<const std::string> content{};  // nullptr: none
  std::vector<std::pair<Field, std::string>> fields{};
};

[[nodiscard]] Answer text_answer(Status status, std::string text);
[[nodiscard]] Answer json_answer(Status status, const nlohmann::json& value);
// {"error": text}
[[nodiscard]] Answer refusal(Status status, const std::string& text);

// `answer` outlives the response. To a request HEAD, only its head is sent.
[[nodiscard]] Response response_of(const Answer& answer, const Request& request, Scheme scheme);

// The value of a cookie of the request; empty: there is none.
[[nodiscard]] std::string cookie_of(const Request& request, std::string_view name);

}  // namespace stanok::web
