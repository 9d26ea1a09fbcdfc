// save_gvector, restore_gvector and the automatic return to a saved state.
#include <cmath>
#include <utility>

#include "lang/actions/gvector.h"
#include "lang/actions/modal_restore.h"
#include "lang/run/program_run.h"
#include "lang/text/number.h"

namespace stanok::lang {

// save_gvector (parts)
void ProgramRun::save_gvector() {
  const double parts = pop_number();
  if (!is_integer(parts) || parts < 0.5 || parts > state_all + 0.5) {
    return fail("E3009", "save_gvector takes a sum of GV_MODAL to GV_COOLANT", "not such a sum");
  }
  push(value_of(gvector_text(modal_, static_cast<StateParts>(std::lround(parts)))));
}

// restore_gvector (text): a sync point; the state is restored with the answer.
void ProgramRun::restore_gvector(bool statement) {
  const Value text = pop();
  const auto saved = read_gvector(text_of(text));
  if (!saved) {
    return fail("E3022", "this text is no saved state", "damaged, or of another version");
  }
  pending_state_ = *saved;
  statement_ = statement;
  Request request;
  request.statement = statement;
  ask(std::move(request), AnswerUse::restore_state);
}

void ProgramRun::finish_restoring(bool statement) {
  StateParts parts = pending_state_.parts;
  if ((parts & state_modal) != 0) parts |= state_motion;
  const std::string_view reason = reason_against_restoring(modal_, pending_state_.state, parts);
  if (reason.empty()) {
    queue_.set_origin({frames_.back().file, span().line}, block_);
    ActiveBlock block(words_, around_, span().line);
    restore_state(block, pending_state_.state, parts);
  }
  push(value_of(reason.empty()));
  if (reason.empty()) return;
  channel_error_ = reason;
  if (statement) fail("E4014", "the saved state cannot be restored", std::string(reason));
}

// The call of `level` returns: what M73 saved in it holds again.
void ProgramRun::leave_state_level(std::size_t level) {
  const auto saved = states_.leave(level);
  if (!saved) return;
  const std::string_view reason = reason_against_restoring(modal_, *saved, state_of_m70);
  if (!reason.empty()) {
    return fail("E4014", "the state saved by M73 cannot be restored", std::string(reason));
  }
  ActiveBlock block(words_, around_, span().line);
  restore_state(block, *saved, state_of_m70);
}

}  // namespace stanok::lang
