#include "channels/stores/input_book.h"

namespace stanok::channels {

void InputBook::note(const InputRecord& record) RT_SAFE {
  constexpr std::size_t kept_places = 1;  // for the note of a loss
  if (untold_cycle_ > 0) tell(untold_cycle_);
  if (lost_in_gap_ > 0 && records_.space() > records_.capacity() / 2) end_gap(record.cycle);
  if (lost_in_gap_ == 0 && records_.space() > kept_places) {
    static_cast<void>(records_.push(record));
    return;
  }
  if (lost_in_gap_ == 0) begin_gap(record.cycle);
  ++lost_in_gap_;
  lost_.fetch_add(1, std::memory_order_relaxed);
}

void InputBook::note_loss(std::int64_t cycle) RT_SAFE {
  if (lost_in_gap_ == 0) begin_gap(cycle);
  ++lost_in_gap_;
  lost_.fetch_add(1, std::memory_order_relaxed);
}

void InputBook::begin_gap(std::int64_t cycle) RT_SAFE {
  static_cast<void>(records_.push({.cycle = cycle, .content = LostInputs{}}));
  tell(cycle);
}

void InputBook::end_gap(std::int64_t cycle) RT_SAFE {
  const auto lost = static_cast<std::uint64_t>(lost_in_gap_);
  static_cast<void>(records_.push({.cycle = cycle, .content = LostInputs{lost}}));
  lost_in_gap_ = 0;
}

void InputBook::tell(std::int64_t cycle) RT_SAFE {
  Event event;
  event.cycle = cycle;
  event.code = FixedText<8>("W720");
  event.text = FixedText<240>("inputs from cycle ");
  event.text.append(static_cast<long>(cycle))
      .append(
          " on are missing from the recording: the recorder was too slow; the log can be replayed "
          "only up to this cycle");
  untold_cycle_ = events_.put(event) ? 0 : cycle;
}

}  // namespace stanok::channels
