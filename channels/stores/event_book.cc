#include "channels/stores/event_book.h"

namespace stanok::channels {

bool EventBook::put(const Event& event) RT_SAFE {
  constexpr std::size_t places = 2;  // for what is told of a loss, and for what comes
  if (untold_ > 0 && events_.space() >= places) tell_loss(event.cycle);
  if (untold_ == 0 && events_.push(event)) return true;
  ++untold_;
  lost_.fetch_add(1, std::memory_order_relaxed);
  return false;
}

void EventBook::tell_loss(std::int64_t cycle) RT_SAFE {
  Event loss;
  loss.cycle = cycle;
  loss.code = FixedText<8>("W721");
  loss.text.append(static_cast<long>(untold_))
      .append(" messages before this one are missing: they were not read in time");
  static_cast<void>(events_.push(loss));  // there is room for it
  untold_ = 0;
}

}  // namespace stanok::channels
