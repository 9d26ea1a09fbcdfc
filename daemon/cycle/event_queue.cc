#include "daemon/cycle/event_queue.h"

#include <algorithm>

namespace stanok::daemon {

using channels::OperatorEvent;

EventQueue::Taken EventQueue::take() RT_SAFE {
  // The stops are counted first: what was put before one of them is seen together with it.
  const std::size_t stops = stops_.size();
  const std::size_t events = events_.size();
  note_stops(stops);
  if (events > 0) taking_.store(events_[events - 1].id, std::memory_order_seq_cst);
  const std::uint64_t withdrawn = withdrawn_.load(std::memory_order_seq_cst);
  std::size_t taken = 0;
  std::size_t overtaken = 0;
  std::size_t stops_handed = 0;
  for (std::size_t k = 0; k < events; ++k) {
    const OperatorEvent& event = events_[k];
    while (stops_handed < stops && stops_taken_ + stops_handed < event.stops_before)
      taken_[taken++] = stops_[stops_handed++];
    if (is_void(event, withdrawn)) {
      overtaken_[overtaken++] = event;
    } else {
      taken_[taken++] = event;
    }
  }
  while (stops_handed < stops) taken_[taken++] = stops_[stops_handed++];
  events_.pop_front(events);
  stops_.pop_front(stops);
  stops_taken_ += stops;
  return {{taken_.data(), taken}, {overtaken_.data(), overtaken}};
}

void EventQueue::note_stops(std::size_t count) RT_SAFE {
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t number = stops_taken_ + k + 1;
    const std::int32_t channel = stops_[k].channel;
    last_of_any_ = number;
    if (channel == 0) {
      last_of_all_ = number;
      continue;
    }
    const auto place = std::find_if(last_.begin(), last_.end(), [&](const LastStop& last) RT_SAFE {
      return last.channel == channel || last.channel == 0;
    });
    // A machine has no more channels than there are places.
    if (place != last_.end()) *place = {channel, number};
  }
}

bool EventQueue::is_void(const OperatorEvent& event, std::uint64_t withdrawn) const RT_SAFE {
  const bool is_withdrawn = withdrawn > 0 && event.id <= withdrawn;
  if (is_withdrawn && !channels::is_stop(event.action())) return true;
  return is_overtaken(event);
}

bool EventQueue::is_overtaken(const OperatorEvent& event) const RT_SAFE {
  if (!channels::begins_motion(event.action())) return false;
  if (event.channel == 0) return last_of_any_ > event.stops_before;
  const auto place = std::find_if(last_.begin(), last_.end(), [&](const LastStop& last) RT_SAFE {
    return last.channel == event.channel;
  });
  const std::uint64_t last_of_channel = place == last_.end() ? 0 : place->number;
  return std::max(last_of_all_, last_of_channel) > event.stops_before;
}

}  // namespace stanok::daemon
