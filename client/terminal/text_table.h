// TextTable: rows of cells as aligned columns; numbers to the right, texts to the left.
#pragma once

#include <string>
#include <vector>

#include "client/terminal/terminal.h"

namespace stanok::client {

class TextTable {
 public:
  explicit TextTable(std::vector<std::string> headings);

  void add_row(std::vector<std::string> cells);
  // One line per row below the headings; no blanks at the ends of lines.
  [[nodiscard]] std::string text(const Terminal& terminal) const;

 private:
  std::vector<std::vector<std::string>> rows_;  // the first one are the headings
};

}  // namespace stanok::client
