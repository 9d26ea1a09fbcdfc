// ChangeBook: the changes of what the cycle is given, on their way to the recorder.
//
// Kept apart from the outputs, which are many times as large: a recorder that falls behind for
// seconds lacks setpoints then, which a replay computes again, but no input. A full ring is a loss
// of inputs (input_book.h): nothing behind it can be repeated. One such loss ends when half of the
// ring is free.
#pragma once

#include <cstddef>

#include "base/numbered.h"
#include "base/ring.h"
#include "channels/contract/input_change.h"
#include "channels/contract/output.h"
#include "channels/stores/input_book.h"

namespace stanok::channels {

class ChangeBook {
 public:
  // `capacity` 0: there is no recorder. `inputs` outlives the book and is told of losses.
  ChangeBook(std::size_t capacity, InputBook& inputs)
      : is_wanted_(capacity > 0), changes_(capacity > 0 ? capacity : 1), inputs_(inputs) {}

  // The cycle's thread.
  void note(const InputChange& change) RT_SAFE;
  // Prepared work and feedback that this cycle had.
  void note(const CycleOutput& output) RT_SAFE;

  // The consumer's side.
  [[nodiscard]] Ring<InputChange>& changes() { return changes_; }

 private:
  struct Known {
    Arrivals arrivals;
    bool has_feedback = false;
    AxisArray<AxisFeedback> feedback{};
  };

  void note(std::int64_t cycle, const ChannelOutput& output) RT_SAFE;

  bool is_wanted_;
  Ring<InputChange> changes_;
  InputBook& inputs_;
  bool is_losing_ = false;
  NumberedArray<Known, channels_max + 1> known_{};  // by the number of the channel
};

}  // namespace stanok::channels
