#include "jobs/tools/json_members.h"

#include <algorithm>

#include "base/text_bounds.h"
#include "base/utf8.h"
#include "jobs/tools/foreign_text.h"
#include "protocol/contract/json_text.h"

namespace stanok::jobs {
namespace {

const Json& empty_object() {
  static const Json empty = Json::object();
  return empty;
}

const Json& empty_list() {
  static const Json empty = Json::array();
  return empty;
}

ForeignPlace place_of_byte(std::string_view text, std::size_t byte, const std::string& file) {
  const std::string_view before = text.substr(0, byte);
  const auto line = static_cast<unsigned>(std::ranges::count(before, '\n')) + 1;
  const std::string_view in_line = before.substr(before.rfind('\n') + 1);
  return {
      .line = line, .column = static_cast<unsigned>(character_count(in_line)) + 1, .file = file};
}

// Of a member that says nothing, nothing is lost.
bool says_nothing(const Json& value) {
  if (value.is_null() || value == Json(false) || value == Json("")) return true;
  if (value.is_number() && value == Json(0)) return true;
  return (value.is_object() || value.is_array()) && value.empty();
}

}  // namespace

std::optional<Json> json_of(std::string_view text, ForeignReader& reader, const std::string& file) {
  if (const auto excess = json_excess(text)) {
    reader.fault({.line = excess->line, .column = excess->column, .file = file},
                 "cannot be read: " + excess->text);
    return std::nullopt;
  }
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const Json::parse_error& error) {
    // Counted from 1, behind what was read last.
    const std::size_t byte = std::min(std::max<std::size_t>(error.byte, 1) - 1, text.size());
    reader.fault(place_of_byte(text, byte, file),
                 "not valid JSON here; export the library again, or correct the text");
  } catch (const Json::exception&) {
    reader.fault({.file = file},
                 "a number in it is too large; correct it in the program that wrote the file");
  }
  return std::nullopt;
}

std::string shown(const Json& value) {
  if (value.is_string()) return shortened(value.get_ref<const std::string&>());
  const std::string count = std::to_string(value.size());
  if (value.is_object()) return count + (value.size() == 1 ? " member" : " members");
  if (value.is_array()) return count + (value.size() == 1 ? " entry" : " entries");
  return protocol::json_text(value);
}

std::string json_file_text(const Json& value) {
  return protocol::json_text(value, protocol::JsonLayout::indented) + "\n";
}

JsonMembers::JsonMembers(const Json& object, std::string path, ForeignReader& reader,
                         std::string file)
    : object_(object.is_object() ? object : empty_object()),
      path_(std::move(path)),
      file_(std::move(file)),
      reader_(reader) {
  if (!object.is_object()) {
    reader_.fault({.member = path_, .file = file_},
                  "must be an object, { ... }; export the library again");
  }
}

ForeignPlace JsonMembers::place_of_member(std::string_view name) const {
  return {.member = (path_.empty() ? "" : path_ + ".") + std::string(name), .file = file_};
}

const Json* JsonMembers::take(std::string_view name) {
  const auto found = object_.find(std::string(name));
  if (found == object_.end()) return nullptr;
  taken_.emplace(name);
  return &*found;
}

std::optional<double> JsonMembers::number(std::string_view name) {
  const Json* value = take(name);
  if (value == nullptr || value->is_null()) return std::nullopt;
  if (value->is_number()) return value->get<double>();
  reader_.fault(place_of_member(name), "is " + shown(*value) + "; it must be a number");
  return std::nullopt;
}

std::optional<std::string> JsonMembers::text(std::string_view name) {
  const Json* value = take(name);
  if (value == nullptr || value->is_null()) return std::nullopt;
  if (value->is_string()) return value->get<std::string>();
  reader_.fault(place_of_member(name), "is " + shown(*value) + "; it must be a text");
  return std::nullopt;
}

JsonMembers JsonMembers::object(std::string_view name) {
  const Json* value = take(name);
  const bool is_there = value != nullptr && !value->is_null();
  return {is_there ? *value : empty_object(), place_of_member(name).member, reader_, file_};
}

const Json& JsonMembers::list(std::string_view name) {
  const Json* value = take(name);
  if (value == nullptr || value->is_null()) return empty_list();
  if (value->is_array()) return *value;
  reader_.fault(place_of_member(name), "must be a list, [ ... ]; export the library again");
  return empty_list();
}

void JsonMembers::lose_the_rest(int tool, std::string_view reason, std::string_view owner) {
  for (const auto& [name, value] : object_.items()) {
    if (taken_.contains(name) || says_nothing(value)) continue;
    reader_.lose({.tool = tool,
                  .field = std::string(owner) + shortened(name),
                  .value = shown(value),
                  .reason = std::string(reason)});
  }
}

}  // namespace stanok::jobs
