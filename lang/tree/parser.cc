#include "lang/tree/parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "lang/block/other_controls.h"
#include "lang/block/predefined_parameter.h"
#include "lang/text/block_number.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/tree/keywords.h"
#include "lang/tree/plain_block.h"
#include "lang/tree/text_value.h"

namespace stanok::lang {
namespace {

bool is_macro_flow(const Statement& statement) {
  const auto* const branch = std::get_if<If>(&statement.kind);
  const auto* const loop = std::get_if<While>(&statement.kind);
  return std::holds_alternative<JumpLine>(statement.kind) ||
         (branch != nullptr && branch->is_macro_line) ||
         (loop != nullptr && loop->label.starts_with(macro_loop_label));
}

bool is_high_level(const Statement& statement) {
  if (is_macro_flow(statement)) return false;
  if (const auto* leave = std::get_if<Break>(&statement.kind)) return leave->label.empty();
  if (const auto* next = std::get_if<Continue>(&statement.kind)) return next->label.empty();
  return !std::holds_alternative<IsoBlock>(statement.kind) &&
         !std::holds_alternative<OCall>(statement.kind) &&
         !std::holds_alternative<OReturn>(statement.kind) &&
         !std::holds_alternative<IncludeDirective>(statement.kind) &&
         !std::holds_alternative<KinematicsDirective>(statement.kind) &&
         !std::holds_alternative<FeedLawDirective>(statement.kind) &&
         !std::holds_alternative<AdaptiveDirective>(statement.kind) &&
         !std::holds_alternative<OrientationDirective>(statement.kind) &&
         !std::holds_alternative<NumberedProgram>(statement.kind);
}

bool is_branch_or_loop(const Statement& statement) {
  return std::holds_alternative<If>(statement.kind) ||
         std::holds_alternative<While>(statement.kind) ||
         std::holds_alternative<DoWhile>(statement.kind) ||
         std::holds_alternative<ORepeat>(statement.kind);
}

// Without a body of other statements.
bool is_simple(const Statement& statement) {
  return std::holds_alternative<Declaration>(statement.kind) ||
         std::holds_alternative<Assignment>(statement.kind) ||
         std::holds_alternative<CallStatement>(statement.kind) ||
         std::holds_alternative<Return>(statement.kind) ||
         std::holds_alternative<OCall>(statement.kind) ||
         std::holds_alternative<WorkpieceDirective>(statement.kind);
}

bool ends_program(const IsoBlock& block) {
  return std::any_of(block.words.begin(), block.words.end(), [](const IsoWord& word) {
    const int code = word.name.code;
    return word.name.letter == 'M' && (code == m(2) || code == m(30) || code == m(99));
  });
}

// DO1, END2: Fanuc loops.
bool is_numbered(std::string_view name, std::string_view word) {
  return name.size() > word.size() && name.starts_with(word) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(word.size()), name.end(), is_digit);
}

// `en1` of the Fanuc dialect is `end1`.
std::string with_whole_keyword(const std::string& name, const TextRules& rules) {
  const std::size_t letters = std::min(name.find_first_of("0123456789"), name.size());
  const std::string_view whole = name;
  return std::string(macro_keyword(whole.substr(0, letters), rules)) + name.substr(letters);
}

// Parameters of a program that does not run: no value is known.
class UnknownParameters : public Parameters {
 public:
  UnknownParameters(NamedParameters* names, const TextRules& rules)
      : names_(names), rules_(rules) {}

  std::optional<double> numbered(double, ValueFault&) override { return std::nan(""); }
  std::optional<double> named(const std::string& name, ValueFault&) override {
    const bool known = find_predefined_parameter(name) != nullptr || slot_to_set(name);
    return known ? std::optional(std::nan("")) : std::nullopt;
  }
  bool are_known() const override { return false; }
  bool is_at_hand(double number) const override {
    constexpr double system_variable_first = 1000.0;
    constexpr double system_variable_last = 9999.0;
    if (number < system_variable_first) return true;
    if (rules_.is_fanuc()) return false;
    const bool is_one = is_integer(number) && number <= system_variable_last;
    return !is_one || meaning_on_fanuc(static_cast<int>(std::lround(number))).empty();
  }
  std::optional<std::uint32_t> slot_to_set(const std::string& name) override {
    if (names_ == nullptr || find_predefined_parameter(name) != nullptr) return std::nullopt;
    return names_->add(name);
  }

 private:
  NamedParameters* names_;
  TextRules rules_;
};

// What stands here for a type of C, C++ or another control; empty: it is none.
std::string_view type_of_other_languages(std::string_view name) {
  constexpr auto types =
      std::to_array<std::pair<std::string_view, std::string_view>>({{"boolean", "bool"},
                                                                    {"char", "string"},
                                                                    {"double", "num"},
                                                                    {"float", "num"},
                                                                    {"int", "num"},
                                                                    {"integer", "num"},
                                                                    {"long", "num"},
                                                                    {"real", "num"},
                                                                    {"unsigned", "num"}});
  const auto* const found = std::find_if(types.begin(), types.end(),
                                         [&](const auto& type) { return type.first == name; });
  return found == types.end() ? std::string_view() : found->second;
}

const ChannelDialect& no_dialect() {
  static const ChannelDialect none(nullptr);
  return none;
}

}  // namespace

Parser::Parser(const Source& source, Reporter& reporter, ParserContext context)
    : context_(std::move(context)),
      dialect_(context_.dialect != nullptr ? *context_.dialect : no_dialect()),
      channel_words_(words_of_channel(context_.channel)),
      cursor_(source, reporter),
      functions_(defined_functions(source)),
      brackets_(cursor_),
      expressions_(cursor_, brackets_, functions_),
      iso_(cursor_, brackets_, expressions_, channel_words_ ? &*channel_words_ : nullptr, dialect_),
      bodies_(cursor_, *this),
      declarations_(cursor_, expressions_, bodies_),
      statements_(cursor_, expressions_, bodies_, declarations_),
      o_lines_(cursor_, brackets_, *this),
      macro_lines_(cursor_, brackets_, iso_, *this),
      directives_(cursor_, expressions_, functions_, context_.included_functions) {
  functions_.insert(context_.functions.begin(), context_.functions.end());
}

StatementList Parser::parse_program() {
  StatementList list;
  while (!scanner().at_end()) parse_statement(list);
  return list;
}

std::optional<IsoBlock> Parser::parse_block(const Source& source, const Span& span) {
  Reporter silent(source);
  Parser parser(source, silent, {});
  parser.scanner().move_to(span.offset, span.line);
  parser.scanner().skip_blanks(LineEnds::significant);
  parser.take_block_number();
  auto statement = parser.iso_.parse_iso();
  if (!statement) return std::nullopt;
  return std::get<IsoBlock>(std::move(statement->kind));
}

// What stands between statements: line ends, comments, `;`, braces. False: a statement begins.
bool Parser::pass_separator() {
  scanner().skip_blanks(LineEnds::significant);
  if (scanner().at_end()) return true;
  const char c = scanner().character();
  if (scanner().at_line_end()) {
    scanner().skip_line_end();
  } else if (c == ';') {
    scanner().at_line_start() ? scanner().skip_line_comment() : scanner().advance(1);
  } else if (c == '}' && headless_braces_ > 0) {
    close_headless();
  } else if (c == '}' && !cursor_.inside_braces()) {
    reporter().error("E2003", scanner().here(), "`}` without `{`", "nothing to close");
    scanner().advance(1);
  } else {
    return c == '}';
  }
  return true;
}

void Parser::parse_statement(StatementList& list) {
  if (take_plain_lines(list) || pass_separator()) return;
  if (context_.watch != nullptr) context_.watch->count_statement();
  const std::size_t start = scanner().offset();
  const std::uint32_t line = scanner().line();
  int skip_level = scanner().at_line_start() ? take_block_skip() : 0;
  const int number = take_block_number();
  // Fanuc leaves out what is behind a `/` (B-63944EN, 13.2): all of the block, behind its number.
  if (number >= 0 && skip_level == 0 && cursor_.source().rules().is_fanuc())
    skip_level = take_block_skip();
  if (scanner().at_line_end()) return;
  const bool begins_with_letter_o = upper_case(scanner().character()) == 'O';
  auto statement = parse_kind(skip_level);
  if (!statement) {
    keep_faulty(list, start, line);
    return recover(start);
  }
  if (is_simple(*statement) && !cursor_.check_length(start, line))
    return keep_faulty(list, start, line);
  statement->span = scanner().span_from(start, line);
  statement->skip_level = skip_level;
  statement->number = number;
  const bool is_o_line = begins_with_letter_o && is_branch_or_loop(*statement);
  if (skip_level != 0 && !is_o_line && is_high_level(*statement)) {
    reporter()
        .error("E2005", {start, 1, line}, "block skip before a high-level statement",
               "only ISO blocks, directives and O-lines can be skipped")
        .help.push_back("use `if ($skip[1]) { ... }`");
    return;
  }
  const IsoBlock* const block = std::get_if<IsoBlock>(&statement->kind);
  const bool top_level = cursor_.at_file_level();
  if (block != nullptr && top_level && skip_level == 0 && ends_program(*block)) {
    reporter().soften_from(scanner().offset());
  }
  list.push_back(std::move(*statement));
}

bool Parser::take_plain_lines(StatementList& list) {
  if (!scanner().at_line_start() || scanner().at_end()) return false;
  const std::string_view text = cursor_.source().text();
  const char* const begin = text.data() + scanner().offset();
  const char* const end = text.data() + cursor_.source().end();
  const Surroundings surroundings =
      cursor_.inside_braces() ? Surroundings::braces : Surroundings::file_level;
  const char* at = begin;
  std::uint32_t lines = 0;
  bool any_words = false;
  BlockWords words;
  UnknownParameters parameters(context_.named_parameters, cursor_.source().rules());
  TextValues values(parameters);
  const ChannelWords* const channel = channel_words_ ? &*channel_words_ : nullptr;
  for (const char* line = at; line != end; line = at, ++lines) {
    if (context_.watch != nullptr) context_.watch->pass();
    if (!read_plain_line(at, end, {surroundings, cursor_.source().rules()}, words, values)) break;
    if (!is_plain_block(words, channel, dialect_)) {
      at = line;
      break;
    }
    any_words = any_words || !words.empty() || !values.settings().empty() ||
                block_number({line, end}).has_value();
  }
  if (at == begin) return false;
  const std::size_t from = scanner().offset();
  const std::size_t to = cursor_.source().offset_of(at);
  if (any_words) {
    Statement statement;
    statement.span = {from, 1, scanner().line()};
    statement.kind = PlainLines{from, to, scanner().line(), surroundings};
    list.push_back(std::move(statement));
  }
  scanner().move_to(to, scanner().line() + lines);
  return true;
}

int Parser::take_block_skip() {
  if (scanner().character() != '/' || scanner().character(1) == '/') return 0;
  scanner().advance(1);
  int level = 1;
  const char digit = scanner().character();
  if (digit >= '1' && digit <= '9') {
    level = digit - '0';
    scanner().advance(1);
  }
  scanner().skip_blanks(LineEnds::significant);
  return level;
}

// -1: the block has none.
int Parser::take_block_number() {
  if (upper_case(scanner().character()) != 'N' || !is_digit(scanner().character(1))) return -1;
  const auto number = block_number(cursor_.source().text().substr(scanner().offset(), 12));
  scanner().advance(1);
  while (is_digit(scanner().character())) scanner().advance(1);
  if (scanner().character() == '.') scanner().advance(1);
  while (is_digit(scanner().character())) scanner().advance(1);
  scanner().skip_blanks(LineEnds::significant);
  return number.value_or(-1);
}

MaybeStatement Parser::parse_kind(int skip_level) {
  const char c = scanner().character();
  const char next = scanner().character(1);
  if (c == '#') return is_name_start(next) ? directives_.parse_directive() : iso_.parse_iso();
  std::size_t behind = 1;
  while (is_blank(scanner().character(behind))) ++behind;
  const char label = scanner().character(behind);
  const bool o_line = is_digit(label) || label == '<' || label == '[' || label == '#';
  const bool program_letter = is_program_letter(c, cursor_.source().rules());
  if (program_letter && (c == ':' ? is_digit(next) : o_line))
    return o_lines_.parse_o_line(skip_level);
  if (c == '{') return statements_.parse_compound();
  if (c == '[' && cursor_.source().rules().is_fanuc())
    return macro_lines_.parse_conditional_return();
  if (c == '(' || c == '@' || c == '^' || c == '$') return iso_.parse_iso();
  if (c == ',' && upper_case(next) == 'A') return iso_.parse_iso();  // a line by its angle
  if (is_letter(c) && !is_name_start(next)) return iso_.parse_iso();
  if (is_name_start(c)) return parse_named_start();
  const Token token = scanner().peek(LineEnds::significant);
  const bool foreign =
      static_cast<unsigned char>(c) >= 0x80 || static_cast<unsigned char>(c) < 0x20;
  if (foreign) {
    report_illegal_character(cursor_);
  } else {
    Diagnostic& unexpected = cursor_.report_unexpected(token, "a statement");
    if (c == ':' && upper_case(next) == 'O')
      unexpected.help.emplace_back("a program number is `O1001` or `:1001`, not both");
  }
  return std::nullopt;
}

// A statement that begins with at least two letters.
MaybeStatement Parser::parse_named_start() {
  const std::string written = folded(scanner().name_ahead());
  const std::string name = with_whole_keyword(written, cursor_.source().rules());
  std::size_t next = written.size();
  while (is_blank(scanner().character(next))) ++next;
  const char behind = scanner().character(next);
  const bool macro_condition =
      (name == "if" || name == "while" || name == "wh") && (behind == '[' || behind == '#');
  const bool macro_number = (name == "do" || name == "end") && is_digit(behind);
  const bool prints = ((name == "dprnt" || name == "bprnt") && behind == '[') ||
                      ((name == "popen" || name == "pclos") && !is_name_start(behind) &&
                       behind != '(' && behind != '=');
  if (prints || macro_condition || macro_number || name == "goto" || is_numbered(name, "goto") ||
      is_numbered(name, "do") || is_numbered(name, "end")) {
    return macro_lines_.parse_macro_line();
  }
  if (type_of_keyword(name) || name == "const" || name == "shared") {
    return declarations_.parse_declaration_or_function();
  }
  if (is_keyword(name)) return statements_.parse_keyword(name);
  if (iso_.is_named_address(name)) return iso_.parse_iso();
  if (behind == '[' && is_bracket_function(std::string_view(name).substr(1)))
    return iso_.parse_iso();
  if (is_name_start(behind) && !type_of_other_languages(name).empty()) return refuse_type(name);
  return statements_.parse_simple();
}

// `double x = 1;`
MaybeStatement Parser::refuse_type(const std::string& name) {
  const Token token = scanner().take(LineEnds::significant);
  reporter()
      .error("E3001", token.span, "unknown type `" + name + "`", "not a type")
      .help.push_back("write `" + std::string(type_of_other_languages(name)) + "`");
  const Token declared = scanner().peek(LineEnds::significant);
  if (declared.kind == TokenKind::name) reporter().spoil(declared.text, declared.span.offset);
  return std::nullopt;
}

// To the next place where a statement can begin.
void Parser::recover(std::size_t start) {
  if (scanner().offset() != start && cursor_.at_body_end()) return;
  const std::string word = folded(cursor_.source().text().substr(start, 6));
  for (const std::string_view keyword : {"for", "while", "if", "switch"}) {
    if (word.starts_with(keyword) && !is_name_part(word.c_str()[keyword.size()]))
      return recover_from_header(start);
  }
  const bool is_declaration =
      type_of_keyword(word.substr(0, word.find_first_of(" \t"))).has_value();
  if (is_declaration && opens_braces(start)) return recover_from_header(start);
  if (scanner().offset() == start) scanner().advance(1);
  while (!scanner().at_line_end()) {
    if (scanner().character() == '}' && cursor_.inside_braces()) return;
    const bool done = scanner().character() == ';';
    scanner().advance(1);
    if (done) return;
  }
}

// Does the declaration at `start` open a body on its line?
bool Parser::opens_braces(std::size_t start) const {
  const std::string_view text = cursor_.source().text();
  const std::size_t at = text.find_first_of("\r\n;{", start);
  return at != std::string_view::npos && text[at] == '{';
}

// Behind the line of a `for`, `while`, `if` or `switch`: parts of its header are no statements. The
// braces that it opens are closed by lines that are.
void Parser::recover_from_header(std::size_t start) {
  while (!scanner().at_line_end()) scanner().advance(1);
  for (const char c : cursor_.source().text().substr(start, scanner().offset() - start)) {
    if (c == '{') ++headless_braces_;
    if (c == '}' && headless_braces_ > 0) --headless_braces_;
  }
}

// The brace, and an `else` behind it.
void Parser::close_headless() {
  --headless_braces_;
  scanner().advance(1);
  scanner().skip_blanks(LineEnds::significant);
  const std::size_t start = scanner().offset();
  if (folded(scanner().name_ahead()) == "else") recover_from_header(start);
}

void Parser::keep_faulty(StatementList& list, std::size_t start, std::uint32_t line) {
  if (!reporter().is_soft(start)) return;
  Statement statement;
  statement.span = {start, 1, line};
  statement.kind = FaultyText{reporter().last_error()};
  list.push_back(std::move(statement));
}

}  // namespace stanok::lang
