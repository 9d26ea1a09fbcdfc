#include "lang/tree/iso_parser.h"

#include <algorithm>

#include "lang/block/macro_arguments.h"
#include "lang/feed_law/feed_law_words.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/tree/comment_parser.h"
#include "lang/words/code_system.h"
#include "lang/words/corner_word.h"
#include "lang/words/named_address.h"

namespace stanok::lang {
namespace {

// Sets of I, J and K in a macro call.
constexpr int argument_sets_max = 10;

bool is_macro_call(const IsoBlock& block) {
  return std::ranges::any_of(block.words, [](const IsoWord& word) {
    return word.name.letter == 'G' && calls_macro(static_cast<CodeNumber>(word.name.code));
  });
}

// M98, M198, G65 and their like.
bool calls_by_number(const IsoBlock& block) {
  return is_macro_call(block) || std::ranges::any_of(block.words, [](const IsoWord& word) {
           return word.name.letter == 'M' && (word.name.code == m(98) || word.name.code == m(198));
         });
}

}  // namespace

bool IsoParser::is_named_address(std::string_view name) const {
  std::size_t behind = name.size();
  while (is_blank(scanner_.character(behind))) ++behind;
  if (scanner_.character(behind) != '=' || scanner_.character(behind + 1) == '=') return false;
  if (!find_named_address(name).empty()) return true;
  return channel_ != nullptr && channel_->axis_called(name).exists();
}

MaybeStatement IsoParser::parse_iso() {
  IsoBlock block;
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  while (true) {
    scanner_.skip_blanks(LineEnds::significant);
    const char c = scanner_.character();
    if (scanner_.at_line_end() || (c == '}' && cursor_.inside_braces())) break;
    if (c == ';') {
      if (!end_at_semicolon(block)) return std::nullopt;
      break;
    }
    if (!parse_iso_part(block)) return std::nullopt;
    if (scanner_.offset() - start > limits::block_bytes) scanner_.skip_to_line_end();
  }
  if (scanner_.offset() - start > limits::block_bytes) {
    reporter_.error("E1007", {start, 1, line}, "the block is longer than 4096 bytes", "too long");
    return std::nullopt;
  }
  if (!apply_aliases(block)) return std::nullopt;
  Statement statement;
  statement.kind = std::move(block);
  return statement;
}

// Inside braces it ends the block, else a comment begins there.
bool IsoParser::end_at_semicolon(const IsoBlock& block) {
  if (cursor_.inside_braces()) return end_iso_in_braces();
  const bool any = !block.words.empty() || !block.settings.empty();
  if (any) return cursor_.skip_remark();
  scanner_.skip_line_comment();
  return true;
}

bool IsoParser::end_iso_in_braces() {
  scanner_.advance(1);
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.at_line_end() || scanner_.character() == '}') return true;
  reporter_
      .error("E2004", scanner_.here(), "text after the `;` of an ISO block inside braces",
             "only `}` or a // comment may follow here")
      .help.push_back("put each ISO block on its own line; write comments with // or ( )");
  return false;
}

bool IsoParser::parse_iso_part(IsoBlock& block) {
  cursor_.begin_operators();
  const char c = scanner_.character();
  if (c == '(') return parse_comment(cursor_, block);
  if (c == '#') return parse_parameter_setting(block);
  if (is_letter(c)) return parse_word(block);
  if (c == '$') {
    scanner_.advance(1);
    auto value = brackets_.parse_value();
    if (!value) return false;
    block.spindle = std::move(*value);
    return true;
  }
  if (c == ',' && is_digit(scanner_.character(1)) && !block.words.empty()) {
    reporter_
        .error("E1002", scanner_.here(), "a number has a decimal point, not a comma",
               "decimal comma")
        .help.push_back("write e.g. `X10.5`");
    return false;
  }
  if (c == ',') return parse_corner_word(block);
  if (c == '@' || c == '^') return parse_sign_word(block, {c});
  if ((is_digit(c) || c == '.') && !block.words.empty()) {
    reporter_
        .error("E1003", scanner_.here(), "there is a space inside a number",
               "the number continues here")
        .help.push_back("write the number without spaces, or add the missing address");
    return false;
  }
  if (static_cast<unsigned char>(c) >= 0x80 || static_cast<unsigned char>(c) < 0x20) {
    report_illegal_character(cursor_);
    return false;
  }
  if (!block.words.empty() && (c == '+' || c == '-' || c == '*' || c == '/')) {
    reporter_
        .error("E2001", scanner_.here(), std::string("a computation with `") + c + "` in a word",
               "needs brackets")
        .help.push_back("put it in brackets, e.g. `X[#1+5]`");
    return false;
  }
  if (c == '{') {
    reporter_.error("E2001", scanner_.here(), "a brace inside a block", "braces contain statements")
        .help.push_back("write a comment in parentheses, `(text)`, or after `;`");
    return false;
  }
  Diagnostic& unexpected =
      cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "a word");
  if (c == '<' && calls_by_number(block)) {
    unexpected.help.emplace_back(
        "programs are called by their number here: `M98 P200` is O200, or the file O0200.nc; "
        "`call (\"NAME.nc\");` calls a file by its name");
  }
  return false;
}

bool IsoParser::parse_word(IsoBlock& block) {
  const std::string_view name = scanner_.name_ahead();
  if (name.size() > 1 && is_name_start(name[1])) return parse_long_word(block, name);
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  IsoWord word;
  word.name.letter = upper_case(name[0]);
  if (word.name.letter == 'N' || word.name.letter == 'O') {
    Diagnostic& diagnostic =
        reporter_.error("E2006", scanner_.here(), "a block or program number inside a block",
                        "must be at the beginning of the line");
    const bool inside_number = start > 0 && is_digit(source_.text()[start - 1]);
    if (word.name.letter == 'O' && inside_number)
      diagnostic.help.emplace_back("did you mean the digit 0? This is the letter O");
    return false;
  }
  std::size_t digits = 1;
  while (is_digit(scanner_.character(digits))) ++digits;
  std::size_t behind = digits;
  while (is_blank(scanner_.character(behind))) ++behind;
  const bool equals = scanner_.character(behind) == '=' && scanner_.character(behind + 1) != '=';
  if (equals && digits > 1) return parse_long_word(block, name.substr(0, digits));
  scanner_.advance(equals ? behind + 1 : 1);
  scanner_.skip_blanks(LineEnds::significant);
  if (equals) {
    auto value = expressions_.parse_expression(LineEnds::significant);
    if (!value) return false;
    word.value = std::move(*value);
  } else if (!parse_plain_value(word)) {
    return false;
  }
  word.span = scanner_.span_from(start, line);
  return add_word(block, std::move(word));
}

// `,C2`, `,R0.5` and `,A45`.
bool IsoParser::parse_corner_word(IsoBlock& block) {
  const char letter = upper_case(scanner_.character(1));
  if (!is_corner_word(std::string{',', letter})) {
    reporter_
        .error("E2001", scanner_.here(2), "C, R or A must follow a comma", "a comma between words")
        .help.emplace_back(
            "write `,C` for a chamfer, `,R` for a rounding, `,A` for the angle of a "
            "line");
    return false;
  }
  return parse_sign_word(block, {',', letter});
}

// A word whose name begins with a sign, which stands here: `,C2`, `@20`, `^45`.
bool IsoParser::parse_sign_word(IsoBlock& block, std::string name) {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  IsoWord word;
  scanner_.advance(name.size());
  word.name.name = std::move(name);
  scanner_.skip_blanks(LineEnds::significant);
  if (!parse_plain_value(word)) return false;
  word.span = scanner_.span_from(start, line);
  return add_word(block, std::move(word));
}

// A number, or a value of the RS274 kind.
bool IsoParser::parse_plain_value(IsoWord& word) {
  const char* const first = source_.text().data() + scanner_.offset();
  const char* const end = source_.text().data() + source_.end();
  const char* at = first;
  word.value.span = scanner_.here();
  if (!read_number(at, end, word.value.number, word.whole)) {
    auto value = brackets_.parse_word_value(word.name.letter);
    if (value) word.value = std::move(*value);
    return value.has_value();
  }
  scanner_.advance(static_cast<std::size_t>(at - first));
  word.value.span.length = static_cast<std::uint32_t>(at - first);
  if (scanner_.character() != '.') return true;
  reporter_.error("E1002", scanner_.here(), "a number with two decimal points", "second point");
  return false;
}

// H1=2, R5=..., S_n=0.1, X2=50, Xsin[30]
bool IsoParser::parse_long_word(IsoBlock& block, std::string_view name) {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  const Span name_span = scanner_.here(static_cast<std::uint32_t>(name.size()));
  const bool has_index = name.size() > 1 && is_digit(name[1]);
  IsoWord word;
  if (!has_index && !is_named_address(name)) {
    if (is_bracket_function(folded(name.substr(1))) && scanner_.character(name.size()) == '[') {
      word.name.letter = upper_case(name[0]);
      scanner_.advance(1);
      auto value = brackets_.parse_word_value(word.name.letter);
      if (!value) return false;
      word.value = std::move(*value);
      word.span = scanner_.span_from(start, line);
      return add_word(block, std::move(word));
    }
    reporter_.error("E2007", name_span, "unknown word `" + std::string(name) + "` in a block",
                    "a word is a letter and a number, or a named address and `=`");
    return false;
  }
  const char letter = upper_case(name[0]);
  if (has_index && (letter == 'G' || letter == 'M')) {
    reporter_
        .error("E2011", name_span, "`" + std::string(name) + "=` is not a word",
               "a code takes no `=` after its number")
        .help.push_back("for spindle 2 write e.g. `M3 $2`");
    return false;
  }
  const std::string_view address = has_index ? std::string_view() : find_named_address(name);
  if (!address.empty() && !is_law_address(address)) {
    reporter_.error("E2090", name_span,
                    "`" + std::string(name) + "` is not supported in this release",
                    "address of a spindle position");
    return false;
  }
  scanner_.advance(name.size());
  scanner_.skip_blanks(LineEnds::significant);
  scanner_.advance(1);
  auto value = expressions_.parse_expression(LineEnds::significant);
  if (!value) return false;
  word.span = scanner_.span_from(start, line);
  word.value = std::move(*value);
  if (has_index && letter == 'R') {
    Expression target;
    target.node = Node::r_parameter;
    target.span = name_span;
    for (const char digit : name.substr(1)) target.number = target.number * 10.0 + (digit - '0');
    block.settings.push_back({std::move(target), std::move(word.value)});
    return true;
  }
  word.name.name = address.empty() ? name : address;
  if (address.empty()) {
    std::transform(word.name.name.begin(), word.name.name.end(), word.name.name.begin(),
                   upper_case);
  }
  return add_word(block, std::move(word));
}

// A letter that the machine file binds to a named address becomes a word of that address, unless a
// code of the block takes the letter itself.
bool IsoParser::apply_aliases(IsoBlock& block) {
  const auto takes = [&](const IsoWord& code, char letter) {
    const char kind = code.name.letter;
    if ((kind != 'G' && kind != 'M') || code.name.code < 0) return false;
    const Code* const row = find_code(kind, static_cast<CodeNumber>(code.name.code));
    const bool macro_call = kind == 'G' && calls_macro(static_cast<CodeNumber>(code.name.code));
    return macro_call || dialect_.macro(kind, code.name.code) != nullptr ||
           (row != nullptr && (row->words & letter_bit(letter)) != 0);
  };
  for (IsoWord& word : block.words) {
    const char letter = word.name.letter;
    const std::string_view address = dialect_.alias(letter);
    const auto takes_letter = [&](const IsoWord& code) { return takes(code, letter); };
    if (address.empty() || std::ranges::any_of(block.words, takes_letter)) continue;
    if (std::ranges::any_of(block.words, [&](const IsoWord& other) {
          return other.name.letter == 0 && other.name.name == address;
        })) {
      reporter_.error("E4001", word.span, "`" + std::string(address) + "` twice in one block",
                      "second word of this address");
      return false;
    }
    word.name.letter = 0;
    word.name.name = address;
  }
  return true;
}

// From the code system of the text.
bool IsoParser::translate_code(IsoWord& word) {
  const CodeSystem system = source_.rules().code_system;
  if (system == CodeSystem::b) return true;
  const auto written = static_cast<CodeNumber>(word.name.code);
  const auto here = translated_code(written, system);
  if (here) {
    word.name.code = *here;
    return true;
  }
  const std::string_view instead = instead_of_code(written, system);
  Diagnostic& diagnostic =
      reporter_.error("E4004", word.span,
                      "code system " + std::string(system == CodeSystem::a ? "A" : "C") +
                          " has no `" + code_text('G', written) + "`",
                      "unknown code");
  if (!instead.empty()) diagnostic.help.emplace_back(instead);
  return false;
}

// Argument specification II: sets of I, J and K in a macro call. A letter that does not follow the
// one before in the alphabet begins the next set; 1: this word belongs to the first one, or to no
// call.
int IsoParser::argument_set(const IsoBlock& block, const IsoWord& word) {
  const auto is_of_set = [](char letter) { return letter >= 'I' && letter <= 'K'; };
  if (!is_macro_call(block) || !is_of_set(word.name.letter)) return 1;
  int set = 1;
  char last = 0;
  const auto follow = [&](char letter) {
    if (letter <= last) ++set;
    last = letter;
  };
  for (const IsoWord& other : block.words) {
    const char letter = other.name.letter != 0 ? other.name.letter : other.name.name[0];
    if (is_of_set(letter)) follow(letter);
  }
  follow(word.name.letter);
  return set;
}

// Of two words that set the same local variable the later one holds (B-63944EN, 16.6.1: `I-3 I4 D5`
// sets #7 to 5): the earlier one is taken out.
void IsoParser::replace_argument(IsoBlock& block, const IsoWord& word) {
  const auto parameter = [](const WordName& name) {
    return name.letter != 0 ? parameter_of_argument(name.letter) : parameter_of_repeated(name.name);
  };
  const int number = parameter(word.name);
  if (number == 0) return;
  const bool is_letter_word = word.name.letter != 0;
  std::erase_if(block.words, [&](const IsoWord& other) {
    return (other.name.letter != 0) != is_letter_word && parameter(other.name) == number;
  });
}

// I of the second set is `I2`, and so on.
bool IsoParser::add_argument(IsoBlock& block, IsoWord word, int set) {
  const std::string letter(1, word.name.letter);
  if (set > argument_sets_max) {
    reporter_.error("E4001", word.span, "more than ten sets of I, J and K in one call",
                    "one too many");
    return false;
  }
  word.name.letter = 0;
  word.name.name = letter + std::to_string(set);
  replace_argument(block, word);
  block.words.push_back(std::move(word));
  return true;
}

bool IsoParser::add_word(IsoBlock& block, IsoWord word) {
  const char letter = word.name.letter;
  const bool is_code = letter == 'G' || letter == 'M';
  if (is_code && word.value.node == Node::number) {
    const double tenths = word.value.number * 10.0;
    if (!is_integer(tenths) || tenths < 0.0 || tenths > 32767.0) {
      reporter_.error("E4004", word.span, "unknown code", "there is no such code");
      return false;
    }
    word.name.code = static_cast<int>(std::lround(tenths));
    if (letter == 'G' && !translate_code(word)) return false;
  }
  const auto same_name = [&](const IsoWord& other) {
    return other.name.letter == letter && other.name.name == word.name.name;
  };
  const auto count = std::count_if(block.words.begin(), block.words.end(), same_name);
  const int set = argument_set(block, word);
  if (set > 1) return add_argument(block, std::move(word), set);
  if (is_code ? count >= static_cast<std::ptrdiff_t>(CodeList::capacity) : count > 0) {
    const std::string name = letter != 0 ? std::string(1, letter) : word.name.name;
    reporter_.error(is_code ? "E4005" : "E4001", word.span,
                    is_code ? "more than " + std::to_string(CodeList::capacity) + " `" + name +
                                  "` words in one block"
                            : "`" + name + "` twice in one block",
                    is_code ? "one too many" : "second word of this address");
    return false;
  }
  if (is_macro_call(block)) replace_argument(block, word);
  block.words.push_back(std::move(word));
  return true;
}

// Whether a name of high-level statements stands here: `$` and a name, or two letters or more that
// are no function of brackets.
bool IsoParser::begins_variable() const {
  const char c = scanner_.character();
  if (c == '$') return is_name_start(scanner_.character(1));
  if (!is_name_start(c)) return false;
  std::string name;
  while (is_name_start(scanner_.character(name.size())) ||
         is_digit(scanner_.character(name.size())))
    name += scanner_.character(name.size());
  if (folded(name) == "pow") return scanner_.character(name.size()) != '[';
  return name.size() > 1 && is_name_start(name[1]) && !is_bracket_function(folded(name));
}

bool IsoParser::parse_parameter_setting(IsoBlock& block) {
  auto target = brackets_.parse_parameter_reference();
  if (!target) return false;
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() != '=') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`=` after the parameter");
    return false;
  }
  if (scanner_.character(1) == '=') {
    reporter_
        .error("E2001", scanner_.here(2), "`==` compares, but a parameter is set with `=`",
               "expected `=`")
        .help.emplace_back("conditions are in brackets: `IF [#1 EQ 2] GOTO 10`");
    return false;
  }
  scanner_.advance(1);
  scanner_.skip_blanks(LineEnds::significant);
  auto value = begins_variable() ? expressions_.parse_expression(LineEnds::significant)
                                 : brackets_.parse_right_side();
  if (!value) return false;
  block.settings.push_back({std::move(*target), std::move(*value)});
  return true;
}

}  // namespace stanok::lang
