// PictureInPlace: a text of several lines that is drawn again and again at the same place of a
// terminal, below everything that was told before.
//
// A line never leaves the width of the terminal, and the whole never its height, so that the way
// back to its first line is known: what a terminal wraps or scrolls by itself would stay behind.
// Escape sequences of ECMA-48: CPL (up, to the begin of a line), EL (erase to its end), ED (erase
// below).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/terminal/terminal.h"

namespace stanok::client {

class PictureInPlace {
 public:
  explicit PictureInPlace(const Terminal& terminal) : terminal_(terminal) {}

  // What to print so that the picture stands there instead of the one before.
  [[nodiscard]] std::string drawn(std::string_view picture);
  // What to print so that the text stands above the picture, and stays.
  [[nodiscard]] std::string told_above(std::string_view text);

 private:
  [[nodiscard]] std::string way_back() const;

  Terminal terminal_;
  std::vector<std::string> lines_;  // as they were printed
};

}  // namespace stanok::client
