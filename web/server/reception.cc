#include "web/server/reception.h"

#include <algorithm>
#include <boost/beast/http/verb.hpp>
#include <nlohmann/json.hpp>

#include "protocol/discovery.h"
#include "protocol/json_rpc.h"
#include "protocol/version.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
using boost::beast::http::verb;
using nlohmann::json;

constexpr std::string_view manual_prefix = "/manual/";

std::string_view field_of(const Request& request, Field name) {
  const auto value = request[name];
  return {value.data(), value.size()};
}

Answer not_allowed(const std::string& methods) {
  Answer answer = refusal(Status::method_not_allowed, "here are only " + methods);
  answer.fields.emplace_back(Field::allow, methods);
  return answer;
}

bool reads_only(const Request& request) {
  return request.method() == verb::get || request.method() == verb::head;
}

bool takes_gzip(const Request& request) {
  return field_of(request, Field::accept_encoding).find("gzip") != std::string_view::npos;
}

// What a file is sent as to who asks for it so.
Answer answer_of(const PageFile& file, const Request& request) {
  Answer answer{.media_type = file.media_type, .content = file.content};
  const auto* lifetime = file.is_hashed ? "public, max-age=31536000, immutable" : "no-cache";
  answer.fields = {{Field::cache_control, lifetime}, {Field::vary, "Accept-Encoding"}};
  if (file.compressed != nullptr && takes_gzip(request)) {
    answer.content = file.compressed;
    answer.fields.emplace_back(Field::content_encoding, "gzip");
  }
  return answer;
}

}  // namespace

std::string_view path_of(const Request& request) {
  const std::string_view target(request.target().data(), request.target().size());
  return target.substr(0, target.find('?'));
}

Reception::Reception(PageFiles& page, PageFiles& manual, Authentication& authentication,
                     DaemonProbe& machine, const OwnNames& names)
    : page_(page),
      manual_(manual),
      authentication_(authentication),
      machine_(machine),
      names_(names),
      methods_(json_answer(Status::ok, protocol::discovery_document(protocol::version))) {}

std::optional<Answer> Reception::obstacle(const Request& request) const {
  const auto host = field_of(request, Field::host);
  if (request.count(Field::host) != 1 || !names_.is_own_host(host))
    return refusal(Status::forbidden,
                   "this server is not called so; --name tells it another name of its own");
  const bool has_origin = request.count(Field::origin) > 0;
  if (has_origin && !names_.is_own_origin(field_of(request, Field::origin), host))
    return refusal(Status::forbidden, "a page of another server may not ask here");
  return std::nullopt;
}

asio::awaitable<Answer> Reception::answer(const Request& request, asio::ip::address from) {
  const auto path = path_of(request);
  if (path == "/api/session") co_return co_await answer_session(request, from);
  if (!reads_only(request)) co_return not_allowed("GET, HEAD");
  if (path == "/api/openrpc.json") co_return methods_;
  if (path == "/health") co_return co_await health();
  if (path.starts_with(manual_prefix)) co_return manual_file(request);
  co_return page_file(request);
}

asio::awaitable<Answer> Reception::answer_session(const Request& request, asio::ip::address from) {
  if (request.method() == verb::post) co_return co_await begin_session(request, from);
  if (request.method() == verb::delete_) co_return authentication_.leave(request);
  if (reads_only(request)) co_return co_await describe_session(request);
  co_return not_allowed("GET, HEAD, POST, DELETE");
}

// A form of a foreign page cannot send this type without being asked whether it may.
asio::awaitable<Answer> Reception::begin_session(const Request& request, asio::ip::address from) {
  if (!field_of(request, Field::content_type).starts_with("application/json"))
    co_return refusal(Status::unsupported_media_type, "the content must be application/json");
  const json wanted = protocol::json_from_text(request.body());
  const auto text_of = [&](const char* name) {
    const auto member = wanted.is_object() ? wanted.find(name) : wanted.end();
    return member != wanted.end() && member->is_string() ? member->get<std::string>() : "";
  };
  const std::string token = text_of("token");
  if (!token.empty()) co_return authentication_.enter_by_link(token);
  const std::string name = text_of("name");
  if (name.empty())
    co_return refusal(Status::bad_request,
                      R"(the content must be {"token": ""} or {"name": "", "password": ""})");
  co_return co_await authentication_.enter_by_password(name, text_of("password"), from);
}

asio::awaitable<Answer> Reception::describe_session(const Request& request) {
  const auto session = authentication_.session_of(request);
  if (!session) co_return refusal(Status::unauthorized, "there is no session");
  static_cast<void>(co_await machine_.daemon_answers());
  co_return json_answer(Status::ok, {{"name", session->identity.name},
                                     {"role", protocol::role_name(session->identity.role)},
                                     {"machine", machine_.machine()}});
}

asio::awaitable<Answer> Reception::health() {
  const bool answers = co_await machine_.daemon_answers();
  co_return json_answer(Status::ok, {{"status", "ok"}, {"daemon", answers}});
}

Answer Reception::page_file(const Request& request) {
  if (const PageFile* file = page_.find(path_of(request))) return answer_of(*file, request);
  if (path_of(request) != "/") return text_answer(Status::not_found, "there is no such file\n");
  return text_answer(Status::not_found, "there is no page in " + page_.folder().string() +
                                            "; --page names its folder\n");
}

Answer Reception::manual_file(const Request& request) {
  // With the slash before the name, as files are known by.
  const auto name = path_of(request).substr(manual_prefix.size() - 1);
  if (const PageFile* file = manual_.find(name)) return answer_of(*file, request);
  return text_answer(Status::not_found, "there is no such document in " +
                                            manual_.folder().string() +
                                            "; --manual names the folder of the documents\n");
}

}  // namespace stanok::web
