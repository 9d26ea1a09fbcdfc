#include "recording/log/printed_file.h"

#include <algorithm>

#include "recording/log/bounded_text.h"

namespace stanok::recording {
namespace {

constexpr std::string_view printed_opening = "printed ";

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

}  // namespace

std::optional<std::string> printed_line_of(std::string_view text) {
  if (!text.starts_with(printed_opening)) return std::nullopt;
  std::string line(text.substr(printed_opening.size()));
  std::ranges::replace_if(line, is_control, ' ');
  return line;
}

void PrintedFile::take(const channels::Event& event) {
  if (!event.code.view().empty()) return;
  const auto line = printed_line_of(event.text.view());
  if (!line) return;
  error_ = append_line({file_, {}, size_max_bytes_}, *line + "\n");
}

}  // namespace stanok::recording
