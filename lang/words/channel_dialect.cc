#include "lang/words/channel_dialect.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lang/text/source.h"
#include "lang/words/dialect_codes.h"
#include "lang/words/law_address.h"
#include "lang/words/named_address.h"

namespace stanok::lang {
namespace {

// M100 to M899 belong to the machine builder.
constexpr int output_first = m(100);
constexpr int output_last = m(899);

// Of digital outputs and inputs, and of the time for a feedback.
constexpr double signals_max = 63.0;
constexpr double timeout_max_s = 3600.0;

// Codes whose meaning the machine file cannot change.
constexpr auto fixed_g =
    std::to_array<int>({g(0), g(1), g(2), g(3), g(17), g(18), g(19), g(20), g(21), g(40), g(53),
                        g(65), g(66), g(67), g(90), g(91)});
constexpr auto fixed_m =
    std::to_array<int>({m(0), m(1), m(2), m(30), m(98), m(99), m(902), m(903)});

// Letters that codes of every channel take (E only few of them, which then have it in their
// blocks), and the axes of every drawing.
constexpr LetterSet taken_letters = letters_of("DFGHIJKLMNOPQRSTUXYZ");

bool is_fixed(char letter, int number) {
  const auto has = [number](const auto& list) {
    return std::find(list.begin(), list.end(), number) != list.end();
  };
  return letter == 'G' ? has(fixed_g) : has(fixed_m);
}

EffectOrder order_of_output(UserCode::Kind kind) {
  if (kind == UserCode::Kind::output_after) return EffectOrder::functions_after;
  if (kind == UserCode::Kind::output_with_motion) return EffectOrder::motion_modifier;
  return EffectOrder::functions_before;
}

Code row_of(const UserCode& output) {
  Code row;
  row.letter = 'M';
  row.number = static_cast<CodeNumber>(output.number);
  row.order = order_of_output(output.kind);
  row.words = output.kind == UserCode::Kind::output_switched ? 0 : letters_of("PQ");
  row.action = CodeAction::send_machine_function;
  row.title = "function of the machine";
  return row;
}

const UserCode* find_in(const std::vector<UserCode>& codes, char letter, int number) {
  const auto found = std::find_if(codes.begin(), codes.end(), [&](const UserCode& code) {
    return code.letter == letter && code.number == number;
  });
  return found == codes.end() ? nullptr : &*found;
}

// "G43.4" -> letter and number in tenths.
bool read_code_name(std::string_view name, UserCode& code) {
  if (name.size() < 2 || (name[0] != 'G' && name[0] != 'M')) return false;
  code.letter = name[0];
  int whole = 0;
  const char* const end = name.data() + name.size();
  auto [at, error] = std::from_chars(name.data() + 1, end, whole);
  if (error != std::errc() || whole < 0 || whole > 3000) return false;
  code.number = whole * 10;
  if (at != end && *at == '.' && end - at == 2 && is_digit(at[1])) {
    code.number += at[1] - '0';
    at += 2;
  }
  return at == end;
}

bool may_be_output(const UserCode& code) {
  if (code.letter != 'M' || code.number > output_last || code.number % 10 != 0) return false;
  if (code.number >= output_first) return true;
  const auto number = static_cast<CodeNumber>(code.number);
  return is_left_to_builders('M', number) || find_code('M', number) == nullptr;
}

std::string no_output(const std::string& name) {
  return "'" + name +
         "' cannot be an output; M100 to M899 can, also M50 to M53, M61 to M68, M70 to M72, and "
         "the codes below M100 that have no meaning";
}

// "output 4 on, input 7 within 2 s"; false: it is not that.
bool read_switched_output(std::string_view meaning, UserCode& code) {
  std::vector<std::string> words(1);
  for (const char c : meaning) {
    const bool divides = is_blank(c) || c == ',';
    if (divides && !words.back().empty()) words.emplace_back();
    if (!divides) words.back() += c;
  }
  if (words.back().empty()) words.pop_back();
  const auto number = [&](std::size_t place, double largest) {
    double value = -1.0;
    const std::string& word = words[place];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool good = error == std::errc() && end == word.data() + word.size();
    return good && value >= 0.0 && value <= largest ? value : -1.0;
  };
  const bool has_feedback = words.size() == 8;
  if ((words.size() != 3 && !has_feedback) || (words[2] != "on" && words[2] != "off")) return false;
  const double output = number(1, signals_max);
  if (output < 0.0 || output != std::floor(output)) return false;
  code.kind = UserCode::Kind::output_switched;
  code.output = static_cast<int>(output);
  code.on = words[2] == "on";
  if (!has_feedback) return true;
  const double feedback = number(4, signals_max);
  code.timeout_s = number(6, timeout_max_s);
  code.feedback = static_cast<int>(feedback);
  return words[3] == "input" && words[5] == "within" && words[7] == "s" && feedback >= 0.0 &&
         feedback == std::floor(feedback) && code.timeout_s > 0.0;
}

std::optional<UserCode::Kind> output_kind(std::string_view word) {
  if (word == "before") return UserCode::Kind::output_before;
  if (word == "after") return UserCode::Kind::output_after;
  if (word == "with_motion") return UserCode::Kind::output_with_motion;
  return std::nullopt;
}

}  // namespace

ChannelDialect::ChannelDialect(const ChannelDescription* channel) {
  if (channel == nullptr) return;
  for (const UserCode& code : channel->user_codes) {
    const bool macro = code.kind == UserCode::Kind::macro;
    (macro ? macros_ : outputs_).push_back(code);
    if (!macro) output_rows_.push_back(row_of(code));
  }
  aliases_ = channel->address_alias;
  for (const AddressAlias& alias : aliases_) alias_letters_ |= letter_bit(alias.letter);
}

const UserCode* ChannelDialect::macro(char letter, int number) const {
  return find_in(macros_, letter, number);
}

const Code* ChannelDialect::output(char letter, int number) const {
  const UserCode* const code = find_in(outputs_, letter, number);
  return code == nullptr ? nullptr
                         : &output_rows_[static_cast<std::size_t>(code - outputs_.data())];
}

const UserCode* ChannelDialect::output_code(int number) const {
  return find_in(outputs_, 'M', number);
}

std::string_view ChannelDialect::alias(char letter) const {
  for (const AddressAlias& alias : aliases_) {
    if (alias.letter == letter) return alias.address;
  }
  return {};
}

std::optional<MacroCode> macro_of(const BlockWords& words, const ChannelDialect& dialect) {
  for (const CodeNumber number : words.g) {
    if (calls_macro(number)) return MacroCode{'G', number, nullptr};
    if (const UserCode* const code = dialect.macro('G', number)) {
      return MacroCode{'G', number, code};
    }
  }
  for (const CodeNumber number : words.m) {
    if (const UserCode* const code = dialect.macro('M', number)) {
      return MacroCode{'M', number, code};
    }
  }
  return std::nullopt;
}

Expected<UserCode, std::string> read_user_code(std::string_view code, std::string_view meaning) {
  UserCode made;
  const std::string name(code);
  if (!read_code_name(code, made)) {
    return tl::unexpected("'" + name + "' is not a G or M code; write it as in G200");
  }
  if (is_fixed(made.letter, made.number)) {
    return tl::unexpected("'" + name + "' cannot be given another meaning; use a free code");
  }
  const bool ours = may_be_output(made);
  if (meaning.starts_with("output ")) {
    if (!ours) return tl::unexpected(no_output(name));
    if (read_switched_output(meaning, made)) return made;
    return tl::unexpected("'" + std::string(meaning) +
                          "' is not an output; write it as in \"output 4 on, input 7 within 2 s\"");
  }
  const std::size_t blank = meaning.find(' ');
  if (const auto kind = output_kind(meaning.substr(0, blank))) {
    made.kind = *kind;
    made.waits = blank != std::string_view::npos;
    if (!ours) return tl::unexpected(no_output(name));
    if (made.waits && meaning.substr(blank + 1) != "wait") {
      return tl::unexpected("'" + std::string(meaning) + "' is not a kind of output; after '" +
                            std::string(meaning.substr(0, blank)) + "' only 'wait' may follow");
    }
    return made;
  }
  const std::size_t colon = meaning.find(':');
  made.program = meaning.substr(0, colon);
  if (colon != std::string_view::npos) made.function = folded(meaning.substr(colon + 1));
  if (made.program.find('.') == std::string::npos) {
    return tl::unexpected(
        "'" + std::string(meaning) +
        "' is neither a program file nor before, after, with_motion or an output");
  }
  return made;
}

Expected<AddressAlias, std::string> read_address_alias(std::string_view letter,
                                                       std::string_view address, ChannelKind kind,
                                                       std::span<const std::string> axis_words) {
  const std::string name = "'" + std::string(letter) + "'";
  const auto is_axis = [&](std::string_view word) {
    return std::ranges::find(axis_words, word) != axis_words.end();
  };
  if (letter.size() != 1 || letter[0] < 'A' || letter[0] > 'Z') {
    return tl::unexpected(name + " is not a single capital letter");
  }
  if (is_axis(letter)) {
    return tl::unexpected(name + " is an axis of the channel; use a free letter");
  }
  const LetterSet taken =
      kind == ChannelKind::lathe ? taken_letters | letters_of("UVW") : taken_letters;
  if ((taken & letter_bit(letter[0])) != 0) {
    return tl::unexpected(name + " has a meaning in every program; only A, B, C and E can be free" +
                          (kind == ChannelKind::lathe ? "" : ", or V and W"));
  }
  const std::string_view known = find_named_address(address);
  if (is_law_address(known)) return AddressAlias{letter[0], std::string(known)};
  if (address.size() > 1 && is_axis(address)) return AddressAlias{letter[0], std::string(address)};
  return tl::unexpected("'" + std::string(address) +
                        "' is not a named address; use one of a feed law, such as dS, or an axis "
                        "word of more than one character");
}

}  // namespace stanok::lang
