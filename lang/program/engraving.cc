#include "lang/program/engraving.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/contract/code_number.h"

namespace stanok::lang {
namespace {

constexpr std::string_view cycle_file = "mill/engrave.nc";
constexpr std::string_view words_of_engraving = "XYIJRZFEP";

// Of P.
constexpr int literal_text = 0;
constexpr int serial_number = 1;
constexpr int first_character = 32;
constexpr int last_character = 126;

constexpr double serial_variable_number = 599;
constexpr std::size_t serial_digits_max = 15;  // all whole numbers of so many are numbers

// The text of a serial number.
struct SerialText {
  std::string before;
  std::size_t digits = 0;
  std::string behind;
  std::optional<double> first_number;
};

// One row of # between other letters, or a number alone; nothing: neither.
std::optional<SerialText> serial_text_of(const std::string& remark) {
  const bool is_number = remark.find_first_not_of("0123456789") == std::string::npos;
  if (is_number && remark.size() <= serial_digits_max)
    return SerialText{"", remark.size(), "", std::strtod(remark.c_str(), nullptr)};
  const std::size_t begin = remark.find('#');
  if (begin == std::string::npos) return std::nullopt;
  const std::size_t end = std::min(remark.find_first_not_of('#', begin), remark.size());
  if (remark.find('#', end) != std::string::npos || end - begin > serial_digits_max)
    return std::nullopt;
  return SerialText{remark.substr(0, begin), end - begin, remark.substr(end), std::nullopt};
}

const IsoWord* find_word(const IsoBlock& block, char letter, int code = -1) {
  const auto found = std::ranges::find_if(block.words, [&](const IsoWord& word) {
    return word.name.letter == letter && (code < 0 || word.name.code == code);
  });
  return found == block.words.end() ? nullptr : &*found;
}

// Where the tool stands, in the coordinates of the program.
Expression position_at(const Span& span, char axis) {
  Expression index;
  index.node = Node::axis;
  index.span = span;
  index.text = std::string(1, axis);
  Expression position;
  position.node = Node::system_variable;
  position.span = span;
  position.text = "prog_pos";
  position.children.push_back(std::move(index));
  return position;
}

class Engravings {
 public:
  explicit Engravings(Reporter& reporter) : reporter_(reporter) {}

  void visit(StatementList& list) {
    for (Statement& statement : list) visit(statement);
  }

  [[nodiscard]] const std::optional<Span>& first() const { return first_; }

 private:
  void visit(Statement& statement) {
    if (auto* const block = std::get_if<IsoBlock>(&statement.kind)) {
      make_call(*block, statement);
    } else if (auto* const branch = std::get_if<If>(&statement.kind)) {
      visit(branch->then_body);
      visit(branch->else_body);
    } else if (auto* const loop = std::get_if<While>(&statement.kind)) {
      visit(loop->body);
    } else if (auto* const turns = std::get_if<ORepeat>(&statement.kind)) {
      visit(turns->body);
    } else if (auto* const subprogram = std::get_if<OSubprogram>(&statement.kind)) {
      visit(subprogram->body);
    }
  }

  void make_call(const IsoBlock& block, Statement& statement) {
    const IsoWord* const code = find_word(block, 'G', g(47));
    if (code == nullptr) return;
    if (!has_its_words(block, *code)) {
      statement.kind = Compound{};
      return;
    }
    if (!first_) first_ = code->span;
    const int kind = kind_of(block).value_or(literal_text);
    if (kind == serial_number) {
      statement.kind = Compound{serial_number_of(block, statement.span, code->span)};
      return;
    }
    const std::string text =
        kind == literal_text ? block.remark : std::string(1, static_cast<char>(kind));
    statement.kind =
        CallStatement{call_of("engrave_block", {text_at(code->span, text)}, block, code->span)};
  }

  // What P says; nothing: it is no number of the text.
  static std::optional<int> kind_of(const IsoBlock& block) {
    const IsoWord* const kind = find_word(block, 'P');
    if (kind == nullptr) return literal_text;
    const double value = kind->value.number;
    const bool is_known =
        kind->value.node == Node::number && (value == literal_text || value == serial_number ||
                                             (value >= first_character && value <= last_character));
    if (!is_known || value != std::floor(value)) return std::nullopt;
    return static_cast<int>(value);
  }

  // #599 becomes the number of the text if that has one; the call; #599 becomes one more.
  static StatementList serial_number_of(const IsoBlock& block, const Span& whole,
                                        const Span& span) {
    const SerialText text = *serial_text_of(block.remark);
    StatementList list;
    const auto add = [&](auto kind) {
      Statement statement;
      statement.span = whole;
      statement.kind = std::move(kind);
      list.push_back(std::move(statement));
    };
    if (text.first_number) add(setting_of(number_expression(*text.first_number, span), span));
    std::vector<Expression> arguments;
    arguments.push_back(serial_variable(span));
    arguments.push_back(number_expression(static_cast<double>(text.digits), span));
    arguments.push_back(text_at(span, text.before));
    arguments.push_back(text_at(span, text.behind));
    add(CallStatement{call_of("engrave_number", std::move(arguments), block, span)});
    Expression next;
    next.node = Node::binary;
    next.span = span;
    next.operation = Operation::add;
    next.children.push_back(serial_variable(span));
    next.children.push_back(number_expression(1.0, span));
    add(setting_of(std::move(next), span));
    return list;
  }

  static IsoBlock setting_of(Expression value, const Span& span) {
    IsoBlock block;
    block.settings.push_back({serial_variable(span), std::move(value)});
    return block;
  }

  static Expression serial_variable(const Span& span) {
    Expression variable;
    variable.node = Node::parameter;
    variable.span = span;
    variable.children.push_back(number_expression(serial_variable_number, span));
    return variable;
  }

  static Expression text_at(const Span& span, const std::string& value) {
    Expression text;
    text.node = Node::string;
    text.span = span;
    text.text = value;
    return text;
  }

  static Expression call_of(const char* function, std::vector<Expression> arguments,
                            const IsoBlock& block, const Span& span) {
    Expression call;
    call.node = Node::call;
    call.span = span;
    call.text = function;
    call.children = std::move(arguments);
    for (const char letter : std::string_view("XYIJRZFE")) {
      const IsoWord* const word = find_word(block, letter);
      const bool is_place = letter == 'X' || letter == 'Y' || letter == 'R';
      if (word != nullptr) {
        call.children.push_back(word->value);
      } else {
        call.children.push_back(is_place ? position_at(span, letter == 'R' ? 'Z' : letter)
                                         : number_expression(0.0, span));
      }
    }
    return call;
  }

  bool has_its_words(const IsoBlock& block, const IsoWord& code) {
    for (const IsoWord& word : block.words) {
      if (&word == &code || words_of_engraving.find(word.name.letter) != std::string_view::npos)
        continue;
      reporter_.error("E4003", word.span, "`G47` does not use this word", "unused word")
          .help.emplace_back("a block with G47 takes X Y I J R Z F E and its text");
      return false;
    }
    for (const char letter : {'J', 'Z'}) {
      if (find_word(block, letter) != nullptr) continue;
      reporter_.error("E4007", code.span,
                      letter == 'J' ? "`G47` needs J, the height of the letters"
                                    : "`G47` needs Z, the depth of the strokes",
                      std::string("no ") + letter);
      return false;
    }
    const auto kind = kind_of(block);
    if (!kind) {
      reporter_
          .error("E4008", find_word(block, 'P')->span,
                 "P of `G47` is 0 for a text, 1 for a serial number or 32 to 126 for a character",
                 "a different number")
          .help.emplace_back("engrave a number with `engrave (str (...), height, depth);`");
      return false;
    }
    if (*kind >= first_character) return true;
    if (block.remark.empty()) {
      reporter_.error("E4007", code.span, "`G47` needs its text as a comment", "no text")
          .help.emplace_back("write e.g. `G47 P0 X0 Y0 J5. R2. Z-.2 F200. (TEXT)`");
      return false;
    }
    if (*kind == literal_text || serial_text_of(block.remark)) return true;
    reporter_
        .error("E4008", code.span, "the text of `G47 P1` has no serial number",
               "no # and no number")
        .help.emplace_back("write a # for each digit of #599, `(S####)`, or its first number");
    return false;
  }

  Reporter& reporter_;
  std::optional<Span> first_;
};

}  // namespace

bool make_engravings(StatementList& tree, Reporter& reporter) {
  Engravings engravings(reporter);
  engravings.visit(tree);
  if (!engravings.first()) return false;
  const bool is_included = std::ranges::any_of(tree, [](const Statement& statement) {
    const auto* const include = std::get_if<IncludeDirective>(&statement.kind);
    return include != nullptr && include->file == cycle_file;
  });
  if (is_included) return false;
  Statement include;
  include.span = *engravings.first();
  include.kind = IncludeDirective{std::string(cycle_file), *engravings.first()};
  tree.insert(tree.begin(), std::move(include));
  return true;
}

}  // namespace stanok::lang
