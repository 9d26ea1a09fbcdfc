// What travels with the path: marks and outputs, from preparation to their place on it.
#include <algorithm>

#include "channels/channel.h"

namespace stanok::channels {
namespace {

constexpr int riders_per_cycle = 256;  // bound of work

}  // namespace

// The riders that the path has passed, and those that come before its next item when that is due.
void Channel::work_riders() RT_SAFE {
  if (resetting_) return;
  for (int n = 0; n < riders_per_cycle && !link_.riders.empty(); ++n) {
    const Rider rider = link_.riders.front();
    const bool passed =
        path_.tag.run == rider.tag.run && path_.tag.block >= rider.before_block && !path_.at_gate;
    if (!passed && !rider_is_due()) return;
    if (rider.kind == RiderKind::mark_wait && !pass_soft_mark(rider, passed)) return;
    execute(rider);
    link_.riders.pop_front();
  }
}

// The front rider is all that the channel waits for: at its gate, or before an item.
bool Channel::rider_is_due() const RT_SAFE {
  const std::uint64_t number = link_.riders.popped();
  if (is_at_mark_gate() && number <= gate_) return true;
  if (link_.items.empty() || activity_ != Activity::none || !interpolator_.at_rest()) return false;
  const Item& next = link_.items.front();
  return path_.chunks_done >= next.after_chunk && number < next.after_rider;
}

// True when the channel leaves the mark behind.
bool Channel::pass_soft_mark(const Rider& mark, bool passed) RT_SAFE {
  if (!soft_mark_open_ && !passed) {
    at_soft_mark_ = true;
    return false;
  }
  if (!soft_mark_open_) {
    fail_run("E6024", "the path came too fast to the mark to stop there", mark.tag);
    return false;
  }
  passed_mark_ = mark;
  has_passed_mark_ = true;
  soft_mark_open_ = false;
  at_soft_mark_ = false;
  return true;
}

void Channel::execute(const Rider& rider) RT_SAFE {
  switch (rider.kind) {
    case RiderKind::mark_set:
    case RiderKind::mark_clear:
      marks_[static_cast<std::size_t>(rider.number)] = rider.kind == RiderKind::mark_set;
      break;
    case RiderKind::mark_wait:
      break;
    case RiderKind::digital_output:
      books_.outputs->set(rider.number, rider.value != 0.0);
      break;
    case RiderKind::analog_output:
      books_.outputs->analog[static_cast<std::size_t>(rider.number)] = rider.value;
      break;
  }
}

// Looks for the next two soft marks among the riders that came since.
void Channel::find_gates() RT_SAFE {
  gate_ = std::max<std::uint64_t>(gate_, link_.riders.popped());
  while (gate_ < link_.riders.shown() && soft_mark_at(gate_) == nullptr) ++gate_;
  gate_behind_ = std::max(gate_behind_, gate_ + 1);
  while (gate_behind_ < link_.riders.shown() && soft_mark_at(gate_behind_) == nullptr)
    ++gate_behind_;
}

// The rider of this number if it is a soft mark.
const Rider* Channel::soft_mark_at(std::uint64_t number) const RT_SAFE {
  if (number < link_.riders.popped() || number >= link_.riders.shown()) return nullptr;
  const Rider& rider = link_.riders[number - link_.riders.popped()];
  return rider.kind == RiderKind::mark_wait ? &rider : nullptr;
}

// While the path flows through an open mark it must be able to stop at the one behind.
std::uint64_t Channel::closed_from_block() const RT_SAFE {
  const Rider* const mark = soft_mark_at(soft_mark_open_ ? gate_behind_ : gate_);
  const std::uint64_t closed = stepper_.closed_from_block();
  return mark == nullptr ? closed : std::min(closed, mark->before_block);
}

bool Channel::is_at_mark_gate() const RT_SAFE {
  const Rider* mark = soft_mark();
  return path_.at_gate && mark != nullptr && mark->before_block <= stepper_.closed_from_block();
}

void Channel::forget_riders() RT_SAFE {
  link_.riders.pop_front(link_.riders.size());
  at_soft_mark_ = false;
  soft_mark_open_ = false;
}

}  // namespace stanok::channels
