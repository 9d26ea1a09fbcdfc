// FrameReader: cuts a byte stream into frames, one JSON text per line.
//
// A line longer than the limit is never stored: its bytes are thrown away as they come and one
// frame `FrameKind::oversize` stands for it, so that the connection can go on behind it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stanok::protocol {

inline constexpr std::size_t frame_bytes_max = 1U << 20;  // 1 MiB without the line end

enum class FrameKind : std::uint8_t { text, oversize };

struct TextFrame {
  FrameKind kind = FrameKind::text;
  std::string text;  // without the line end; empty for oversize
};

class FrameReader {
 public:
  explicit FrameReader(std::size_t bytes_max = frame_bytes_max) : bytes_max_(bytes_max) {}

  void append(std::string_view bytes);

  // The next complete frame. Blank lines are no frames.
  [[nodiscard]] std::optional<TextFrame> next();

  // Whether the beginning of a frame waits for its end.
  [[nodiscard]] bool is_within_frame() const { return discarding_ || begin_ < buffer_.size(); }

 private:
  [[nodiscard]] std::optional<TextFrame> cut_line();

  std::size_t bytes_max_;
  std::string buffer_;
  std::size_t begin_ = 0;     // of the first byte not yet given out
  std::size_t searched_ = 0;  // no line end before this byte
  bool discarding_ = false;   // within a line that is too long
};

}  // namespace stanok::protocol
