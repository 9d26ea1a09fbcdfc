#include "client/terminal/progress_line.h"

#include <fmt/format.h>

#include "base/utf8.h"

namespace stanok::client {

std::string progress_text(const std::string& text, std::size_t columns) {
  return "\r\033[K" + cut_to_columns(one_line(text), columns > 1 ? columns - 1 : 1);
}

std::string progress_bar(std::size_t done, std::size_t all, const std::string& file,
                         std::size_t columns) {
  constexpr std::size_t bar_width = 20;
  const std::size_t filled = all == 0 ? bar_width : bar_width * done / all;
  const std::string bar = std::string(filled, '=') + std::string(bar_width - filled, ' ');
  std::string text = fmt::format("[{}]  {} of {}  ", bar, done, all);
  const std::size_t room = columns > text.size() ? columns - text.size() : 0;
  if (screen_columns(file) <= room) return text + file;
  constexpr std::string_view cut = "...";
  if (room <= cut.size()) return text;
  // The end of a path says more than its beginning; a cut character is no character.
  std::string end = file.substr(file.size() - (room - cut.size()));
  while (!end.empty() && continues_character(end.front())) end.erase(0, 1);
  return text + std::string(cut) + end;
}

}  // namespace stanok::client
