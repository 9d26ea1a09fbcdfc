#include "lang/block/other_controls.h"

#include <algorithm>
#include <string>

#include "lang/words/named_address.h"

namespace stanok::lang {
namespace {

enum class Channels : std::uint8_t { all, lathes };

// A code without axis words of its own, which leaves those of its block to the active motion; on
// another control it takes them.
// Where a code or word means something else, and what.
struct OtherMeaning {
  char system = 0;  // code system of Fanuc lathes, A or C; 0: `text` says which control
  std::string_view text;
};

struct TakesAxisWordsElsewhere {
  CodeNumber code;
  Channels channels;
  OtherMeaning meaning;
  std::string_view remedy;
};

constexpr TakesAxisWordsElsewhere takes_axis_words[] = {
    {g(20),
     Channels::lathes,
     {'C', "it is a turning cycle"},
     "the cycle is `G77`; to move, add `G0` or `G1` to the block"},
    {g(21),
     Channels::lathes,
     {'C', "it is a thread cycle"},
     "the cycle is `G78`; to move, add `G0` or `G1` to the block"},
    {g(28, 1),
     Channels::all,
     {0, "on other controls it moves there"},
     "`G28` moves to a reference point; to program a move, add `G0` or `G1` to the block"},
    {g(30, 1),
     Channels::all,
     {0, "on Fanuc controls it moves to a floating reference point"},
     "`G30` moves to a reference point; to program a move, add `G0` or `G1` to the block"},
    {g(50),
     Channels::lathes,
     {'A', "it sets the coordinates"},
     "set them with `G92`; to move, add `G0` or `G1` to the block"},
    {g(60),
     Channels::all,
     {0, "on Fanuc mills it is single-direction positioning"},
     "add `G0` or `G1` to the block"},
    {g(90),
     Channels::lathes,
     {'A', "it is a turning cycle"},
     "the cycle is `G77`; to move, add `G0` or `G1` to the block"},
    {g(92, 1),
     Channels::all,
     {0, "on Fanuc controls it sets the coordinates"},
     "set them with `G92`; to move, add `G0` or `G1` to the block"},
    {g(94),
     Channels::lathes,
     {'A', "it is a facing cycle"},
     "the cycle is `G79`; to move, add `G0` or `G1` to the block"},
};

BlockFault two_meanings(WordName word, std::string message, const OtherMeaning& meaning,
                        std::string_view remedy) {
  BlockFault fault =
      fault_at("E4016", std::move(word), std::move(message), "the meaning is not clear");
  const std::string system(1, meaning.system);
  const std::string where =
      meaning.system == 0 ? "" : "in code system " + system + " of Fanuc lathes ";
  fault.notes.push_back({where + std::string(meaning.text), {}});
  fault.help.emplace_back(remedy);
  if (meaning.system != 0)
    fault.help.push_back(
        "a program for that code system names it in its first line: `(dialect fanuc " + system +
        ")`");
  return fault;
}

// G90 behind G91 says something: there it is no cycle.
bool confirms_absolute(const BlockMeaning& block) {
  return block.modal != nullptr && !block.modal->incremental();
}

std::optional<BlockFault> axis_words_of_another_code(const BlockMeaning& block) {
  if (!block.has_axis_words || block.codes.axis_user != nullptr) return std::nullopt;
  for (const TakesAxisWordsElsewhere& row : takes_axis_words) {
    if (!block.words.g.has(row.code)) continue;
    const bool is_lathe = block.kind == ChannelKind::lathe;
    if (row.channels == Channels::lathes && (!is_lathe || block.words.rules.is_fanuc())) continue;
    if (row.code == g(90) && !confirms_absolute(block)) continue;
    return two_meanings(code_word(row.code),
                        "`" + code_text('G', row.code) + "` with axis words and no motion code",
                        row.meaning, row.remedy);
  }
  return std::nullopt;
}

std::optional<BlockFault> speed_limit_of_a_lathe(const BlockMeaning& block) {
  const bool lathe = block.kind == ChannelKind::lathe;
  for (const CodeNumber code : {g(50), g(92)}) {
    if (!block.words.g.has(code)) continue;
    const bool indexed = std::any_of(
        block.words.named.begin(), block.words.named.end(),
        [](const NamedWord& word) { return spindle_of_indexed_speed(word).has_value(); });
    if (!indexed && (lathe || !block.words.has('S'))) continue;
    return two_meanings(code_word(code), "`" + code_text('G', code) + "` with a spindle speed",
                        {0, "on lathes it limits the speed of `G96`"},
                        lathe ? "limit the speed with `S` alone, e.g. `G92 S2500`"
                              : "the limit is D of `G96`; set a speed in a block of its own");
  }
  return std::nullopt;
}

std::optional<BlockFault> code_of_lathes(const BlockMeaning& block) {
  if (block.kind != ChannelKind::lathe || block.words.rules.is_fanuc()) return std::nullopt;
  for (const CodeNumber code : {g(98), g(99)}) {
    if (!block.words.g.has(code) || block.words.rules.is_linuxcnc()) continue;
    return two_meanings(
        code_word(code), "`" + code_text('G', code) + "` has no meaning on a lathe channel",
        code == g(98) ? OtherMeaning{'A',
                                     "it is feed per minute; on other controls it is a return "
                                     "level of drilling cycles"}
                      : OtherMeaning{'A',
                                     "it is feed per revolution; on other controls it is a return "
                                     "level of drilling cycles"},
        code == g(98) ? "the feed per minute is `G94`" : "the feed per revolution is `G95`");
  }
  if (block.words.g.has(g(92)) && block.has_axis_words && block.words.has('F')) {
    return two_meanings({'F', -1, {}}, "`G92` with axis words and F on a lathe channel",
                        {'A', "it is a thread cycle; here it sets the coordinates of the point"},
                        "the cycle is `G78`; to set coordinates, leave F out");
  }
  return std::nullopt;
}

}  // namespace

std::optional<BlockFault> other_meaning(const BlockMeaning& block) {
  if (auto fault = code_of_lathes(block)) return fault;
  if (auto fault = speed_limit_of_a_lathe(block)) return fault;
  return axis_words_of_another_code(block);
}

double value_or_thousandths(const ActiveBlock& block, char letter) {
  constexpr double per_unit = 1000.0;
  const bool counted =
      block.words.rules.is_fanuc() && (block.words.whole & letter_bit(letter)) != 0;
  return counted ? block.value(letter) / per_unit : block.value(letter);
}

bool is_position_on_fanuc(int number) {
  return (number >= 5001 && number <= 5008) || (number >= 5021 && number <= 5028) ||
         (number >= 5041 && number <= 5048);
}

std::string_view meaning_on_fanuc(int number) {
  const auto within = [number](int first, int last) { return number >= first && number <= last; };
  if (within(1000, 1035)) return "an input";
  if (within(1100, 1135)) return "an output";
  if (within(2001, 2999)) return "a value of a tool";
  if (number == 3000) return "an alarm";
  if (number == 3006) return "a stop with a message";
  if (number == 3001 || number == 3002) return "a clock";
  if (number == 3003 || number == 3004) return "a permission of the operator";
  if (number == 3011 || number == 3012) return "date or time";
  if (number == 3901 || number == 3902) return "a number of parts";
  if (within(4001, 4130)) return "a modal code or value";
  if (within(5081, 5088)) return "the active tool length";
  if (is_position_on_fanuc(number)) return "a position of an axis";
  return {};
}

void refuse_thousandths(ActiveBlock& block, char letter, double largest, std::string_view what) {
  const bool whole = (block.words.whole & letter_bit(letter)) != 0;
  if (!block.has(letter) || !whole || block.words.rules.is_fanuc() || block.value(letter) < largest)
    return;
  std::string message = "`" + std::string(1, letter) + "` is ";
  message.append(what).append(" of ");
  message.append(std::to_string(static_cast<long long>(block.value(letter))));
  BlockFault& fault = block.fail("E4016", {letter, -1, {}}, std::move(message), "thousandths?");
  fault.notes.push_back({"Fanuc controls count this word in thousandths when it has no point", {}});
  fault.help.emplace_back("write the number with its decimal point, in the units of the program");
}

}  // namespace stanok::lang
