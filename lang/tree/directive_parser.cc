#include "lang/tree/directive_parser.h"

#include <array>
#include <utility>

#include "lang/contract/code_number.h"

namespace stanok::lang {
namespace {

constexpr auto directives = std::to_array<std::string_view>(
    {"include", "kinematics", "workpiece", "workpiece_pos", "feedlaw", "tool_overhang", "adaptive",
     "orientation", "plane"});

using ForceKind = ForceControl::Kind;

struct AdaptiveForm {
  std::string_view name;
  ForceKind kind;
  std::size_t least;  // values
  std::size_t most;
  std::string_view example;
};

constexpr auto adaptive_forms = std::to_array<AdaptiveForm>({
    {"off", ForceKind::off, 0, 0, "`#adaptive (off)`"},
    {"force", ForceKind::force, 1, 3,
     "`#adaptive (force, P_z)` or `#adaptive (force, P_z, S_min, S_max)`"},
    {"oscillate", ForceKind::oscillate, 2, 2, "`#adaptive (oscillate, P_osc, f)`"},
    {"vibration", ForceKind::vibration_on, 0, 3,
     "`#adaptive (vibration, on)`, `#adaptive (vibration, on, level, m_d, f)` or "
     "`#adaptive (vibration, off)`"},
    {"depth", ForceKind::depth, 1, 1, "`#adaptive (depth, t)`"},
});

const AdaptiveForm* adaptive_form_called(std::string_view name) {
  for (const AdaptiveForm& form : adaptive_forms) {
    if (form.name == name) return &form;
  }
  return nullptr;
}

// A way of G68.2 to say how a tilted plane lies, under a name: one block, or several with Q from 1
// on. `letters` take the values of a block; behind all of them may stand X, Y, Z of its zero.
struct PlaneForm {
  std::string_view name;
  int p;                     // P of G68.2
  int q;                     // of the one block; 0: none, or the blocks are counted
  std::string_view letters;  // of each block
  std::size_t blocks;
  bool has_zero;  // otherwise its first values are the zero
  std::string_view example;
};

constexpr auto plane_forms = std::to_array<PlaneForm>({
    {"spatial", 1, 123, "IJK", 1, true, "`#plane (spatial, A, B, C)`"},
    {"euler", 0, 0, "IJK", 1, true, "`#plane (euler, I, J, K)`"},
    {"projected", 4, 0, "IJK", 1, true, "`#plane (projected, A, B, K)`"},
    {"vectors", 3, 0, "IJK", 2, true, "`#plane (vectors, XX, XY, XZ, ZX, ZY, ZZ)`"},
    {"points", 2, 0, "XYZ", 3, false, "`#plane (points, X1, Y1, Z1, X2, Y2, Z2, X3, Y3, Z3)`"},
});

constexpr CodeNumber tilts = g(68, 2);
constexpr CodeNumber ends_plane = g(69);

const PlaneForm* plane_form_called(std::string_view name) {
  for (const PlaneForm& form : plane_forms) {
    if (form.name == name) return &form;
  }
  return nullptr;
}

IsoWord word_of(char letter, Expression value) {
  IsoWord word;
  word.span = value.span;
  word.name.letter = letter;
  word.value = std::move(value);
  return word;
}

IsoWord word_of(char letter, int number, const Span& span) {
  Expression value;
  value.number = number;
  value.span = span;
  IsoWord word = word_of(letter, std::move(value));
  word.whole = true;
  return word;
}

IsoWord word_of_code(CodeNumber code, const Span& span) {
  IsoWord word = word_of('G', 0, span);
  word.name.code = code;
  word.value.number = code / 10.0;
  return word;
}

// The blocks of G68.2 that say the same.
StatementList blocks_of(const PlaneForm& form, std::vector<Expression> values, const Span& span) {
  StatementList blocks;
  const std::size_t said = form.letters.size() * form.blocks;
  for (std::size_t k = 0; k < form.blocks; ++k) {
    IsoBlock block;
    block.words.push_back(word_of_code(tilts, span));
    block.words.push_back(word_of('P', form.p, span));
    const int q = form.blocks > 1 ? static_cast<int>(k) + 1 : form.q;
    if (q != 0) block.words.push_back(word_of('Q', q, span));
    for (std::size_t i = 0; i < form.letters.size(); ++i)
      block.words.push_back(
          word_of(form.letters[i], std::move(values[k * form.letters.size() + i])));
    for (std::size_t i = said; k == 0 && i < values.size(); ++i)
      block.words.push_back(word_of("XYZ"[i - said], std::move(values[i])));
    Statement statement;
    statement.span = span;
    statement.kind = std::move(block);
    blocks.push_back(std::move(statement));
  }
  return blocks;
}

}  // namespace

MaybeStatement DirectiveParser::parse_directive() {
  const Span hash = scanner_.here();
  scanner_.advance(1);
  const std::string_view name = scanner_.name_ahead();
  const Span span = joined(hash, scanner_.here(static_cast<std::uint32_t>(name.size())));
  const std::string wanted = folded(name);
  scanner_.advance(name.size());
  if (wanted == "include") return parse_include();
  if (wanted == "kinematics") return parse_kinematics();
  if (wanted == "workpiece" || wanted == "workpiece_pos") {
    return parse_workpiece(
        wanted == "workpiece" ? WorkpieceForm::announcement : WorkpieceForm::position, span);
  }
  if (wanted == "tool_overhang") return parse_tool_overhang(span);
  if (wanted == "feedlaw") return parse_feed_law(span);
  if (wanted == "adaptive") return parse_adaptive(span);
  if (wanted == "orientation") return parse_orientation();
  if (wanted == "plane") return parse_plane(span);
  Diagnostic& diagnostic = reporter_.error(
      "E2010", span, "unknown directive `#" + std::string(name) + "`", "no such directive");
  const std::string_view nearest = nearest_name(name, {directives.begin(), directives.end()});
  if (!nearest.empty()) diagnostic.help.push_back("did you mean `#" + std::string(nearest) + "`?");
  scanner_.skip_to_line_end();
  return std::nullopt;
}

MaybeStatement DirectiveParser::parse_include() {
  const Token file = scanner_.take(LineEnds::significant);
  if (file.kind != TokenKind::string) {
    cursor_.report_unexpected(file, "a file name in quotes after `#include`");
    return std::nullopt;
  }
  if (!cursor_.at_file_level()) {
    reporter_.error("E2012", file.span, "`#include` inside braces or O-lines",
                    "belongs at file level");
    return std::nullopt;
  }
  if (!cursor_.finish_line()) return std::nullopt;
  if (included_functions_) {
    functions_.merge(included_functions_(file.string));
  }
  Statement statement;
  statement.kind = IncludeDirective{file.string, file.span};
  return statement;
}

MaybeStatement DirectiveParser::parse_kinematics() {
  cursor_.set_line_ends(LineEnds::significant);
  KinematicsDirective directive;
  const Span span = scanner_.here();
  if (!cursor_.expect("(", "`#kinematics`")) return std::nullopt;
  if (!expressions_.parse_list(")", directive.arguments) || !cursor_.finish_line())
    return std::nullopt;
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

MaybeStatement DirectiveParser::parse_tool_overhang(const Span& name) {
  cursor_.set_line_ends(LineEnds::significant);
  ToolOverhangDirective directive;
  if (!cursor_.expect("(", "`#tool_overhang`")) return std::nullopt;
  if (!expressions_.parse_list(")", directive.arguments) || !cursor_.finish_line())
    return std::nullopt;
  if (directive.arguments.size() > 2) {
    reporter_
        .error("E3005", name, "`#tool_overhang` takes a value and an axis",
               "the number of arguments is wrong")
        .help.push_back(
            "write `#tool_overhang (35)`, `#tool_overhang (35, X)`, or `()` for the "
            "value of the tool table");
    return std::nullopt;
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

// A text in the place of the first size is the file of the blank.
MaybeStatement DirectiveParser::parse_workpiece(WorkpieceForm form, const Span& name) {
  constexpr std::ptrdiff_t file_argument = 3;
  const bool position = form == WorkpieceForm::position;
  cursor_.set_line_ends(LineEnds::significant);
  WorkpieceDirective directive;
  directive.position = position;
  const std::string text = position ? "`#workpiece_pos`" : "`#workpiece`";
  if (!cursor_.expect("(", text)) return std::nullopt;
  if (!expressions_.parse_list(")", directive.arguments) || !cursor_.finish_line())
    return std::nullopt;
  const bool has_file = !position && std::ssize(directive.arguments) > file_argument &&
                        directive.arguments[std::size_t{file_argument}].node == Node::string;
  const std::size_t given = directive.arguments.size();
  const std::size_t wanted = position ? 6 : has_file ? 7 : 9;
  if (given != wanted && !(has_file && given == wanted + 1)) {
    reporter_
        .error(
            "E3005", name,
            text + " takes " + std::to_string(wanted) + " arguments, not " + std::to_string(given),
            "the number of arguments is wrong")
        .help.push_back(position ? "write `#workpiece_pos (x, y, z, psi, theta, phi)`"
                        : has_file
                            ? "write `#workpiece (2, resolution, machining, \"file.stl\", zero_X, "
                              "zero_Y, zero_Z)`; add the scale at the end if the file is not in mm"
                            : "write `#workpiece (type, resolution, machining, X, Y, Z, "
                              "zero_X, zero_Y, zero_Z)`");
    return std::nullopt;
  }
  if (has_file) {
    const auto argument = directive.arguments.begin() + file_argument;
    directive.file = argument->text;
    directive.file_span = argument->span;
    directive.arguments.erase(argument);
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

// #adaptive: force control. `force`, `oscillate`, `depth` and `off` take values, `vibration` says
// on or off before them.
MaybeStatement DirectiveParser::parse_adaptive(const Span& name) {
  cursor_.set_line_ends(LineEnds::significant);
  if (!cursor_.expect("(", "`#adaptive`")) return std::nullopt;
  const Token word = scanner_.take(cursor_.line_ends());
  const AdaptiveForm* const form =
      word.kind == TokenKind::name ? adaptive_form_called(folded(word.text)) : nullptr;
  if (form == nullptr) {
    cursor_.report_unexpected(word, "`force`, `oscillate`, `vibration`, `depth` or `off`");
    return std::nullopt;
  }
  AdaptiveDirective directive{form->kind, {}};
  if (form->kind == ForceKind::vibration_on && !parse_vibration_switch(directive))
    return std::nullopt;
  const bool good = cursor_.accept(",") ? expressions_.parse_list(")", directive.arguments)
                                        : cursor_.expect(")", "a command of `#adaptive`");
  if (!good || !cursor_.finish_line()) return std::nullopt;
  const std::size_t given = directive.arguments.size();
  // The clamps come together, as do the values of the oscillation.
  const bool has_some = given == 2 && form->most == 3;
  const bool is_switched_off = directive.kind == ForceKind::vibration_off && given > 0;
  const bool has_one_of_three = given == 1 && form->kind == ForceKind::vibration_on;
  if (given < form->least || given > form->most || has_some || has_one_of_three ||
      is_switched_off) {
    reporter_
        .error("E3005", name, "`#adaptive` does not take these values", "wrong number of values")
        .help.push_back("write " + std::string(form->example));
    return std::nullopt;
  }
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

// #orientation (vector), (axis) or ()
MaybeStatement DirectiveParser::parse_orientation() {
  cursor_.set_line_ends(LineEnds::significant);
  if (!cursor_.expect("(", "`#orientation`")) return std::nullopt;
  OrientationDirective directive;
  if (!cursor_.accept(")")) {
    const Token word = scanner_.take(cursor_.line_ends());
    const std::string way = word.kind == TokenKind::name ? folded(word.text) : std::string();
    if (way != "vector" && way != "axis") {
      cursor_.report_unexpected(word, "`vector` or `axis`");
      return std::nullopt;
    }
    directive.way = way == "vector" ? TurningWay::vector : TurningWay::axis;
    if (!cursor_.expect(")", "what `#orientation` takes")) return std::nullopt;
  }
  if (!cursor_.finish_line()) return std::nullopt;
  Statement statement;
  statement.kind = std::move(directive);
  return statement;
}

// #plane (FORM, ...) is the blocks of G68.2 of that form, #plane () is G69.
MaybeStatement DirectiveParser::parse_plane(const Span& name) {
  cursor_.set_line_ends(LineEnds::significant);
  if (!cursor_.expect("(", "`#plane`")) return std::nullopt;
  Statement statement;
  if (cursor_.accept(")")) {
    IsoBlock off;
    off.words.push_back(word_of_code(ends_plane, name));
    statement.kind = std::move(off);
    return cursor_.finish_line() ? MaybeStatement(std::move(statement)) : std::nullopt;
  }
  const Token word = scanner_.take(cursor_.line_ends());
  const PlaneForm* const form =
      word.kind == TokenKind::name ? plane_form_called(folded(word.text)) : nullptr;
  if (form == nullptr) {
    cursor_.report_unexpected(
        word,
        "`spatial`, `euler`, `projected`, `vectors`, `points`, or nothing between the brackets");
    return std::nullopt;
  }
  std::vector<Expression> values;
  if (!cursor_.expect(",", "`" + std::string(form->name) + "`") ||
      !expressions_.parse_list(")", values) || !cursor_.finish_line())
    return std::nullopt;
  const std::size_t said = form->letters.size() * form->blocks;
  if (values.size() != said && !(form->has_zero && values.size() == said + 3)) {
    reporter_
        .error("E3005", name,
               "`#plane (" + std::string(form->name) + ", ...)` takes " + std::to_string(said) +
                   " values" +
                   (form->has_zero ? ", or " + std::to_string(said + 3) + " with its zero" : ""),
               "the number of values is wrong")
        .help.push_back("write " + std::string(form->example) +
                        (form->has_zero ? ", followed by X, Y, Z of its zero" : ""));
    return std::nullopt;
  }
  StatementList blocks = blocks_of(*form, std::move(values), name);
  if (blocks.size() == 1) return std::move(blocks.front());
  statement.kind = Compound{std::move(blocks)};
  return statement;
}

bool DirectiveParser::parse_vibration_switch(AdaptiveDirective& directive) {
  if (!cursor_.expect(",", "`vibration`")) return false;
  const Token word = scanner_.take(cursor_.line_ends());
  const std::string wanted = folded(word.text);
  if (word.kind != TokenKind::name || (wanted != "on" && wanted != "off")) {
    cursor_.report_unexpected(word, "`on` or `off`");
    return false;
  }
  directive.kind = wanted == "on" ? ForceKind::vibration_on : ForceKind::vibration_off;
  return true;
}

}  // namespace stanok::lang
