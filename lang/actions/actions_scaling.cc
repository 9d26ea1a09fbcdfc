// Actions of scaling and mirror: G50, G51, G50.1, G51.1. They change what the words of later blocks
// mean (lang/block/coordinate_map.h), not where the axes stand. A negative factor mirrors about the
// centre (Fanuc B-64304EN-2, 7.7, "mirror image").
#include "lang/actions/actions.h"
#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

constexpr std::array factor_words{'I', 'J', 'K'};

AxisSet geometry_set(const ModalState& modal) {
  AxisSet set = 0;
  for (const AxisIndex axis : modal.geometry) set = static_cast<AxisSet>(set | axis_bit(axis));
  return set;
}

bool check_factor_words(ActiveBlock& block) {
  const bool each = block.has('I') || block.has('J') || block.has('K');
  if (!each && !block.has('P')) {
    block.fail("E4007", {'G', g(51), {}}, "`G51` needs P, or I J K, the factors", "no factor");
    return false;
  }
  if (each && block.has('P')) {
    block.fail("E4304", {'P', -1, {}}, "`G51` has one factor P or one each in I J K, not both",
               "both are given");
    return false;
  }
  for (const char letter : {'P', 'I', 'J', 'K'}) {
    if (!block.has(letter) || block.value(letter) != 0.0) continue;
    block.fail("E4008", {letter, -1, {}}, "a scale factor of 0 leaves nothing", "is 0");
    return false;
  }
  constexpr double factor_max = 100.0;
  for (const char letter : {'P', 'I', 'J', 'K'})
    refuse_thousandths(block, letter, factor_max, "a scale factor");
  return !block.failed();
}

}  // namespace

bool only_axes(ActiveBlock& block, CodeNumber code, AxisSet allowed) {
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if ((block.programmed & ~allowed & axis_bit(i)) == 0) continue;
    const std::string& word = block.channel.axes[i].word;
    WordName name{0, -1, word};
    if (word.size() == 1) name = {word[0], -1, {}};
    block.fail("E4302", name, "`" + code_text('G', code) + "` cannot take the axis `" + word + "`",
               "not here");
    return false;
  }
  return true;
}

void scale_axes(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation})) return;
  if (!check_factor_words(block) || !only_axes(block, code, geometry_set(block.modal))) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool named = block.has(factor_words[k]);
    const AxisIndex axis = block.modal.geometry[k];
    if (!axis.exists()) {
      if (!named) continue;
      block.fail("E4306", {factor_words[k], -1, {}},
                 std::string("this channel has no ") + "XYZ"[k] + " to scale", "");
      return;
    }
    const bool centred = is_programmed(block, axis);
    const double centre = centred ? block.values[axis] : block.modal.programmed_position(axis);
    const double each = named ? value_or_thousandths(block, factor_words[k]) : 1.0;
    block.modal.map.scale(axis, centre, block.has('P') ? value_or_thousandths(block, 'P') : each);
  }
}

// G50 S on a lathe channel limits the speed of G96 and leaves the scale as it is.
void cancel_scaling(ActiveBlock& block, CodeNumber code) {
  if (block.has('S')) {
    block.kept_groups |= group_bit(Group::scaling);
    return limit_speed(block);
  }
  if (block.modal.code(Group::scaling) == code) return;
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation})) return;
  block.modal.map.cancel_scaling();
}

void mirror_axes(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation})) return;
  if (!only_axes(block, code, geometry_set(block.modal))) return;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if ((block.programmed & axis_bit(i)) != 0) block.modal.map.mirror(i, block.values[i]);
  }
}

// Of the axes named, of all without axis words.
void cancel_mirror(ActiveBlock& block, CodeNumber code) {
  if (block.modal.code(Group::mirror) == code) return;
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation})) return;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    const bool named = (block.programmed & axis_bit(i)) != 0;
    if (named || block.programmed == 0) block.modal.map.cancel_mirror(i);
  }
  if (block.modal.map.any_mirror()) block.kept_groups |= group_bit(Group::mirror);
}

}  // namespace stanok::lang
