#include "protocol/contract/frame_reader.h"

#include <algorithm>

namespace stanok::protocol {
namespace {

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

void FrameReader::append(std::string_view bytes) {
  buffer_.erase(0, begin_);
  searched_ -= begin_;
  begin_ = 0;
  buffer_ += bytes;
}

std::optional<TextFrame> FrameReader::next() {
  while (true) {
    auto frame = cut_line();
    if (!frame || frame->kind == FrameKind::oversize || !is_blank(frame->text)) return frame;
  }
}

std::optional<TextFrame> FrameReader::cut_line() {
  const std::size_t end = buffer_.find('\n', std::max(begin_, searched_));
  if (end == std::string::npos) {
    searched_ = buffer_.size();
    if (!discarding_ && buffer_.size() - begin_ <= bytes_max_) return std::nullopt;
    const bool is_first = !discarding_;
    discarding_ = true;
    begin_ = buffer_.size();
    return is_first ? std::optional<TextFrame>({FrameKind::oversize, {}}) : std::nullopt;
  }
  const std::string_view line(buffer_.data() + begin_, end - begin_);
  const bool was_discarding = discarding_;
  const bool is_oversize = line.size() > bytes_max_;
  TextFrame frame{is_oversize ? FrameKind::oversize : FrameKind::text,
                  is_oversize ? std::string() : std::string(line)};
  discarding_ = false;
  begin_ = searched_ = end + 1;
  return was_discarding ? cut_line() : std::optional<TextFrame>(std::move(frame));
}

}  // namespace stanok::protocol
