#include "lang/text/compile_watch.h"

#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

[[noreturn]] void end_with(std::string code, std::string message) {
  Diagnostic reason;
  reason.code = std::move(code);
  reason.message = std::move(message);
  throw CompileEnd(std::move(reason));
}

}  // namespace

void CompileWatch::pass() const {
  if (interrupted_ && interrupted_()) end_with("E6072", "loading the program was cancelled");
}

void CompileWatch::count_statement() {
  pass();
  if (++statements_ > limits::statements)
    end_with("E8002", "the program has more than 1000000 statements in addition to plain blocks");
}

}  // namespace stanok::lang
