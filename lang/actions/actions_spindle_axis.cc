// Actions of spindles that are axes for a while: M902, M903.
//
// The machine file says which axis a spindle becomes. Until M902 that axis cannot be programmed;
// from M902 to M903 the spindle cannot. Both codes are sync points: the channel stops the spindle,
// closes or opens its position loop and answers where the axis stands.
#include <algorithm>

#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr std::string_view word_of_spindle = "H1";
constexpr std::string_view word_of_axis = "H2";

std::string axis_text(const ActiveBlock& block, AxisIndex axis) {
  return "axis `" + block.channel.axes[axis].word + "`";
}

const NamedWord* find_named_word(const ActiveBlock& block, std::string_view name) {
  const auto found = std::ranges::find(block.words.named, name, &NamedWord::name);
  return found == block.words.named.end() ? nullptr : &*found;
}

// The spindle that H1 names; 0: there is no H1. Nothing, and a fault, for one that does not exist.
std::optional<int> spindle_in_block(ActiveBlock& block) {
  const NamedWord* const word = find_named_word(block, word_of_spindle);
  if (word == nullptr) return 0;
  const auto& known = block.channel.spindles;
  const bool exists =
      std::ranges::any_of(known, [&](int id) { return static_cast<double>(id) == word->value; });
  if (exists) return static_cast<int>(word->value);
  block.fail("E4053", {0, -1, word->name}, "the channel has no such spindle", "unknown spindle");
  return std::nullopt;
}

// The axis that a spindle of the channel becomes, or nothing.
std::optional<AxisIndex> axis_of_spindle(const ActiveBlock& block, int spindle) {
  for (std::size_t i = 0; spindle != 0 && i < block.channel.axes.size(); ++i) {
    if (block.channel.axes[i].spindle == spindle) return i;
  }
  return std::nullopt;
}

bool is_converted(const ActiveBlock& block, AxisIndex axis) {
  return (block.modal.spindles.converted_axes & axis_bit(axis)) != 0;
}

// H2 counts the axes that the machine file gives the spindle; it gives one.
bool names_its_axis(ActiveBlock& block) {
  const NamedWord* const word = find_named_word(block, word_of_axis);
  if (word == nullptr || word->value == 1.0) return true;
  block.fail("E4008", {0, -1, word->name}, "`H2` counts the axes of the spindle, and it has one",
             "out of range");
  return false;
}

bool excludes_conversion(ActiveBlock& block, CodeNumber code) {
  return excluded_by_mode(block, code, {Exclusion::transformation}, 'M');
}

void give_back(ActiveBlock& block, AxisIndex axis) {
  block.modal.spindles.converted_axes =
      static_cast<AxisSet>(block.modal.spindles.converted_axes & ~axis_bit(axis));
  ProgramRequest request;
  request.kind = RequestKind::axis_to_spindle;
  request.number = block.channel.axes[axis].spindle;
  block.queue.emit(request);
  block.awaits_position = true;
}

}  // namespace

bool is_word_of_spindle_axis(const BlockCodes& codes, const NamedWord& word) {
  const auto taken_by = [&](CodeAction action) {
    return std::any_of(codes.begin(), codes.end(),
                       [&](const Code* row) { return row->action == action; });
  };
  const bool to_axis = taken_by(CodeAction::make_axis_of_spindle);
  if (word.name == word_of_axis) return to_axis;
  return word.name == word_of_spindle && (to_axis || taken_by(CodeAction::make_spindle_of_axis));
}

bool is_spindle_now(const ActiveBlock& block, AxisIndex axis) {
  return block.channel.axes[axis].spindle != 0 && !is_converted(block, axis);
}

void refuse_axis_that_is_spindle(ActiveBlock& block, AxisIndex axis) {
  const std::string spindle = std::to_string(block.channel.axes[axis].spindle);
  block
      .fail("E4055", {block.channel.axes[axis].word.front(), -1, {}},
            axis_text(block, axis) + " is spindle " + spindle + " now", "a spindle")
      .help.push_back("make it an axis in an earlier block: `M902 H1=" + spindle + "`");
}

void refuse_axes_that_are_spindles(ActiveBlock& block) {
  const AxisSet candidates = block.programmed & block.channel_words.spindle_axes();
  for (std::size_t axis = 0; candidates >> axis != 0; ++axis) {
    if ((candidates & axis_bit(axis)) == 0 || !is_spindle_now(block, axis)) continue;
    return refuse_axis_that_is_spindle(block, axis);
  }
}

bool refuse_spindle_that_is_axis(ActiveBlock& block, int spindle, const WordName& word) {
  const auto& known = block.channel.spindles;
  for (const int id : known) {
    const bool is_meant = spindle == -1 || spindle == id || (spindle == 0 && id == known.front());
    const auto axis = axis_of_spindle(block, id);
    if (!is_meant || !axis || !is_converted(block, *axis)) continue;
    block
        .fail("E4056", word,
              "spindle " + std::to_string(id) + " is " + axis_text(block, *axis) + " now",
              "an axis")
        .help.push_back("make it a spindle again first: `M903 H1=" + std::to_string(id) + "`");
    return true;
  }
  return false;
}

void make_axis_of_spindle(ActiveBlock& block, CodeNumber code) {
  const auto named = spindle_in_block(block);
  if (!named || !names_its_axis(block) || excludes_conversion(block, code)) return;
  const auto& known = block.channel.spindles;
  const int spindle = *named != 0 || known.empty() ? *named : known.front();
  const auto axis = axis_of_spindle(block, spindle);
  if (!axis) {
    block
        .fail("E4057", {'M', code, {}},
              spindle == 0 ? "the channel has no spindle"
                           : "spindle " + std::to_string(spindle) + " cannot become an axis",
              "no axis")
        .help.emplace_back("name the axis in the machine file: `axis` in the [[spindle]] section");
    return;
  }
  if (is_converted(block, *axis)) return;
  if (spindle_turns(block, spindle)) turn_spindle(block, spindle, SpindleAction::stop);
  block.modal.spindles.converted_axes =
      static_cast<AxisSet>(block.modal.spindles.converted_axes | axis_bit(*axis));
  ProgramRequest request;
  request.kind = RequestKind::spindle_to_axis;
  request.number = spindle;
  block.queue.emit(request);
  block.awaits_position = true;
}

void make_spindle_of_axis(ActiveBlock& block, CodeNumber code) {
  const auto named = spindle_in_block(block);
  if (!named || excludes_conversion(block, code)) return;
  bool any = false;
  for (std::size_t axis = 0; axis < block.channel.axes.size(); ++axis) {
    const bool is_meant = *named == 0 || block.channel.axes[axis].spindle == *named;
    if (!is_meant || !is_converted(block, axis)) continue;
    give_back(block, axis);
    any = true;
  }
  if (any) return;
  const std::string which =
      *named == 0 ? "no spindle of the channel" : "spindle " + std::to_string(*named);
  block.queue.emit(Message{"M903: " + which + (*named == 0 ? " is an axis" : " is not an axis"),
                           Message::Kind::warning});
}

}  // namespace stanok::lang
