// Writes the code of one file: instructions with their spans, constants, jumps.
//
// Owner: Compiler. Writes into the CompiledFile. Invariant: spans stand parallel to the code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lang/program/code.h"
#include "lang/program/compiler_context.h"

namespace stanok::lang {

class CodeBuilder {
 public:
  // `file` must outlive this.
  explicit CodeBuilder(CompiledFile& file) : file_(file) {}

  // Returns where the instruction stands, for patch().
  std::size_t emit(Op op, const Span& span, std::uint32_t operand = 0, std::uint8_t count = 0,
                   std::uint16_t extra = 0);
  void push_number(double number, const Span& span);
  void push_text(std::string text, const Span& span);
  void push_constant(const Constant& constant, const Span& span);

  [[nodiscard]] std::uint32_t position() const;
  // Lets a jump lead to here, or to `target`.
  void patch(std::size_t jump);
  void patch_all(const std::vector<std::size_t>& jumps);
  void patch_all_to(const std::vector<std::size_t>& jumps, std::uint32_t target);
  // Forgets all code from there on.
  void drop_from(std::size_t start);

  // Of the statement that is compiled.
  [[nodiscard]] const Span& statement_span() const { return statement_span_; }
  void set_statement_span(const Span& span) { statement_span_ = span; }

 private:
  CompiledFile& file_;
  Span statement_span_;
};

// Who compiles the statements in a body.
class BodyCompiler {
 public:
  BodyCompiler() = default;
  BodyCompiler(const BodyCompiler&) = delete;
  BodyCompiler& operator=(const BodyCompiler&) = delete;
  virtual ~BodyCompiler() = default;

  virtual void compile_list(const StatementList& list) = 0;
  virtual void compile_body(const StatementList& list) = 0;  // with its own scope
};

}  // namespace stanok::lang
