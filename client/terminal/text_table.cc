#include "client/terminal/text_table.h"

#include <algorithm>
#include <cctype>

#include "client/terminal/screen_text.h"

namespace stanok::client {
namespace {

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("+-.0123456789e") == std::string::npos &&
         std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string padded(const std::string& cell, std::size_t columns) {
  const std::string blanks(columns - std::min(columns, screen_columns(cell)), ' ');
  return is_number(cell) ? blanks + cell : cell + blanks;
}

}  // namespace

TextTable::TextTable(std::vector<std::string> headings) {
  rows_.push_back(std::move(headings));
}

void TextTable::add_row(std::vector<std::string> cells) {
  for (std::string& cell : cells) cell = one_line(cell);
  cells.resize(rows_.front().size());
  rows_.push_back(std::move(cells));
}

std::string TextTable::text(const Terminal& terminal) const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t k = 0; k < row.size(); ++k)
      widths[k] = std::max(widths[k], screen_columns(row[k]));
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line +=
          (k == 0 ? "" : "  ") + terminal.coloured(padded(row[k], widths[k]), state_colour(row[k]));
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += (&row == &rows_.front() ? terminal.coloured(line, Colour::bold) : line) + "\n";
  }
  return text;
}

}  // namespace stanok::client
