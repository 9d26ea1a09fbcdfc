#include "protocol/contract/failure.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/catalogue.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

struct KindRow {
  FailureKind kind;
  int rpc_code;
  int exit_code;
};

// JSON-RPC 2.0, section 5.1, and its range for servers from -32000 downwards.
constexpr auto kinds = std::to_array<KindRow>({
    {FailureKind::parse_error, -32700, 2},
    {FailureKind::invalid_request, -32600, 2},
    {FailureKind::method_not_found, -32601, 2},
    {FailureKind::invalid_parameters, -32602, 2},
    {FailureKind::internal, -32603, 1},
    {FailureKind::refused, -32001, 1},
    {FailureKind::not_permitted, -32002, 5},
    {FailureKind::timed_out, -32003, 4},
    {FailureKind::program_error, -32004, 6},
    {FailureKind::machine_fault, -32005, 7},
});

const KindRow& row_of(FailureKind kind) {
  return *std::find_if(kinds.begin(), kinds.end(),
                       [&](const KindRow& row) { return row.kind == kind; });
}

json text_or_null(std::string_view text) {
  return text.empty() ? json(nullptr) : json(text);
}

json number_or_null(int number) {
  return number == 0 ? json(nullptr) : json(number);
}

std::string text_at(const json& object, const char* key) {
  const auto member = object.find(key);
  return member != object.end() && member->is_string() ? member->get<std::string>() : std::string();
}

int number_at(const json& object, const char* key) {
  const auto member = object.find(key);
  return member != object.end() && member->is_number_integer() ? member->get<int>() : 0;
}

}  // namespace

int rpc_code(FailureKind kind) {
  return row_of(kind).rpc_code;
}

FailureKind kind_of_rpc_code(int code) {
  const auto row = std::find_if(kinds.begin(), kinds.end(),
                                [&](const KindRow& r) { return r.rpc_code == code; });
  return row == kinds.end() ? FailureKind::internal : row->kind;
}

int exit_code(FailureKind kind) {
  return row_of(kind).exit_code;
}

FailureKind kind_of_alarm(std::string_view code) {
  return code.starts_with('A') ? FailureKind::machine_fault : FailureKind::program_error;
}

json to_json(const Failure& failure) {
  const CatalogueRow* row = find_in_catalogue(failure.code);
  json data = {{"code", text_or_null(failure.code)},
               {"channel", number_or_null(failure.channel)},
               {"file", text_or_null(failure.place.file)},
               {"line", number_or_null(failure.place.line)},
               {"column", number_or_null(failure.place.column)},
               {"reaction", row == nullptr ? json(nullptr) : json(static_cast<int>(row->reaction))},
               {"remedy", text_or_null(row == nullptr ? std::string_view{} : row->remedy)}};
  return {
      {"code", rpc_code(failure.kind)}, {"message", failure.message}, {"data", std::move(data)}};
}

Failure failure_from_json(const json& error) {
  Failure failure;
  if (!error.is_object())
    return {FailureKind::internal, "", "the daemon sent an error without content", 0, {}};
  failure.kind = kind_of_rpc_code(number_at(error, "code"));
  failure.message = text_at(error, "message");
  const auto data = error.find("data");
  if (data == error.end() || !data->is_object()) return failure;
  failure.code = text_at(*data, "code");
  failure.channel = number_at(*data, "channel");
  failure.place.file = text_at(*data, "file");
  failure.place.line = number_at(*data, "line");
  failure.place.column = number_at(*data, "column");
  return failure;
}

}  // namespace stanok::protocol
