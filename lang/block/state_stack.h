// Modal states saved by M70 and M73, at most one for each call that has not returned.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "lang/block/modal_state.h"

namespace stanok::lang {

class StateStack {
 public:
  enum class Restoring { by_code, at_return };  // M72; M73

  void clear() {
    saved_.clear();
    level_ = 0;
  }
  // The call to which save, drop and saved refer; 0 is the main program.
  void set_level(std::size_t level) { level_ = level; }

  void save(const ModalState& state, Restoring restoring) {
    drop();
    saved_.push_back({level_, state, restoring});
  }
  void drop() {
    std::erase_if(saved_, [this](const Saved& one) { return one.level == level_; });
  }
  [[nodiscard]] const ModalState* saved() const {
    const auto found = std::find_if(saved_.begin(), saved_.end(),
                                    [this](const Saved& one) { return one.level == level_; });
    return found == saved_.end() ? nullptr : &found->state;
  }
  // The call of this level returns: the state to be restored, if M73 saved one.
  [[nodiscard]] std::optional<ModalState> leave(std::size_t level) {
    if (saved_.empty() || saved_.back().level < level) return std::nullopt;
    Saved last = std::move(saved_.back());
    saved_.pop_back();
    if (last.restoring == Restoring::by_code) return std::nullopt;
    return std::move(last.state);
  }

 private:
  struct Saved {
    std::size_t level = 0;
    ModalState state;
    Restoring restoring = Restoring::by_code;
  };
  std::vector<Saved> saved_;  // by level, ascending
  std::size_t level_ = 0;
};

}  // namespace stanok::lang
