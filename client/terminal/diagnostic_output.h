// Diagnostics for people (stderr, with colour on a terminal) and for programs (JSON of `stanok
// check`).
#pragma once

#include <nlohmann/json.hpp>

#include "base/diagnostic.h"
#include "client/terminal/terminal.h"

namespace stanok::client {

[[nodiscard]] nlohmann::ordered_json to_json(const Diagnostic& diagnostic);
void print(const Diagnostic& diagnostic);
// The same as text: severity and code in colour, where the terminal shows it.
[[nodiscard]] std::string coloured_text(const Diagnostic& diagnostic, const Terminal& terminal);

// Exit code that a code of the catalogue leads to: 6 program (E, U), 7 machine (A), 0 warning.
[[nodiscard]] int exit_code_of(const Diagnostic& diagnostic);

}  // namespace stanok::client
