#include "lang/program/compiler.h"

#include <utility>

namespace stanok::lang {

Compiler::Compiler(const CompilerContext& context)
    : context_(context),
      reporter_(context_.reporter),
      file_(context_.compiled()),
      channel_words_(words_of_channel(context_.channel)),
      code_(file_),
      symbols_(context_, code_),
      expressions_(context_, code_, symbols_, channel_words_ ? &*channel_words_ : nullptr),
      variables_(context_, code_, symbols_, expressions_),
      control_(context_, code_, symbols_, expressions_, *this),
      routines_(context_, code_, symbols_, expressions_, *this),
      directives_(context_, code_, symbols_, expressions_),
      iso_(context_, code_, symbols_, expressions_, channel_words_ ? &*channel_words_ : nullptr) {}

void Compiler::declare_names(const StatementList& tree) {
  for (const Statement& statement : tree) {
    if (const auto* const declaration = std::get_if<Declaration>(&statement.kind)) {
      declare_constants(*declaration);
    }
  }
  for (const Statement& statement : tree) {
    if (const auto* const function = std::get_if<FunctionDefinition>(&statement.kind)) {
      routines_.declare(*function);
    }
    if (const auto* const subprogram = std::get_if<OSubprogram>(&statement.kind)) {
      routines_.declare(*subprogram);
    }
  }
}

void Compiler::declare_constants(const Declaration& declaration) {
  if (!declaration.constant) return;
  for (const DeclaredItem& item : declaration.items) {
    if (!item.initial) continue;
    auto constant = symbols_.constant_of(*item.initial);
    if (constant && constant->type == declaration.type) {
      context_.names[context_.file].constants.emplace(folded(item.name), std::move(*constant));
    }
  }
}

void Compiler::compile(const StatementList& tree) {
  for (const Statement& statement : tree) {
    file_.entries.push_back(code_.position());
    compile_statement(statement);
  }
  code_.emit(Op::end_of_text,
             {file_.source.end(), 0, file_.source.line_number(file_.source.end())});
  for (const Statement& statement : tree) {
    if (const auto* const function = std::get_if<FunctionDefinition>(&statement.kind)) {
      routines_.compile_routine(*function);
    }
    if (const auto* const subprogram = std::get_if<OSubprogram>(&statement.kind)) {
      routines_.compile_routine(*subprogram);
    }
  }
}

void Compiler::compile_list(const StatementList& list) {
  for (const Statement& statement : list) compile_statement(statement);
}

void Compiler::compile_body(const StatementList& list) {
  symbols_.open_scope();
  compile_list(list);
  symbols_.close_scope();
}

template <class Kind>
void Compiler::compile_kind(const Kind& kind) {
  if constexpr (requires { variables_.compile(kind); }) {
    variables_.compile(kind);
  } else if constexpr (requires { control_.compile(kind); }) {
    control_.compile(kind);
  } else if constexpr (requires { routines_.compile(kind); }) {
    routines_.compile(kind);
  } else if constexpr (requires { directives_.compile(kind); }) {
    directives_.compile(kind);
  } else if constexpr (requires { iso_.compile(kind); }) {
    iso_.compile(kind);
  } else if constexpr (requires { expressions_.calls().compile(kind); }) {
    expressions_.calls().compile(kind);
  } else {
    compile_own(kind);
  }
}

void Compiler::compile_statement(const Statement& statement) {
  context_.watch.pass();
  code_.set_statement_span(statement.span);
  const std::size_t errors = reporter_.error_count();
  const std::size_t start = file_.code.size();
  std::optional<std::size_t> skip;
  if (statement.number >= 0) {
    file_.numbered_statements.push_back({statement.number, code_.position(), statement.span.line});
  }
  if (statement.skip_level != 0) {
    skip = code_.emit(Op::jump_if_skipped, statement.span, 0,
                      static_cast<std::uint8_t>(statement.skip_level));
  }
  std::visit([this](const auto& kind) { compile_kind(kind); }, statement.kind);
  if (reporter_.error_count() != errors && reporter_.is_soft(statement.span.offset)) {
    code_.drop_from(start);
    control_.forget_jumps_from(start);
    compile_own(FaultyText{reporter_.last_error()});
    return;
  }
  if (skip) code_.patch(*skip);
}

void Compiler::compile_own(const PlainLines& lines) {
  file_.plain_lines.push_back(lines);
  code_.emit(Op::plain_lines, code_.statement_span(),
             static_cast<std::uint32_t>(file_.plain_lines.size() - 1));
}

void Compiler::compile_own(const NumberedProgram& start) {
  if (!file_.numbered_programs.emplace(start.number, code_.position()).second) {
    reporter_.error("E3002", code_.statement_span(),
                    "program O" + std::to_string(start.number) + " appears twice in this file",
                    "this is the second program of this number");
  }
}

void Compiler::compile_own(const FaultyText& text) {
  file_.faults.push_back(text.fault);
  code_.emit(Op::raise, code_.statement_span(),
             static_cast<std::uint32_t>(file_.faults.size() - 1));
}

}  // namespace stanok::lang
