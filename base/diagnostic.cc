#include "base/diagnostic.h"

#include <algorithm>

#include "base/utf8.h"

namespace stanok {
namespace {

const char* word_for(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
  }
  return "";
}

// Column 0: the line as a whole.
std::string place_text(const Place& place) {
  std::string text = place.file + ":" + std::to_string(place.line);
  if (place.column > 0) text += ":" + std::to_string(place.column);
  return text;
}

// As long as what stands before the column. Tabs are kept so that the caret stands under its word
// whatever the tab width.
std::string padding(std::string_view source_line, int column) {
  std::string text;
  for (const char c : source_line) {
    if (std::ssize(text) >= column - 1) break;
    if (!continues_character(c)) text += c == '\t' ? '\t' : ' ';
  }
  while (std::ssize(text) < column - 1) text += ' ';
  return text;
}

std::string characters_of(std::string_view text, std::size_t first, std::size_t count) {
  const std::string_view rest = text.substr(offset_of_character(text, first));
  return std::string(rest.substr(0, offset_of_character(rest, count)));
}

// What is shown of a line: all of it, or of a very long one the part around the column. Counted in
// characters, as columns are.
struct Excerpt {
  std::string text;
  int column = 1;  // in the text
};

Excerpt excerpt_of(const std::string& line, int column) {
  constexpr std::size_t shown_whole = 300;
  constexpr std::size_t shown_before = 80;
  constexpr std::size_t shown = 160;
  const std::size_t length = character_count(line);
  if (length <= shown_whole) return {line, column};
  const std::size_t place = std::min(padding(line, column).size(), length);
  const std::size_t begin = place - std::min(place, shown_before);
  const std::string before = begin > 0 ? "..." : "";
  const std::string behind = begin + shown < length ? "..." : "";
  return {before + characters_of(line, begin, shown) + behind,
          static_cast<int>(before.size() + place - begin) + 1};
}

void append_picture(std::string& text, const Diagnostic& d) {
  const Excerpt line = excerpt_of(d.source_line, d.place.column);
  const std::string number = std::to_string(d.place.line);
  const std::string gutter(number.size(), ' ');
  int width = d.place.end_line == d.place.line ? d.place.end_column - d.place.column : 1;
  if (line.text.size() != d.source_line.size())
    width = std::min(width, static_cast<int>(character_count(line.text)) - line.column + 1);
  text += gutter + " |\n" + number + " | " + line.text + "\n" + gutter + " | ";
  text += padding(line.text, line.column);
  for (int k = 0; k < std::max(width, 1); ++k) text += '^';
  if (!d.label.empty()) text += " " + d.label;
  text += "\n" + gutter + " |\n";
}

}  // namespace

bool has_errors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string to_text(const Diagnostic& d) {
  std::string text = std::string(word_for(d.severity)) + "[" + d.code + "]: " + d.message + "\n";
  if (d.place.line > 0) {
    text += "  --> " + place_text(d.place) + "\n";
    if (!d.source_line.empty()) append_picture(text, d);
  } else if (!d.place.file.empty()) {
    text += "  --> " + d.place.file + "\n";
  }
  for (const Note& note : d.notes) {
    text += " note: " + note.text;
    if (note.place.line > 0) text += " (" + place_text(note.place) + ")";
    text += "\n";
  }
  for (const std::string& help : d.help) text += " help: " + help + "\n";
  for (const std::string& frame : d.stack) text += "   " + frame + "\n";
  return text;
}

}  // namespace stanok
