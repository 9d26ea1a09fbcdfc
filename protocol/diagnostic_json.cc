#include "protocol/diagnostic_json.h"

#include "base/enum_names.h"

namespace stanok::protocol {
namespace {

constexpr auto severity_names = enum_names<Severity>({
    {Severity::error, "error"},
    {Severity::warning, "warning"},
    {Severity::note, "note"},
});

}  // namespace

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
