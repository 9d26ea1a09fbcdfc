#include "protocol/contract/diagnostic_json.h"

#include <string>
#include <vector>

#include "base/enum_names.h"

namespace stanok::protocol {
namespace {

constexpr auto severity_names = enum_names<Severity>({
    {Severity::error, "error"},
    {Severity::warning, "warning"},
    {Severity::note, "note"},
});

std::string text_of(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

int number_of(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number_integer() ? found->get<int>() : 0;
}

std::vector<std::string> texts_of(const nlohmann::json& object, const char* name) {
  std::vector<std::string> texts;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return texts;
  for (const nlohmann::json& one : *found) {
    if (one.is_string()) texts.push_back(one.get<std::string>());
  }
  return texts;
}

std::vector<Note> notes_of(const nlohmann::json& object) {
  std::vector<Note> notes;
  const auto found = object.find("notes");
  if (found == object.end() || !found->is_array()) return notes;
  for (const nlohmann::json& one : *found) {
    if (!one.is_object()) continue;
    notes.push_back({text_of(one, "text"), {text_of(one, "file"), number_of(one, "line")}});
  }
  return notes;
}

}  // namespace

Diagnostic diagnostic_of(const nlohmann::json& json) {
  if (!json.is_object()) return {};
  return {.code = text_of(json, "code"),
          .severity = severity_names.value(text_of(json, "severity")).value_or(Severity::error),
          .place = {text_of(json, "file"), number_of(json, "line"), number_of(json, "column"),
                    number_of(json, "end_line"), number_of(json, "end_column")},
          .message = text_of(json, "message"),
          .label = text_of(json, "label"),
          .notes = notes_of(json),
          .help = texts_of(json, "help"),
          .stack = texts_of(json, "stack"),
          .source_line = {}};
}

nlohmann::ordered_json diagnostic_json(const Diagnostic& diagnostic) {
  nlohmann::ordered_json json;
  json["code"] = diagnostic.code;
  json["severity"] = severity_names[diagnostic.severity];
  json["file"] = diagnostic.place.file;
  json["line"] = diagnostic.place.line;
  json["column"] = diagnostic.place.column;
  json["end_line"] = diagnostic.place.end_line;
  json["end_column"] = diagnostic.place.end_column;
  json["message"] = diagnostic.message;
  json["label"] = diagnostic.label;
  json["notes"] = nlohmann::ordered_json::array();
  for (const Note& note : diagnostic.notes) {
    json["notes"].push_back(
        {{"text", note.text}, {"file", note.place.file}, {"line", note.place.line}});
  }
  json["help"] = diagnostic.help;
  json["stack"] = diagnostic.stack;
  return json;
}

}  // namespace stanok::protocol
