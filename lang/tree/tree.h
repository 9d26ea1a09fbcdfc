// The tree of a program text: what stands there, not yet what it means.
//
// Plain ISO lines are leaves that only know where they stand in the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lang/block/active_block.h"
#include "lang/contract/command.h"
#include "lang/text/reporter.h"
#include "lang/text/source.h"
#include "lang/tree/plain_block.h"

namespace stanok::lang {

enum class Type : std::uint8_t { none, number, boolean, string, axis, unknown };

// "num", "bool", ...
[[nodiscard]] std::string_view type_name(Type type);

enum class Operation : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  modulo,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  logical_and,
  logical_or,
  negate,
  identity,
  logical_not,
  // In brackets: numbers only, 1 and 0 for true and false, equal within 1e-6, MOD never negative.
  bracket_modulo,
  bracket_equal,
  bracket_not_equal,
  bracket_greater,
  bracket_greater_equal,
  bracket_less,
  bracket_less_equal,
  bracket_and,
  bracket_or,
  bracket_xor,
  // In brackets of the Fanuc dialect: MOD has the sign of the dividend, AND, OR and XOR work on the
  // bits of whole numbers.
  macro_modulo,
  macro_and,
  macro_or,
  macro_xor,
};

[[nodiscard]] constexpr bool is_comparison(Operation operation) {
  return operation >= Operation::less && operation <= Operation::not_equal;
}

enum class Node : std::uint8_t {
  number,
  boolean,
  string,
  name,     // a variable or constant
  element,  // children: indices; text: array
  call,     // children: arguments; text: function
  unary,
  binary,
  conditional,       // condition ? first : second
  parameter,         // #n; child: the number
  vacant_parameter,  // the same where a vacant #n stays vacant (Fanuc dialect)
  named_parameter,   // #<name>
  r_parameter,       // R5
  exists,            // EXISTS[#<name>]
  axis,              // an axis name as a value
  system_variable,   // $name, $name[index]
};

struct Expression {
  Node node = Node::number;
  Span span;
  Operation operation = Operation::add;
  double number = 0.0;  // number; boolean: 1 or 0; r_parameter: its index
  std::string text;     // names as written, strings as meant
  std::vector<Expression> children;
};

[[nodiscard]] inline Expression number_expression(double number, const Span& span) {
  Expression made;
  made.span = span;
  made.number = number;
  return made;
}

struct Statement;
using StatementList = std::vector<Statement>;

struct PlainLines {
  std::size_t begin = 0;  // offsets, whole lines
  std::size_t end = 0;
  std::uint32_t first_line = 0;
  Surroundings surroundings = Surroundings::file_level;
};

struct IsoWord {
  Span span;
  WordName name;  // G and M with a constant number: code is set
  Expression value;
  bool whole = false;  // a plain number without decimal point
};

// #5=..., #<name>=..., R5=...
struct ParameterSetting {
  Expression target;
  Expression value;
};

struct ActiveComment {
  Message::Kind kind = Message::Kind::message;
  Expression text;
  bool aborts = false;  // (ABORT,...): the text is that of an alarm which ends the program
};

struct IsoBlock {
  std::vector<ActiveComment> comments;
  std::vector<IsoWord> words;
  std::optional<Expression> spindle;  // after $
  std::vector<ParameterSetting> settings;
  std::string remark;  // the text of its last comment that does nothing by itself
};

// GOTO n of macro lines: to block N of the text.
struct JumpLine {
  Expression target;
};
struct IncludeDirective {
  std::string file;
  Span file_span;
};
struct KinematicsDirective {
  std::vector<Expression> arguments;
};
// #workpiece, #workpiece_pos
struct WorkpieceDirective {
  bool position = false;
  std::string file;  // of the blank; not among the arguments
  Span file_span;
  std::vector<Expression> arguments;
};
struct ToolOverhangDirective {
  std::vector<Expression> arguments;  // none, value, or value and axis
};
// #feedlaw (off), #feedlaw (curve, ways, feeds, speeds); other laws are an IsoBlock.
struct FeedLawDirective {
  std::vector<Expression> arguments;  // none: off
};
struct AdaptiveDirective {
  ForceControl::Kind kind = ForceControl::Kind::off;
  std::vector<Expression> arguments;
};
struct OrientationDirective {
  TurningWay way = TurningWay::of_code;
};
struct NumberedProgram {
  int number = 0;
};

// Which subprogram or loop an O-line means: O100, O<name>, or O[...] in a call.
struct OLabel {
  std::string name;                    // folded, numbers without leading zeros
  std::string written;                 // as it stands in the text
  std::optional<Expression> computed;  // the number, when it is known at run time only
  Span span;
};
struct OCall {
  OLabel label;
  std::vector<Expression> arguments;
};
struct OReturn {
  std::optional<Expression> value;
};
// O... sub to O... endsub
struct OSubprogram {
  OLabel label;
  StatementList body;
  std::optional<Expression> value;  // behind endsub
};
struct ORepeat {
  Expression count;
  StatementList body;
  std::string label;
};

struct DeclaredItem {
  std::string name;
  Span span;
  std::vector<Expression> dimensions;
  bool dimension_from_list = false;  // num a[] = {...}
  std::optional<Expression> initial;
  std::vector<Expression> initial_list;
  bool has_list = false;
};
struct Declaration {
  Type type = Type::number;
  bool constant = false;
  bool shared = false;  // one variable of all channels
  std::vector<DeclaredItem> items;
};
struct Assignment {
  Expression target;
  std::optional<Operation> combined;  // += and the like
  Expression value;
};
struct CallStatement {
  Expression call;
};
struct Compound {
  StatementList body;
};
struct If {
  Expression condition;
  StatementList then_body;
  StatementList else_body;
  bool is_macro_line = false;  // IF [..] of macro lines
};
struct While {
  Expression condition;
  StatementList body;
  std::string label;  // of O-lines, "end 1" of macro lines; empty: high-level text
};
struct DoWhile {
  StatementList body;
  Expression condition;
  std::string label;
};
struct For {
  StatementList start;
  std::optional<Expression> condition;
  StatementList step;
  StatementList body;
};
struct SwitchCase {
  std::vector<Expression> values;  // empty: default
  Span span;
  StatementList body;
};
struct Switch {
  Expression value;
  std::vector<SwitchCase> cases;
};
struct Break {
  std::string label;  // of O-lines: the loop that is meant; empty: the innermost one
};
struct Continue {
  std::string label;
};
struct Return {
  std::optional<Expression> value;
};
struct FunctionParameter {
  Type type = Type::number;
  bool reference = false;
  bool array = false;
  std::string name;
  Span span;
  std::optional<Expression> initial;
};
struct FunctionDefinition {
  Type result = Type::none;
  std::string name;
  Span name_span;
  std::vector<FunctionParameter> parameters;
  StatementList body;
};
// Text with an error that nothing reaches unless a subprogram call does.
struct FaultyText {
  Fault fault;
};

struct Statement {
  Span span;
  int skip_level = 0;  // 1..9: leading /
  int number = -1;     // N of the block; -1: none
  std::variant<PlainLines, IsoBlock, IncludeDirective, KinematicsDirective, WorkpieceDirective,
               ToolOverhangDirective, FeedLawDirective, AdaptiveDirective, OrientationDirective,
               NumberedProgram, Declaration, Assignment, CallStatement, Compound, If, While,
               DoWhile, For, Switch, Break, Continue, Return, FunctionDefinition, OSubprogram,
               OCall, OReturn, ORepeat, FaultyText, JumpLine>
      kind;
};

// A statement of this kind whose place is still to be filled in.
template <class Kind>
Statement statement_of(Kind kind) {
  Statement statement;
  statement.kind = std::move(kind);
  return statement;
}

}  // namespace stanok::lang
