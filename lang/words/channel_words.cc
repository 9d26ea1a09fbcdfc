#include "lang/words/channel_words.h"

#include <utility>

#include "lang/text/source.h"

namespace stanok::lang {

ChannelWords::ChannelWords(const ChannelDescription& channel)
    : channel_(channel), dialect_(&channel) {
  for (std::size_t i = 0; i < channel.axes.size(); ++i) {
    const AxisDescription& axis = channel.axes[i];
    if (!axis.rotary) linear_ = static_cast<AxisSet>(linear_ | axis_bit(i));
    if (axis.spindle != 0) spindle_axes_ = static_cast<AxisSet>(spindle_axes_ | axis_bit(i));
    if (axis.geometry >= 0 && axis.geometry < 3) {
      geometry_[AxisIndex(axis.geometry).place()] = i;
    }
    if (axis.word.size() != 1 || !is_letter(axis.word[0])) continue;
    const char letter = upper_case(axis.word[0]);
    letters_ |= letter_bit(letter);
    axis_[letter] = i;
  }
  if (channel.kind != ChannelKind::lathe) return;
  for (std::size_t k = 0; k < geometry_.size(); ++k) {
    const char letter = "UVW"[k];
    if (!geometry_[k].exists() || (letters_ & letter_bit(letter)) != 0) continue;
    incremental_letters_ |= letter_bit(letter);
    axis_[letter] = geometry_[k];
  }
}

AxisIndex ChannelWords::axis_called(std::string_view name) const {
  const std::string wanted = folded(name);
  for (std::size_t i = 0; i < channel_.axes.size(); ++i) {
    if (folded(channel_.axes[i].word) == wanted) return i;
  }
  return {};
}

std::optional<ChannelWords> words_of_channel(const ChannelDescription* channel) {
  return channel != nullptr ? std::optional<ChannelWords>(std::in_place, *channel) : std::nullopt;
}

}  // namespace stanok::lang
