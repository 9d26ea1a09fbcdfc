// What a run waits for: the request delivered last, and what becomes of its answer.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns what was kept for the answer. It
// decides what an answer means and does nothing itself: take() says what is to be pushed, done or
// reported. Invariants: an answer that nobody waits for is dropped; a use holds for one answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "lang/actions/actions.h"
#include "lang/actions/saved_state.h"
#include "lang/contract/command.h"
#include "lang/tree/value.h"

namespace stanok::lang {

// What becomes of an answer.
enum class AnswerUse : std::uint8_t {
  position_only,
  push_truth,
  push_number,
  push_text,
  input_result,    // M66
  feedback,        // of an output of the machine builder: without it the run fails
  statement,       // a false result fails the run
  restore_state,   // restore_gvector
  fail_run,        // terminate
  probe,           // G38.3
  probe_or_alarm,  // G38.2
  restart,         // the main program ended with M99
  overhang,        // #tool_overhang
  work_position,   // #5041 of the Fanuc dialect: where the axes stand
  timer            // #3001 is set
};

class PendingAnswer {
 public:
  // Why an answer fails the run.
  struct Refusal {
    std::string code;
    std::string message;
    std::string label;
    std::vector<Note> notes;
  };
  // What an answer comes to, in this order.
  struct Taken {
    std::optional<Value> pushed;
    std::optional<Refusal> refusal;
    AnswerUse use = AnswerUse::position_only;  // what is left to do, else position_only
  };
  // A builtin in statement form: what is reported when it returned false.
  struct Statement {
    std::string_view code;
    std::string_view name;
  };
  // The state that restore_gvector waits to restore, in statement form or not.
  struct Restoring {
    SavedState saved;
    bool is_statement = false;
  };

  // A digital input, and how long it was waited for.
  struct Feedback {
    int input = 0;
    bool on = false;
    double timeout_s = 0.0;
  };

  // A run begins: nothing is owed.
  void reset();

  // What becomes of the answer to the request made now. `unit`: mm or deg per unit of a number, to
  // which `shift` is added.
  void expect(AnswerUse use) { use_ = use; }
  void expect_number(double unit, double shift = 0.0);
  void expect_statement(const Statement& statement);
  void expect_restoring(Restoring restoring);
  void expect_overhang(const ToolOverhang& overhang);
  void expect_end(Diagnostic error);

  // The request is delivered; those that blocks make say themselves what their answer is for.
  // `origin`: where it was made.
  void deliver(const ProgramRequest& request, const Origin& origin = {});
  [[nodiscard]] const Origin& origin() const { return origin_; }
  [[nodiscard]] bool owed() const { return owed_; }

  // False when no answer was owed; from here on none is.
  [[nodiscard]] bool accept();
  [[nodiscard]] Taken take(const Answer& answer);

  // What was kept for the answer.
  [[nodiscard]] const Restoring& restoring() const { return restoring_; }
  [[nodiscard]] const ToolOverhang& overhang() const { return overhang_; }
  [[nodiscard]] const Diagnostic& end() const { return end_; }

  // The feedback that was waited for.
  [[nodiscard]] const Feedback& feedback() const { return feedback_; }

  // Why the last request was refused: channel_error ().
  [[nodiscard]] const std::string& channel_error() const { return channel_error_; }
  void set_channel_error(std::string_view text) { channel_error_ = text; }

 private:
  [[nodiscard]] Taken take_truth(const Answer& answer);
  [[nodiscard]] Taken take_number(const Answer& answer);
  [[nodiscard]] Taken take_statement(const Answer& answer);

  bool owed_ = false;
  Origin origin_;
  AnswerUse use_ = AnswerUse::position_only;
  double unit_ = 1.0;
  double shift_ = 0.0;
  Statement statement_;
  Restoring restoring_;
  ToolOverhang overhang_;
  Diagnostic end_;
  Feedback feedback_;
  std::string channel_error_;
};

}  // namespace stanok::lang
