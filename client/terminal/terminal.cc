#include "client/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

constexpr std::string_view end_of_colour = "\033[0m";
constexpr auto colours = std::to_array({Colour::red, Colour::green, Colour::yellow, Colour::bold});

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
  return std::string(escape_of(colour)) + std::string(text) + std::string(end_of_colour);
}

std::size_t Terminal::next_colour(std::string_view text) const {
  std::size_t at = text.find('\033');
  while (at != std::string_view::npos && colour_length(text.substr(at)) == 0)
    at = text.find('\033', at + 1);
  return std::min(at, text.size());
}

std::size_t Terminal::colour_length(std::string_view text) const {
  if (screen_ != Screen::coloured) return 0;
  if (text.starts_with(end_of_colour)) return end_of_colour.size();
  const auto* const found = std::ranges::find_if(
      colours, [&](Colour colour) { return text.starts_with(escape_of(colour)); });
  return found == colours.end() ? 0 : escape_of(*found).size();
}

Colour state_colour(std::string_view state) {
  if (state == "Active") return Colour::green;
  if (state == "Interrupted") return Colour::yellow;
  return Colour::plain;
}

}  // namespace stanok::client
