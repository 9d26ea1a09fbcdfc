// Whether a run goes on, and why it failed: nothing else changes the stage of a run.
//
// Owner: ProgramExecution, on the thread of the preparation. Invariants: a failed run has an error,
// and the commands of the block that failed are gone from the queue, so that motion stops at the
// end of the block before.
#pragma once

#include <cstdint>
#include <utility>

#include "base/diagnostic.h"
#include "lang/block/command_queue.h"

namespace stanok::lang {

class RunStage {
 public:
  enum class Stage : std::uint8_t { idle, running, ended, failed };

  // `queue` must outlive this.
  explicit RunStage(CommandQueue& queue) : queue_(queue) {}

  [[nodiscard]] bool running() const { return stage_ == Stage::running; }
  [[nodiscard]] bool failed() const { return stage_ == Stage::failed; }
  [[nodiscard]] const Diagnostic& error() const { return error_; }
  // Line of the block whose fault ended the run; 0: another fault did.
  [[nodiscard]] std::uint32_t faulty_line() const { return faulty_line_; }

  void begin() { stage_ = Stage::running; }
  void end() { stage_ = Stage::ended; }
  void fail(Diagnostic diagnostic) {
    error_ = std::move(diagnostic);
    queue_.clear();
    faulty_line_ = 0;
    stage_ = Stage::failed;
  }
  // The words of the block in `line` were at fault: it can be passed.
  void blame_block(std::uint32_t line) { faulty_line_ = line; }
  void forget_error() {
    error_ = {};
    faulty_line_ = 0;
  }

 private:
  CommandQueue& queue_;
  Stage stage_ = Stage::idle;
  std::uint32_t faulty_line_ = 0;
  Diagnostic error_;
};

}  // namespace stanok::lang
