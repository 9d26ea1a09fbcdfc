// Actions of the saved modal state: M70 M71 M72 M73.
#include "lang/actions/actions.h"
#include "lang/actions/modal_restore.h"

namespace stanok::lang {

void save_state(ActiveBlock& block, CodeNumber code) {
  block.states.save(block.modal, code == m(73) ? StateStack::Restoring::at_return
                                               : StateStack::Restoring::by_code);
}

void drop_state(ActiveBlock& block, CodeNumber) {
  block.states.drop();
}

void restore_saved_state(ActiveBlock& block, CodeNumber) {
  const ModalState* const saved = block.states.saved();
  if (saved == nullptr) {
    block
        .fail("E4014", {'M', m(72), {}}, "`M72` has no saved state to restore",
              "nothing to restore")
        .help.push_back("save it first with M70 in the same program or subprogram");
    return;
  }
  const std::string_view reason = reason_against_restoring(block.modal, *saved, state_of_m70);
  if (!reason.empty()) {
    block.fail("E4014", {'M', m(72), {}}, "the saved state cannot be restored",
               std::string(reason));
    return;
  }
  restore_state(block, *saved, state_of_m70);
}

}  // namespace stanok::lang
