#include "lang/program/engraving.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lang/contract/code_number.h"

namespace stanok::lang {
namespace {

constexpr std::string_view cycle_file = "mill/engrave.nc";
constexpr std::string_view words_of_engraving = "XYIJRZFEP";

const IsoWord* find_word(const IsoBlock& block, char letter, int code = -1) {
  const auto found = std::ranges::find_if(block.words, [&](const IsoWord& word) {
    return word.name.letter == letter && (code < 0 || word.name.code == code);
  });
  return found == block.words.end() ? nullptr : &*found;
}

Expression number_at(const Span& span, double value) {
  Expression number;
  number.span = span;
  number.number = value;
  return number;
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
    if (has_its_words(block, *code)) {
      if (!first_) first_ = code->span;
      statement.kind = CallStatement{call_of(block, code->span)};
    } else {
      statement.kind = Compound{};
    }
  }

  static Expression call_of(const IsoBlock& block, const Span& span) {
    Expression text;
    text.node = Node::string;
    text.span = span;
    text.text = block.remark;
    Expression call;
    call.node = Node::call;
    call.span = span;
    call.text = "engrave_block";
    call.children.push_back(std::move(text));
    for (const char letter : std::string_view("XYIJRZFE")) {
      const IsoWord* const word = find_word(block, letter);
      const bool is_place = letter == 'X' || letter == 'Y' || letter == 'R';
      if (word != nullptr) {
        call.children.push_back(word->value);
      } else {
        call.children.push_back(is_place ? position_at(span, letter == 'R' ? 'Z' : letter)
                                         : number_at(span, 0.0));
      }
    }
    return call;
  }

  bool has_its_words(const IsoBlock& block, const IsoWord& code) {
    for (const IsoWord& word : block.words) {
      if (&word == &code || words_of_engraving.find(word.name.letter) != std::string_view::npos)
        continue;
      reporter_.error("E4003", word.span, "`G47` does not use this word", "unused word")
          .help.emplace_back("G47 stands in a block with X Y I J R Z F E and its text");
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
    const IsoWord* const kind = find_word(block, 'P');
    const bool text_of_block =
        kind == nullptr || (kind->value.node == Node::number && kind->value.number == 0.0);
    if (!text_of_block) {
      reporter_.error("E2090", kind->span, "`G47` with a serial number or a letter as P", "not P0")
          .help.emplace_back("engrave a number with `engrave (str (...), height, depth);`");
    } else if (block.remark.empty()) {
      reporter_.error("E4007", code.span, "`G47` needs its text as a comment", "no text")
          .help.emplace_back("write e.g. `G47 P0 X0 Y0 J5. R2. Z-.2 F200. (TEXT)`");
    }
    return text_of_block && !block.remark.empty();
  }

  Reporter& reporter_;
  std::optional<Span> first_;
};

}  // namespace

void make_engravings(StatementList& tree, Reporter& reporter) {
  Engravings engravings(reporter);
  engravings.visit(tree);
  if (!engravings.first()) return;
  const bool is_included = std::ranges::any_of(tree, [](const Statement& statement) {
    const auto* const include = std::get_if<IncludeDirective>(&statement.kind);
    return include != nullptr && include->file == cycle_file;
  });
  if (is_included) return;
  Statement include;
  include.span = *engravings.first();
  include.kind = IncludeDirective{std::string(cycle_file), *engravings.first()};
  tree.insert(tree.begin(), std::move(include));
}

}  // namespace stanok::lang
