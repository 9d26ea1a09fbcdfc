// Which words of a program are axes of the channel, looked up once per channel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/axis_index.h"
#include "base/enum_array.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/words/block_words.h"
#include "lang/words/channel_dialect.h"

namespace stanok::lang {

// Which of X, Y and Z (0, 1, 2) lie in a plane, in the order of its arcs, and which along its tool.
struct PlaneCoordinates {
  std::size_t first = 0;
  std::size_t second = 1;
  std::size_t normal = 2;
};
inline constexpr EnumArray<Plane, PlaneCoordinates> plane_coordinates{
    PlaneCoordinates{0, 1, 2}, PlaneCoordinates{2, 0, 1}, PlaneCoordinates{1, 2, 0}};

class ChannelWords {
 public:
  explicit ChannelWords(const ChannelDescription& channel);

  [[nodiscard]] const ChannelDescription& channel() const { return channel_; }
  // Letters that are axis words here.
  [[nodiscard]] LetterSet letters() const { return letters_; }
  // Axis of a letter that is one.
  [[nodiscard]] AxisIndex axis(char letter) const { return axis_[letter]; }
  // U, V and W where they stand for incremental X, Y and Z: on lathe channels without such axes.
  [[nodiscard]] LetterSet incremental_letters() const { return incremental_letters_; }
  // Axis called `name` (any case), or none.
  [[nodiscard]] AxisIndex axis_called(std::string_view name) const;
  // Axis that is the channel's X, Y or Z (0, 1, 2), or none.
  [[nodiscard]] AxisIndex geometry_axis(std::size_t coordinate) const {
    return geometry_[coordinate];
  }
  [[nodiscard]] const std::array<AxisIndex, 3>& geometry() const { return geometry_; }
  [[nodiscard]] AxisSet linear_axes() const { return linear_; }
  // Axes that are spindles until M902.
  [[nodiscard]] AxisSet spindle_axes() const { return spindle_axes_; }
  [[nodiscard]] const ChannelDialect& dialect() const { return dialect_; }

 private:
  const ChannelDescription& channel_;
  LetterSet letters_ = 0;
  LetterSet incremental_letters_ = 0;
  LetterArray<AxisIndex> axis_{};
  std::array<AxisIndex, 3> geometry_{};
  AxisSet linear_ = 0;
  AxisSet spindle_axes_ = 0;
  ChannelDialect dialect_;
};

// Of the channel; none where there is none.
[[nodiscard]] std::optional<ChannelWords> words_of_channel(const ChannelDescription* channel);

// Letters that name axes on some machine: what is not one here deserves a clearer answer than
// "unused word".
inline constexpr LetterSet customary_axis_letters = letters_of("ABCUVWXYZ");

}  // namespace stanok::lang
