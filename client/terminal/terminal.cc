#include "client/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace stanok::client {
namespace {

// Select Graphic Rendition, ECMA-48 8.3.117.
std::string_view escape_of(Colour colour) {
  switch (colour) {
    case Colour::plain:
      return "";
    case Colour::red:
      return "\033[31m";
    case Colour::green:
      return "\033[32m";
    case Colour::yellow:
      return "\033[33m";
    case Colour::bold:
      return "\033[1m";
  }
  return "";
}

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? std::string_view{} : std::string_view(value);
}

Screen screen_at(int descriptor) {
  if (isatty(descriptor) != 1) return Screen::none;
  const bool shows_colours = variable("NO_COLOR").empty() && variable("TERM") != "dumb";
  return shows_colours ? Screen::coloured : Screen::monochrome;
}

}  // namespace

Terminal::Terminal(int descriptor) : descriptor_(descriptor), screen_(screen_at(descriptor)) {}

TerminalSize Terminal::size() const {
  winsize window{};
  const bool is_known =
      descriptor_ >= 0 && ioctl(descriptor_, TIOCGWINSZ, &window) == 0 && window.ws_col > 0;
  if (!is_known) return size_;
  return {window.ws_col, window.ws_row > 0 ? window.ws_row : size_.lines};
}

std::string Terminal::coloured(std::string_view text, Colour colour) const {
  if (screen_ != Screen::coloured || colour == Colour::plain) return std::string(text);
  return std::string(escape_of(colour)) + std::string(text) + "\033[0m";
}

Colour state_colour(std::string_view state) {
  if (state == "Active") return Colour::green;
  if (state == "Interrupted") return Colour::yellow;
  return Colour::plain;
}

}  // namespace stanok::client
