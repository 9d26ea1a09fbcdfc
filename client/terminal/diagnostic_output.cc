#include "client/terminal/diagnostic_output.h"

#include <unistd.h>

#include "base/enum_names.h"
#include "client/terminal/output.h"

namespace stanok::client {
namespace {

constexpr auto severity_names = enum_names<Severity>({
    {Severity::error, "error"},
    {Severity::warning, "warning"},
    {Severity::note, "note"},
});

}  // namespace

nlohmann::ordered_json to_json(const Diagnostic& diagnostic) {
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

std::string coloured_text(const Diagnostic& diagnostic, const Terminal& terminal) {
  const std::string text = to_text(diagnostic);
  const std::size_t head = text.find(']') == std::string::npos ? 0 : text.find(']') + 1;
  const Colour colour = diagnostic.severity == Severity::error     ? Colour::red
                        : diagnostic.severity == Severity::warning ? Colour::yellow
                                                                   : Colour::bold;
  return terminal.coloured(text.substr(0, head), head == 0 ? Colour::plain : colour) +
         text.substr(head);
}

void print(const Diagnostic& diagnostic) {
  write_message(coloured_text(diagnostic, Terminal(STDERR_FILENO)));
}

int exit_code_of(const Diagnostic& diagnostic) {
  constexpr int program_error = 6;
  constexpr int machine_fault = 7;
  if (diagnostic.severity != Severity::error) return 0;
  return diagnostic.code.starts_with('A') ? machine_fault : program_error;
}

}  // namespace stanok::client
