// What is said to a part programmer: an error or warning with its place in the program text and a
// remedy.
//
// Values, never exceptions; a load collects all of them. Text and JSON of `stanok check`, the
// operator protocol and the logs are made from the same fields (docs/reference/language.md,
// "Diagnostics").
#pragma once

#include <string>
#include <vector>

namespace stanok {

// A span of program text, 1-based; columns count characters. line 0: no place in a program.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  int end_line = 0;
  int end_column = 0;  // column after the last character of the span
};

enum class Severity { error, warning, note };

struct Note {
  std::string text;
  Place place;  // line 0 when the note has no place of its own
};

struct Diagnostic {
  std::string code;  // "E4031", a row of base/catalogue.h; "U1006" for terminate
  Severity severity = Severity::error;
  Place place;
  std::string message;      // what is wrong, one line
  std::string label;        // what stands under the caret
  std::vector<Note> notes;  // where the modal state that matters was set, "included here", ...
  std::vector<std::string> help;   // a fix, only if it is certain
  std::vector<std::string> stack;  // "in hole(), called at part.nc:12:3", innermost first
  std::string source_line;         // the text of place.line, for the caret picture; may be empty
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

// The picture for people: code and message, file:line:column, source line, caret and label, notes,
// help.
[[nodiscard]] std::string to_text(const Diagnostic& diagnostic);

}  // namespace stanok
