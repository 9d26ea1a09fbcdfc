#include "lang/block/axis_words.h"

namespace stanok::lang {
namespace {

// Takes the value of an axis word, in mm and deg. False when the axis has one already.
bool take_axis_value(ActiveBlock& block, AxisIndex axis, double value) {
  const AxisDescription& description = block.channel.axes[axis];
  if (is_length(block, axis)) value *= block.length_unit();
  if (block.modal.diameters() && description.geometry == 0) value *= 0.5;
  const bool first = (block.programmed & axis_bit(axis)) == 0;
  block.programmed = static_cast<AxisSet>(block.programmed | axis_bit(axis));
  block.values[axis] = value;
  return first;
}

}  // namespace

PlaneAxes plane_axes(const ActiveBlock& block) {
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  return {block.channel_words.geometry_axis(plane.first),
          block.channel_words.geometry_axis(plane.second)};
}

bool is_length(const ActiveBlock& block, AxisIndex axis) {
  return !block.channel.axes[axis].rotary || block.modal.face_axis() == axis;
}

void collect_incremental_words(ActiveBlock& block, const BlockCodes& codes) {
  const LetterSet letters =
      block.words.letters & block.channel_words.incremental_letters() & ~codes.words;
  for (const char letter : {'U', 'V', 'W'}) {
    if ((letters & letter_bit(letter)) == 0 || block.dwell_word == letter) continue;
    const AxisIndex axis = block.channel_words.axis(letter);
    if (!take_axis_value(block, axis, block.value(letter))) {
      block.fail("E4001", {letter, -1, {}},
                 "axis `" + block.channel.axes[axis].word + "` is programmed twice",
                 "the same axis, incremental");
    }
    block.incremental = static_cast<AxisSet>(block.incremental | axis_bit(axis));
  }
}

void collect_axis_words(ActiveBlock& block) {
  LetterSet letters = block.words.letters & block.channel_words.letters();
  if (block.dwell_word != 0) letters &= ~letter_bit(block.dwell_word);
  for (char letter = 'A'; letters != 0; ++letter, letters >>= 1) {
    if ((letters & 1U) == 0) continue;
    const double value = block.value(letter);
    static_cast<void>(take_axis_value(block, block.channel_words.axis(letter), value));
  }
  for (const NamedWord& word : block.words.named) {
    const AxisIndex axis = block.channel_words.axis_called(word.name);
    if (axis.exists()) static_cast<void>(take_axis_value(block, axis, word.value));
  }
}

}  // namespace stanok::lang
