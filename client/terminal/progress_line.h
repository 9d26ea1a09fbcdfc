// One line on standard error that goes away before anything else is printed; nothing where that is
// no terminal, or one that cannot erase.
#pragma once

#include <unistd.h>

#include <string>

#include "client/terminal/output.h"
#include "client/terminal/screen_text.h"
#include "client/terminal/terminal.h"

namespace stanok::client {

// What to print so that the text stands on the current line, cut to a terminal of so many columns.
// ECMA-48 EL: erase to the end of the line.
[[nodiscard]] std::string progress_text(const std::string& text, std::size_t columns);

// Columns for a bar whose line is cut to the terminal afterwards.
inline constexpr std::size_t bar_columns = 79;

// "[=====>    ]  12 of 40  flange.nc", for a terminal of that many columns.
[[nodiscard]] std::string progress_bar(std::size_t done, std::size_t all, const std::string& file,
                                       std::size_t columns);

class ProgressLine {
 public:
  [[nodiscard]] bool is_wanted() const { return terminal_.is_terminal(); }
  void show(const std::string& text) {
    if (!is_wanted()) return;
    write_message_with_orders(progress_text(text, terminal_.size().columns));
    is_shown_ = true;
  }
  void clear() {
    if (is_shown_) write_message_with_orders("\r\033[K");
    is_shown_ = false;
  }

 private:
  Terminal terminal_{STDERR_FILENO};
  bool is_shown_ = false;
};

}  // namespace stanok::client
