// Feed laws: S_n, dS, dl and the other addresses of a law.
//
// With axis words in their block they are a law for its motion; without, a modal law that lasts
// until `#feedlaw (off)`, an F word, another feed mode, M2, M30 or reset. While a law gives the
// feed, F waits behind it and is in force again when the law ends otherwise than by F.
#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/feed_law/feed_law_reader.h"

namespace stanok::lang {
namespace {

// Words that make an arc or curve of a block without axis words.
constexpr LetterSet curve_words = letters_of("IJKR");

bool is_curve(CodeNumber motion) {
  return motion == g(2) || motion == g(3) || motion == g(5) || motion == g(5, 1);
}

CodeNumber motion_code(const ActiveBlock& block) {
  for (const CodeNumber code : block.words.g) {
    const Code* const row = find_code('G', code);
    if (row != nullptr && row->group == Group::motion) return code;
  }
  return block.modal.code(Group::motion);
}

bool block_moves(const ActiveBlock& block) {
  const bool has_curve_word = (block.words.letters & curve_words) != 0;
  return block.programmed != 0 || (has_curve_word && is_curve(motion_code(block)));
}

// Lengths of a law are mm along the path.
bool path_has_length(const ActiveBlock& block) {
  return is_curve(motion_code(block)) || block.modal.transformation.axis >= 0 ||
         (block.programmed & block.channel_words.linear_axes()) != 0;
}

bool feed_is_known(const ModalState& modal) {
  return modal.feed.is_set() && modal.feed.programmed > 0.0;
}

// The address with which the speeds of a form begin; nothing: it leaves the spindle alone.
std::optional<LawAddress> first_speed_of(const LawForm& form) {
  const FeedLaw::Speed speed = law_type_of(form).speed;
  if (speed == FeedLaw::Speed::unchanged) return std::nullopt;
  return speed == FeedLaw::Speed::rev_per_min ? LawAddress::speed_first : LawAddress::cutting_first;
}

// What a law needs around it, beside its own values.
bool check_surroundings(ActiveBlock& block, const LawForm& form, LawScope scope) {
  const WordName word = first_law_word(block.words);
  if (!allows_feed_law(block, word)) return false;
  if (scope == LawScope::block && !path_has_length(block)) {
    block.faults.first =
        law_without_path(block.words, "for a motion of rotary axes alone", "no path in mm");
  } else if (const LawType& type = law_type_of(form);
             !type.takes_feed.empty() && !feed_is_known(block.modal)) {
    block
        .fail("E4342", word, "the " + std::string(type.name) + " feed law has no feed",
              std::string(type.takes_feed))
        .help.emplace_back("program F before or in this block");
  }
  return !block.failed();
}

}  // namespace

void take_feed_law(ActiveBlock& block, CodeNumber) {
  const LawWords words = law_words_of(block.words);
  const auto form = form_of(words);
  if (!form) {
    block.faults.first = form.error();
    return;
  }
  const LawScope scope = block_moves(block) ? LawScope::block : LawScope::modal;
  if (!check_surroundings(block, **form, scope)) return;
  auto law = read_feed_law(law_surroundings(block), **form, words, scope);
  if (!law) {
    block.faults.first = std::move(law).error();
    return;
  }
  if (const auto speed = first_speed_of(**form);
      speed && !spindle_takes_law(block, word_name(*speed), word_text(words, *speed))) {
    return;
  }
  if (scope == LawScope::modal) return set_feed_law(block, std::move(*law));
  block.law_feed = law->gives_feed() ? law->feed_first : block.modal.feed.mm;
  block.queue.emit(FeedLawChange{std::move(*law), true});
}

LawSurroundings law_surroundings(const ActiveBlock& block) {
  return {block.modal.feed_mode(), block.length_unit(), block.modal.inches() ? m_per_foot : 1.0,
          block.channel.finest_resolution_mm};
}

bool allows_feed_law(ActiveBlock& block, const WordName& word) {
  if (block.modal.feed_mode() != FeedMode::inverse_time) return true;
  BlockFault& fault = block.fail(
      "E4334", word, "a feed law is not possible while inverse time feed is active", "not in G93");
  fault.notes.push_back(block.modal.origin_of(Group::feed_mode));
  fault.help.emplace_back("program `G94` or `G95` before or in this block");
  return false;
}

bool spindle_takes_law(ActiveBlock& block, const WordName& word, const std::string& what) {
  if (refuse_spindle_that_is_axis(block, 0, word)) return false;
  if (block.modal.code(Group::spindle_mode) == g(96)) {
    BlockFault& fault = block.fail(
        "E4344", word, what + " is not possible while G96 holds the cutting speed constant",
        "both set the speed");
    fault.notes.push_back(block.modal.origin_of(Group::spindle_mode));
    fault.help.emplace_back("program `G97` first");
  } else if (!spindle_turns(block, 0)) {
    block.fail("E4343", word, what + " needs a spindle that turns", "no M3 or M4 before this")
        .help.emplace_back("program S and `M3` or `M4` before or in this block");
  }
  return !block.failed();
}

void set_feed_law(ActiveBlock& block, FeedLaw law) {
  ModalState& modal = block.modal;
  modal.feed.put_under(law);
  block.queue.emit(FeedLawChange{std::move(law), false});
}

void end_feed_law(ActiveBlock& block) {
  if (block.modal.feed.law.kind != FeedLaw::Kind::off) set_feed_law(block, {});
}

void restore_feed_law(ActiveBlock& block, const ModalState& saved) {
  ModalState& modal = block.modal;
  modal.feed.known = saved.feed.known;
  modal.feed.behind_law = saved.feed.behind_law;
  modal.feed.programmed = saved.feed.programmed;
  modal.feed.mm = saved.feed.mm;
  if (modal.feed.law == saved.feed.law) return;
  modal.feed.law = saved.feed.law;
  block.queue.emit(FeedLawChange{saved.feed.law, false});
}

}  // namespace stanok::lang
