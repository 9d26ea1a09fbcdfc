#include "web/server/reception.h"

#include <algorithm>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/verb.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "protocol/contract/discovery.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/version.h"

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
  Answer answer = refusal(Status::method_not_allowed, "allowed methods: " + methods);
  answer.fields.emplace_back(Field::allow, methods);
  return answer;
}

bool reads_only(const Request& request) {
  return request.method() == verb::get || request.method() == verb::head;
}

// The elements of a list in a field, without blanks around.
std::vector<std::string_view> elements_of(std::string_view list) {
  std::vector<std::string_view> elements;
  while (!list.empty()) {
    const auto end = std::min(list.find(','), list.size());
    std::string_view one = list.substr(0, end);
    one.remove_prefix(std::min(one.find_first_not_of(" \t"), one.size()));
    one.remove_suffix(one.size() - 1 - std::min(one.find_last_not_of(" \t"), one.size() - 1));
    if (!one.empty()) elements.push_back(one);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return elements;
}

// RFC 9110, 12.5.3: "gzip;q=0" says that it is not wanted.
bool takes_gzip(const Request& request) {
  for (const std::string_view element : elements_of(field_of(request, Field::accept_encoding))) {
    const std::string_view coding = element.substr(0, element.find_first_of("; "));
    if (!boost::beast::iequals(coding, "gzip")) continue;
    const auto weight = element.find("q=");
    return weight == std::string_view::npos ||
           element.find_first_not_of("0.", weight + 2) != std::string_view::npos;
  }
  return false;
}

// RFC 9110, 13.1.2.
bool has_tag(const Request& request, const std::string& tag) {
  const auto elements = elements_of(field_of(request, Field::if_none_match));
  return std::ranges::any_of(elements, [&](std::string_view element) {
    if (element.starts_with("W/")) element.remove_prefix(2);
    return element == "*" || element == tag;
  });
}

// A form of a foreign page cannot send this type without being asked whether it may.
bool has_json(const Request& request) {
  return field_of(request, Field::content_type).starts_with("application/json");
}

Answer not_json() {
  return refusal(Status::unsupported_media_type, "the content must be application/json");
}

// The texts of an object in the content; what is not there is empty.
class Members {
 public:
  explicit Members(const Request& request) : content_(protocol::json_from_text(request.body())) {}

  std::string operator[](const char* name) const {
    const auto member = content_.is_object() ? content_.find(name) : content_.end();
    return member != content_.end() && member->is_string() ? member->get<std::string>() : "";
  }

 private:
  json content_;
};

HistoryQuestion question_of(const Request& request) {
  const Members asked(request);
  HistoryQuestion question;
  question.query = asked["query"];
  question.machine = asked["machine"];
  if (!asked["since"].empty()) question.since = asked["since"];
  return question;
}

Status status_of(HistoryFault::Kind kind) {
  switch (kind) {
    case HistoryFault::Kind::no_history:
      return Status::not_found;
    case HistoryFault::Kind::bad_question:
      return Status::bad_request;
    case HistoryFault::Kind::busy:
      return Status::service_unavailable;
    case HistoryFault::Kind::failed:
      break;
  }
  return Status::bad_gateway;
}

// What a file is sent as to who asks for it so.
Answer answer_of(const PageFile& file, const Request& request) {
  Answer answer{.media_type = file.media_type, .content = file.content};
  const auto* lifetime = file.is_hashed ? "public, max-age=31536000, immutable" : "no-cache";
  answer.fields = {{Field::cache_control, lifetime}, {Field::vary, "Accept-Encoding"}};
  const bool is_small = file.compressed != nullptr && takes_gzip(request);
  const std::string tag = '"' + file.tag + (is_small ? "-gzip\"" : "\"");
  answer.fields.emplace_back(Field::etag, tag);
  if (has_tag(request, tag)) {
    answer.status = Status::not_modified;
    answer.content = nullptr;
    return answer;
  }
  if (is_small) {
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

Reception::Reception(const Exhibits& exhibits, Authentication& authentication,
                     const OwnNames& names)
    : exhibits_(exhibits),
      authentication_(authentication),
      names_(names),
      methods_(json_answer(Status::ok, protocol::discovery_document(protocol::version))) {}

std::optional<Answer> Reception::obstacle(const Request& request) const {
  const auto host = field_of(request, Field::host);
  if (request.count(Field::host) != 1 || !names_.is_own_host(host))
    return refusal(Status::forbidden,
                   "this server does not have this name; add the name with --name");
  const bool has_origin = request.count(Field::origin) > 0;
  if (has_origin && !names_.is_own_origin(field_of(request, Field::origin), host))
    return refusal(Status::forbidden, "requests from pages of another server are not allowed");
  return std::nullopt;
}

asio::awaitable<Answer> Reception::answer(const Request& request, asio::ip::address from) {
  const auto path = path_of(request);
  if (path == "/api/session") co_return co_await answer_session(request, from);
  if (path == "/api/history") co_return co_await history(request);
  if (!reads_only(request)) co_return not_allowed("GET, HEAD");
  if (path == "/api/openrpc.json") co_return methods_;
  if (path == "/api/machines") co_return co_await overview(request);
  if (path == "/health") co_return co_await health();
  if (path.starts_with(manual_prefix)) co_return manual_file(request);
  co_return page_file(request);
}

asio::awaitable<Answer> Reception::answer_session(const Request& request, asio::ip::address from) {
  if (request.method() == verb::post) co_return co_await begin_session(request, from);
  if (request.method() == verb::delete_) co_return co_await authentication_.leave(request);
  if (reads_only(request)) co_return co_await describe_session(request);
  co_return not_allowed("GET, HEAD, POST, DELETE");
}

asio::awaitable<Answer> Reception::begin_session(const Request& request, asio::ip::address from) {
  if (!has_json(request)) co_return not_json();
  const Members wanted(request);
  const std::string token = wanted["token"];
  if (!token.empty()) co_return co_await authentication_.enter_by_link(request, token);
  const std::string name = wanted["name"];
  if (name.empty())
    co_return refusal(Status::bad_request,
                      R"(the content must be {"token": ""} or {"name": "", "password": ""})");
  co_return co_await authentication_.enter_by_password(request, name, wanted["password"], from);
}

asio::awaitable<Answer> Reception::describe_session(const Request& request) {
  const auto session = authentication_.session_of(request);
  if (!session) co_return refusal(Status::unauthorized, "no session");
  MachineGlance& machine = exhibits_.machines.first();
  static_cast<void>(co_await machine.daemon_answers());
  co_return json_answer(Status::ok, {{"name", session->identity.name},
                                     {"role", protocol::role_name(session->identity.role)},
                                     {"machine", machine.machine()}});
}

asio::awaitable<Answer> Reception::overview(const Request& request) {
  if (!authentication_.session_of(request)) co_return refusal(Status::unauthorized, "no session");
  const json machines = co_await exhibits_.machines.overview();
  co_return json_answer(Status::ok,
                        {{"machines", machines}, {"history", exhibits_.history.has_history()}});
}

asio::awaitable<Answer> Reception::history(const Request& request) {
  if (request.method() != verb::post) co_return not_allowed("POST");
  if (!authentication_.session_of(request)) co_return refusal(Status::unauthorized, "no session");
  if (!has_json(request)) co_return not_json();
  const auto answered = co_await exhibits_.history.ask(question_of(request));
  if (answered) co_return json_answer(Status::ok, *answered);
  co_return refusal(status_of(answered.error().kind), answered.error().text);
}

asio::awaitable<Answer> Reception::health() {
  MachineGlance& machine = exhibits_.machines.first();
  const bool answers = co_await machine.daemon_answers();
  co_return json_answer(Status::ok,
                        {{"status", machine.is_full() ? "full" : "ok"}, {"daemon", answers}});
}

Answer Reception::page_file(const Request& request) {
  if (const PageFile* file = exhibits_.page.find(path_of(request)))
    return answer_of(*file, request);
  if (path_of(request) != "/") return text_answer(Status::not_found, "there is no such file\n");
  return text_answer(Status::not_found, "there is no page in " + exhibits_.page.folder().string() +
                                            "; give its folder with --page\n");
}

Answer Reception::manual_file(const Request& request) {
  // With the slash before the name, as files are known by.
  const auto name = path_of(request).substr(manual_prefix.size() - 1);
  if (const PageFile* file = exhibits_.manual.find(name)) return answer_of(*file, request);
  return text_answer(Status::not_found, "there is no such document in " +
                                            exhibits_.manual.folder().string() +
                                            "; give the folder of the documents with --manual\n");
}

}  // namespace stanok::web
