// Errand: a request on its way: of a program (channel_run, channel_wait, #kinematics, ...) or of an
// operator. It is stepped once a cycle until it is done.
#pragma once

#include <cstdint>
#include <variant>

#include "base/rt_safe.h"
#include "channels/coordinator/errand_state.h"
#include "channels/coordinator/wait_graph.h"
#include "channels/messages/request.h"
#include "motion/path/path.h"

namespace stanok::channels {

inline constexpr int operator_asker = -1;

struct Errand {
  bool active = false;
  std::uint64_t order = 0;       // in which errands came
  int asker = operator_asker;    // index of the channel that asks
  std::uint64_t reply_id = 0;    // of an operator
  motion::BlockTag tag;          // of a program
  int target = -1;               // index of the channel concerned; -1: none
  std::uint32_t generation = 0;  // of the target, when it was asked
  std::int32_t controller = 0;   // of the target, when it was asked
  Request request;
  ErrandState state;
  std::int64_t cycles = 0;  // since the errand began, or what may take a limited time

  template <class State>
  [[nodiscard]] bool is() const RT_SAFE {
    return std::holds_alternative<State>(state);
  }
};

}  // namespace stanok::channels
