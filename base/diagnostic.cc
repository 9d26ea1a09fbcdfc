#include "base/diagnostic.h"

#include <algorithm>

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

// Tabs are kept in the padding so that the caret stands under its word whatever the tab width.
std::string padding(const std::string& source_line, int column) {
  std::string text;
  for (int i = 0; i + 1 < column; ++i) {
    const auto index = static_cast<std::size_t>(i);
    text += index < source_line.size() && source_line[index] == '\t' ? '\t' : ' ';
  }
  return text;
}

// What is shown of a line: all of it, or of a very long one the part around the column.
struct Excerpt {
  std::string text;
  int column = 1;  // in the text
};

Excerpt excerpt_of(const std::string& line, int column) {
  constexpr std::size_t shown_whole = 300;
  constexpr std::size_t shown_before = 80;
  constexpr std::size_t shown = 160;
  if (line.size() <= shown_whole) return {line, column};
  const auto place = std::min(static_cast<std::size_t>(std::max(column - 1, 0)), line.size());
  const std::size_t begin = place - std::min(place, shown_before);
  const std::string before = begin > 0 ? "..." : "";
  const std::string behind = begin + shown < line.size() ? "..." : "";
  return {before + line.substr(begin, shown) + behind,
          static_cast<int>(before.size() + place - begin) + 1};
}

void append_picture(std::string& text, const Diagnostic& d) {
  const Excerpt line = excerpt_of(d.source_line, d.place.column);
  const std::string number = std::to_string(d.place.line);
  const std::string gutter(number.size(), ' ');
  int width = d.place.end_line == d.place.line ? d.place.end_column - d.place.column : 1;
  if (line.text.size() != d.source_line.size())
    width = std::min(width, static_cast<int>(line.text.size()) - line.column + 1);
  text += gutter + " |\n" + number + " | " + line.text + "\n" + gutter + " | ";
  text += padding(line.text, line.column);
  text += std::string(static_cast<std::size_t>(std::max(width, 1)), '^') + " " + d.label + "\n";
  text += gutter + " |\n";
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
