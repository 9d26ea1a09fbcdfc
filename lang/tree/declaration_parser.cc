#include "lang/tree/declaration_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lang/text/limits.h"
#include "lang/tree/bracket_parser.h"
#include "lang/tree/builtin.h"
#include "lang/tree/keywords.h"
#include "lang/words/named_address.h"

namespace stanok::lang {
namespace {

Statement declaring_statement(Declaration declaration) {
  Statement statement;
  statement.kind = std::move(declaration);
  return statement;
}

// "do5", "end5"
bool begins_macro_line(std::string_view name) {
  for (const std::string_view word : {"do", "end"}) {
    if (!name.starts_with(word)) continue;
    const std::string_view rest = name.substr(word.size());
    return !rest.empty() && std::all_of(rest.begin(), rest.end(), is_digit);
  }
  return false;
}

// Why a name may not be declared; empty when it may.
std::string_view reason_against(std::string_view name) {
  const std::string wanted = folded(name);
  if (name.size() < 2 || !is_name_start(name[1])) {
    return "a name begins with two letters; this begins like a word of a block";
  }
  if (name.size() > limits::name_characters) return "a name has at most 64 characters";
  if (is_keyword(wanted)) return "it is a keyword";
  if (is_reserved_word(wanted)) return "it is a reserved word";
  if (!find_named_address(wanted).empty()) return "it is an address in blocks, as in `dS=0.1`";
  if (find_builtin(wanted) != nullptr || find_builtin_constant(wanted)) return "it is built in";
  if (is_bracket_function(std::string_view(wanted).substr(1))) {
    return "it reads like a word with a function, as in `Xsin[30]`";
  }
  if (begins_macro_line(wanted)) return "it reads like a line of a macro, as in `DO1`";
  return {};
}

}  // namespace

std::set<std::string> defined_functions(const Source& source) {
  static constexpr auto types = std::to_array<std::string_view>({"num", "bool", "string", "void"});
  const std::string_view text = source.text().substr(0, source.end());
  std::set<std::string> names;
  for (std::size_t at = text.find('('); at != std::string_view::npos; at = text.find('(', at + 1)) {
    std::size_t end = at;
    while (end > 0 && is_blank(text[end - 1])) --end;
    std::size_t start = end;
    while (start > 0 && is_name_part(text[start - 1])) --start;
    std::size_t type_end = start;
    while (type_end > 0 && is_blank(text[type_end - 1])) --type_end;
    std::size_t type_start = type_end;
    while (type_start > 0 && is_name_part(text[type_start - 1])) --type_start;
    if (end == start || type_end == start) continue;
    const std::string type = folded(text.substr(type_start, type_end - type_start));
    for (const std::string_view known : types) {
      if (type == known) names.insert(folded(text.substr(start, end - start)));
    }
  }
  return names;
}

bool DeclarationParser::check_declared_name(const Token& name) {
  if (name.kind != TokenKind::name) {
    cursor_.report_unexpected(name, "a name");
    return false;
  }
  const std::string_view reason = reason_against(name.text);
  if (reason.empty()) return true;
  reporter_.spoil(name.text, name.span.offset);
  Diagnostic& diagnostic =
      reporter_.error("E3003", name.span, "`" + std::string(name.text) + "` cannot be declared",
                      std::string(reason));
  if (name.text.size() == 1) diagnostic.help.emplace_back("write a longer name, e.g. `index`");
  return false;
}

// [const|shared] type name ...
MaybeStatement DeclarationParser::parse_declaration_or_function() {
  cursor_.set_line_ends(LineEnds::blank);
  Declaration declaration;
  Token token = scanner_.take(LineEnds::blank);
  if (folded(token.text) == "shared") {
    declaration.shared = true;
    token = scanner_.take(LineEnds::blank);
  }
  if (folded(token.text) == "const") {
    declaration.constant = true;
    token = scanner_.take(LineEnds::blank);
  }
  const auto type = type_of_keyword(folded(token.text));
  if (!type) {
    cursor_.report_unexpected(token, "a type");
    return std::nullopt;
  }
  declaration.type = *type;
  const Token name = scanner_.peek(LineEnds::blank);
  if (!check_declared_name(name)) return std::nullopt;
  const std::size_t offset = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.take(LineEnds::blank);
  if (!declaration.constant && !declaration.shared && scanner_.peek(LineEnds::blank).is("(")) {
    auto function = parse_function(*type, name);
    if (!function) reporter_.spoil(name.text, name.span.offset);
    return function;
  }
  scanner_.move_to(offset, line);
  if (*type == Type::none) {
    reporter_.spoil(name.text, name.span.offset);
    reporter_.error("E3004", token.span, "a variable cannot be `void`", "not a type of values");
    return std::nullopt;
  }
  return parse_items(std::move(declaration));
}

MaybeStatement DeclarationParser::parse_items(Declaration declaration) {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  do {
    if (!cursor_.check_length(start, line)) return std::nullopt;
    const Token name = scanner_.take(LineEnds::blank);
    if (!check_declared_name(name)) return spoilt(declaration);
    DeclaredItem item;
    item.name = name.text;
    item.span = name.span;
    declaration.items.push_back(std::move(item));
    DeclaredItem& declared = declaration.items.back();
    if (!parse_dimensions(declared) || !parse_initial(declared)) return spoilt(declaration);
  } while (cursor_.accept(","));
  if (!cursor_.expect(";", "the declaration")) return spoilt(declaration);
  return declaring_statement(std::move(declaration));
}

// The names of a declaration at fault are not told again where they are used.
MaybeStatement DeclarationParser::spoilt(const Declaration& declaration) {
  for (const DeclaredItem& item : declaration.items) reporter_.spoil(item.name, item.span.offset);
  return std::nullopt;
}

bool DeclarationParser::parse_dimensions(DeclaredItem& item) {
  while (cursor_.accept("[")) {
    if (cursor_.accept("]")) {
      item.dimension_from_list = true;
      continue;
    }
    auto size = expressions_.parse_expression(LineEnds::blank);
    if (!size || !cursor_.expect("]", "the size")) return false;
    item.dimensions.push_back(std::move(*size));
  }
  const std::size_t count = item.dimensions.size() + (item.dimension_from_list ? 1 : 0);
  if (count <= 2 && !(item.dimension_from_list && count > 1)) return true;
  reporter_.error("E3017", item.span, "an array has one or two dimensions of a given size",
                  "too many dimensions");
  return false;
}

bool DeclarationParser::parse_initial(DeclaredItem& item) {
  if (!cursor_.accept("=")) return true;
  if (cursor_.accept("{")) {
    item.has_list = true;
    return expressions_.parse_list("}", item.initial_list);
  }
  item.initial = expressions_.parse_expression(LineEnds::blank);
  return item.initial.has_value();
}

MaybeStatement DeclarationParser::parse_function(Type result, const Token& name) {
  if (!cursor_.at_file_level()) {
    reporter_.error("E2012", name.span, "a function is inside braces or O-lines",
                    "functions are defined at file level");
    return std::nullopt;
  }
  FunctionDefinition function;
  function.result = result;
  function.name = name.text;
  function.name_span = name.span;
  scanner_.take(LineEnds::blank);
  if (!cursor_.accept(")")) {
    do {
      auto parameter = parse_parameter();
      if (!parameter) return std::nullopt;
      function.parameters.push_back(std::move(*parameter));
    } while (cursor_.accept(","));
    if (!cursor_.expect(")", "the parameters")) return std::nullopt;
  }
  auto body = bodies_.parse_body(name.text);
  if (!body) return std::nullopt;
  function.body = std::move(*body);
  Statement statement;
  statement.kind = std::move(function);
  return statement;
}

// type [&] name [[]] [= value]
std::optional<FunctionParameter> DeclarationParser::parse_parameter() {
  FunctionParameter parameter;
  const Token type_token = scanner_.take(LineEnds::blank);
  const auto type = type_of_keyword(folded(type_token.text));
  if (!type || *type == Type::none) {
    cursor_.report_unexpected(type_token, "the type of a parameter");
    return std::nullopt;
  }
  parameter.type = *type;
  parameter.reference = cursor_.accept("&");
  const Token name = scanner_.take(LineEnds::blank);
  if (!check_declared_name(name)) return std::nullopt;
  parameter.name = name.text;
  parameter.span = name.span;
  if (cursor_.accept("[")) {
    if (!cursor_.expect("]", "`[`")) return std::nullopt;
    parameter.array = true;
  }
  if (cursor_.accept("=")) {
    parameter.initial = expressions_.parse_expression(LineEnds::blank);
    if (!parameter.initial) return std::nullopt;
  }
  return parameter;
}

}  // namespace stanok::lang
