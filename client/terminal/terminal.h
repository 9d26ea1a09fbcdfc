// What the standard streams are connected to, how large it is, and colours for those that can show
// them.
//
// Colours only on a terminal, and never with NO_COLOR set (no-color.org) or TERM=dumb.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stanok::client {

enum class Colour { plain, red, green, yellow, bold };

// What a stream is connected to. None: a file or a pipe.
enum class Screen { none, monochrome, coloured };

struct TerminalSize {
  std::size_t columns = 80;
  std::size_t lines = 24;
};

class Terminal {
 public:
  // For the file descriptor of a standard stream.
  explicit Terminal(int descriptor);
  explicit Terminal(Screen screen, TerminalSize size = {}) : screen_(screen), size_(size) {}

  [[nodiscard]] bool is_terminal() const { return screen_ != Screen::none; }
  // Tells the size of now: a window may be made larger or smaller at any time. 80 x 24 where it is
  // not known.
  [[nodiscard]] TerminalSize size() const;
  // The text, wrapped in the colour's escape sequence where that is shown.
  [[nodiscard]] std::string coloured(std::string_view text, Colour colour) const;
  // Where the next of its colours begins in a text, or its end; and how long the one that the text
  // begins with is, or 0.
  [[nodiscard]] std::size_t next_colour(std::string_view text) const;
  [[nodiscard]] std::size_t colour_length(std::string_view text) const;

 private:
  int descriptor_ = -1;  // -1: none, the size is fixed
  Screen screen_;
  TerminalSize size_;
};

// Colour that a channel's state is shown in.
[[nodiscard]] Colour state_colour(std::string_view state);

}  // namespace stanok::client
