#include "client/terminal/diagnostic_output.h"

#include <unistd.h>

#include "client/terminal/output.h"
#include "client/terminal/screen_text.h"
#include "protocol/contract/diagnostic_json.h"

namespace stanok::client {

nlohmann::ordered_json to_json(const Diagnostic& diagnostic) {
  return protocol::diagnostic_json(diagnostic);
}

std::string coloured_text(const Diagnostic& diagnostic, const Terminal& terminal) {
  const std::string text = visible(to_text(diagnostic));
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
