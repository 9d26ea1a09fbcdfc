// What the standard streams are connected to, and colours for those that can show them.
//
// Colours only on a terminal, and never with NO_COLOR set (no-color.org) or TERM=dumb.
#pragma once

#include <string>
#include <string_view>

namespace stanok::client {

enum class Colour { plain, red, green, yellow, bold };

class Terminal {
 public:
  // For the file descriptor of a standard stream.
  explicit Terminal(int descriptor);
  Terminal(bool is_terminal, bool has_colour)
      : is_terminal_(is_terminal), has_colour_(has_colour) {}

  [[nodiscard]] bool is_terminal() const { return is_terminal_; }
  // The text, wrapped in the colour's escape sequence where that is shown.
  [[nodiscard]] std::string coloured(std::string_view text, Colour colour) const;

 private:
  bool is_terminal_;
  bool has_colour_;
};

}  // namespace stanok::client
