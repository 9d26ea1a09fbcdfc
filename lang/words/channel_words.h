// Which words of a program are axes of the channel, looked up once per channel.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/words/block_words.h"
#include "lang/words/channel_dialect.h"

namespace stanok::lang {

class ChannelWords {
 public:
  explicit ChannelWords(const ChannelDescription& channel);

  [[nodiscard]] const ChannelDescription& channel() const { return channel_; }
  // Letters that are axis words here.
  [[nodiscard]] LetterSet letters() const { return letters_; }
  // Axis of a letter that is one, by index of the channel.
  [[nodiscard]] std::size_t axis(int letter_at) const {
    return axis_[static_cast<std::size_t>(letter_at)];
  }
  // U, V and W where they stand for incremental X, Y and Z: on lathe channels without such axes.
  [[nodiscard]] LetterSet incremental_letters() const { return incremental_letters_; }
  // Axis called `name` (any case), or -1.
  [[nodiscard]] int axis_called(std::string_view name) const;
  // Axis that is the channel's X, Y or Z (0, 1, 2), or -1.
  [[nodiscard]] int geometry_axis(std::size_t coordinate) const { return geometry_[coordinate]; }
  [[nodiscard]] const std::array<int, 3>& geometry() const { return geometry_; }
  [[nodiscard]] AxisSet linear_axes() const { return linear_; }
  // Axes that are spindles until M902.
  [[nodiscard]] AxisSet spindle_axes() const { return spindle_axes_; }
  [[nodiscard]] const ChannelDialect& dialect() const { return dialect_; }

 private:
  const ChannelDescription& channel_;
  LetterSet letters_ = 0;
  LetterSet incremental_letters_ = 0;
  std::array<std::size_t, 26> axis_{};
  std::array<int, 3> geometry_{-1, -1, -1};
  AxisSet linear_ = 0;
  AxisSet spindle_axes_ = 0;
  ChannelDialect dialect_;
};

// Letters that name axes on some machine: what is not one here deserves a clearer answer than
// "unused word".
inline constexpr LetterSet customary_axis_letters = letters_of("ABCUVWXYZ");

}  // namespace stanok::lang
