#include "client/terminal/picture_in_place.h"

#include <algorithm>

#include "client/terminal/screen_text.h"

namespace stanok::client {
namespace {

constexpr std::string_view erase_line = "\033[K";
constexpr std::string_view erase_below = "\033[J";

// The last column stays free: some terminals go to the next line when it is written.
std::size_t usable_columns(const TerminalSize& size) {
  return size.columns > 1 ? size.columns - 1 : 1;
}

std::string printed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text.append(line).append(erase_line).append("\n");
  return text;
}

}  // namespace

std::string PictureInPlace::drawn(std::string_view picture) {
  const TerminalSize size = terminal_.size();
  std::string text = way_back();
  lines_ = broken_lines(picture, usable_columns(size));
  const std::size_t lines_max = size.lines > 2 ? size.lines - 1 : 1;  // the cursor stands below
  if (lines_.size() > lines_max) {
    const std::size_t more = lines_.size() - lines_max + 1;
    lines_.resize(lines_max);
    lines_.back() = cut_to_columns("(" + std::to_string(more) + " more lines: enlarge the window)",
                                   usable_columns(size));
  }
  return text.append(printed(lines_)).append(erase_below);
}

std::string PictureInPlace::told_above(std::string_view told) {
  std::string text = way_back();
  text.append(printed(broken_lines(told, usable_columns(terminal_.size()))));
  return text.append(printed(lines_)).append(erase_below);
}

// A terminal that was made narrower has wrapped what stands there.
std::string PictureInPlace::way_back() const {
  const std::size_t columns = std::max<std::size_t>(1, terminal_.size().columns);
  std::size_t rows = 0;
  for (const std::string& line : lines_)
    rows += std::max<std::size_t>(1, (screen_columns(line) + columns - 1) / columns);
  return rows == 0 ? "" : "\033[" + std::to_string(rows) + "F";
}

}  // namespace stanok::client
