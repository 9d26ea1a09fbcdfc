// CompileWatch: ends a compilation that nobody waits for any more, and one whose tree would take
// more memory than a machine has.
//
// The parser calls it at each statement and each plain line, the compiler at each statement. It
// ends them by an exception, which compile() turns into an error of the program: what was
// made of it so far is dropped.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <utility>

#include "base/diagnostic.h"

namespace stanok::lang {

// Asked again and again while a program is compiled; true ends that.
using Interruption = std::function<bool()>;

class CompileEnd : public std::exception {
 public:
  explicit CompileEnd(Diagnostic reason) : reason_(std::move(reason)) {}

  [[nodiscard]] const char* what() const noexcept override { return reason_.message.c_str(); }
  [[nodiscard]] const Diagnostic& reason() const { return reason_; }

 private:
  Diagnostic reason_;
};

class CompileWatch {
 public:
  explicit CompileWatch(const Interruption& interrupted) : interrupted_(interrupted) {}

  // Throws CompileEnd with E6072 when the compilation was interrupted.
  void pass() const;
  // The same, and with E8002 at one statement too many.
  void count_statement();

 private:
  const Interruption& interrupted_;
  std::size_t statements_ = 0;  // of all files
};

}  // namespace stanok::lang
