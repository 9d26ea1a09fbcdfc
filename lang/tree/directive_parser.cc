// Directives and the macro lines of other controls.
#include <array>
#include <utility>

#include "lang/tree/parser.h"

namespace stanok::lang {
namespace {

constexpr auto directives =
    std::to_array<std::string_view>({"include", "kinematics", "workpiece", "workpiece_pos",
                                     "feedlaw", "tool_overhang", "adaptive"});

}  // namespace

Parser::MaybeStatement Parser::parse_directive() {
  const Span hash = scanner_.here();
  scanner_.advance(1);
  const std::string_view name = scanner_.name_ahead();
  const Span span = joined(hash, scanner_.here(static_cast<std::uint32_t>(name.size())));
  const std::string wanted = folded(name);
  scanner_.advance(name.size());
  if (wanted == "include") return parse_include();
  if (wanted == "kinematics") return parse_kinematics();
  if (wanted == "workpiece" || wanted == "workpiece_pos") {
    return parse_workpiece(wanted == "workpiece_pos", span);
  }
  if (wanted == "tool_overhang") return parse_tool_overhang(span);
  if (wanted == "feedlaw") return parse_feed_law(span);
  if (wanted == "adaptive") return parse_adaptive(span);
  Diagnostic& diagnostic = reporter_.error(
      "E2010", span, "unknown directive `#" + std::string(name) + "`", "no such directive");
  const std::string_view nearest = nearest_name(name, {directives.begin(), directives.end()});
  if (!nearest.empty()) diagnostic.help.push_back("did you mean `#" + std::string(nearest) + "`?");
  scanner_.skip_to_line_end();
  return std::nullopt;
}

Parser::MaybeStatement Parser::parse_include() {
  const Token file = scanner_.take(LineEnds::significant);
  if (file.kind != TokenKind::string) {
    report_unexpected(file, "a file name in quotes after `#include`");
    return std::nullopt;
  }
  if (inside_braces() || o_depth_ > 0) {
    reporter_.error("E2012", file.span, "`#include` inside braces or O-lines",
                    "belongs at file level");
    return std::nullopt;
  }
  if (!finish_line()) return std::nullopt;
  if (context_.included_functions) {
    functions_.merge(context_.included_functions(file.string));
  }
  Statement statement;
  statement.kind = IncludeDirective{file.string, file.span};
  return statement;
}

Parser::MaybeStatement Parser::parse_kinematics() {
  line_ends_ = LineEnds::significant;
  KinematicsDirective directive;
  const Span span = scanner_.here();
  if (!expect("(", "`#kinematics`")) return std::nullopt;
  if (!parse_list(")", directive.arguments) || !finish_line()) return std::nullopt;
  if (directive.arguments.size() != 2) {
    reporter_
        .error("E3005", span, "`#kinematics` takes two arguments",
               "scheme and channel are expected")
        .help.push_back("write e.g. `#kinematics (1, 1)`");
    return std::nullopt;
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

Parser::MaybeStatement Parser::parse_macro_line() {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  const std::string name = folded(scanner_.name_ahead());
  scanner_.skip_to_line_end();
  std::string equivalent = "if (condition) { ... }";
  if (name == "while" || name.starts_with("do") || name.starts_with("end")) {
    equivalent = "while (condition) { ... }";
  }
  reporter_
      .error("E2040", scanner_.span_from(start, line),
             "macro lines of other controls are not supported in this release", "")
      .help.push_back("write `" + equivalent + "`");
  return std::nullopt;
}

Parser::MaybeStatement Parser::parse_tool_overhang(const Span& name) {
  line_ends_ = LineEnds::significant;
  ToolOverhangDirective directive;
  if (!expect("(", "`#tool_overhang`")) return std::nullopt;
  if (!parse_list(")", directive.arguments) || !finish_line()) return std::nullopt;
  if (directive.arguments.size() > 2) {
    reporter_
        .error("E3005", name, "`#tool_overhang` takes a value and an axis",
               "wrong number of arguments")
        .help.push_back(
            "write `#tool_overhang (35)`, `#tool_overhang (35, X)`, or `()` for the "
            "value of the tool table");
    return std::nullopt;
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

Parser::MaybeStatement Parser::parse_workpiece(bool position, const Span& name) {
  line_ends_ = LineEnds::significant;
  WorkpieceDirective directive;
  directive.position = position;
  const std::string text = position ? "`#workpiece_pos`" : "`#workpiece`";
  if (!expect("(", text)) return std::nullopt;
  if (!parse_list(")", directive.arguments) || !finish_line()) return std::nullopt;
  const std::size_t wanted = position ? 6 : 9;
  if (directive.arguments.size() != wanted) {
    reporter_
        .error("E3005", name,
               text + " takes " + std::to_string(wanted) + " arguments, not " +
                   std::to_string(directive.arguments.size()),
               "wrong number of arguments")
        .help.push_back(position
                            ? "write `#workpiece_pos (x, y, z, psi, theta, phi)`"
                            : "write `#workpiece (type, resolution, machining, X, Y, Z, zero_X, "
                              "zero_Y, zero_Z)`");
    return std::nullopt;
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

}  // namespace stanok::lang
