// MarkWorker: what travels with the path of a channel, marks and outputs, from the preparation to
// its place there.
//
// A rider takes effect where the path comes to its block, or where it is all that the next item
// waits for. Soft marks are gates: the path may flow through one when all partners are there, else
// it comes to rest before the block behind it; what the coordinator asks and says of that it does
// through soft_mark(), is_waiting(), passed_mark() and open(). Thread: the real-time cycle. Owner:
// the channel, whose ring of riders is consumed here and nowhere else. Invariant: the gates lie at
// or behind the front of the ring, the second one behind the first.
#pragma once

#include <cstdint>
#include <optional>

#include "base/numbered.h"
#include "base/ring.h"
#include "base/rt_safe.h"
#include "channels/contract/output.h"
#include "channels/messages/item.h"
#include "lang/tree/builtin.h"

namespace stanok::channels {

class MarkWorker {
 public:
  // Both outlive the worker.
  MarkWorker(Ring<Rider>& riders, Signals& outputs) : riders_(riders), outputs_(outputs) {}

  // How far the path and the items of the channel are in this cycle.
  struct Progress {
    motion::BlockTag path;           // of the block on the path
    bool stands_at_gate = false;     // before a block that is closed, a mark's or another one
    std::uint64_t closed_block = 0;  // the first one that something else than a mark closes
    // Riders made before the next item, which waits for nothing but them; 0: none does.
    std::uint64_t riders_before_item = 0;
  };

  // A new cycle: no mark was passed in it yet.
  void begin_cycle() RT_SAFE { has_passed_mark_ = false; }
  // Takes what is due. The tag of a soft mark, when the path came too fast to stop before it; such
  // a mark stays.
  [[nodiscard]] std::optional<motion::BlockTag> advance(const Progress& progress) RT_SAFE;
  // Looks for the next two soft marks among the riders that came since.
  void find_gates() RT_SAFE;
  // From this block on the path is closed by a mark; motion::FeedControl::no_gate: by none. While
  // the path flows through an open mark it must be able to stop at the one behind.
  [[nodiscard]] std::uint64_t closed_from_block() const RT_SAFE;

  [[nodiscard]] bool is_set(int mark) const RT_SAFE { return is_set_[mark]; }
  // The next soft mark on the path, or nullptr; whether the channel stands there, and the one that
  // it left behind in this cycle. Both hold a riders::SoftMark.
  [[nodiscard]] const Rider* soft_mark() const RT_SAFE { return soft_mark_at(gate_); }
  [[nodiscard]] bool is_waiting() const RT_SAFE { return is_waiting_; }
  // For the partners of the soft mark at which the channel stands.
  [[nodiscard]] Wait waits_for() const RT_SAFE;
  [[nodiscard]] const Rider* passed_mark() const RT_SAFE {
    return has_passed_mark_ ? &passed_mark_ : nullptr;
  }
  // All partners of the next soft mark are there.
  void open() RT_SAFE { is_open_ = true; }

  // A run begins: all marks are clear.
  void clear_marks() RT_SAFE { is_set_ = {}; }
  // What has not come to its place never will.
  void forget_riders() RT_SAFE;

 private:
  [[nodiscard]] bool front_is_due(const Progress& progress) const RT_SAFE;
  [[nodiscard]] bool is_at_gate(const Progress& progress) const RT_SAFE;
  void pass(const Rider& mark) RT_SAFE;
  // Carries out a rider: one overload for each of its contents.
  struct Execution;
  [[nodiscard]] const Rider* soft_mark_at(std::uint64_t number) const RT_SAFE;

  Ring<Rider>& riders_;
  Signals& outputs_;
  NumberedArray<bool, lang::mark_max + 1> is_set_{};
  std::uint64_t gate_ = 0;  // number of the rider that is the next soft mark, or of the next rider
  std::uint64_t gate_behind_ = 0;  // the same for the soft mark behind that one
  bool is_waiting_ = false;
  bool is_open_ = false;
  bool has_passed_mark_ = false;
  Rider passed_mark_;
};

}  // namespace stanok::channels
