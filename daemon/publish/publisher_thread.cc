#include "daemon/publish/publisher_thread.h"

#include <chrono>
#include <exception>

#include "daemon/host/processor_share.h"
#include "daemon/host/real_time_rights.h"

namespace stanok::daemon {
namespace {

constexpr auto empty_pause = std::chrono::milliseconds(1);
constexpr int publisher_priority = 40;  // below the buses, and who brings replies
constexpr auto publisher_window = std::chrono::milliseconds(20);
constexpr auto publisher_share = std::chrono::milliseconds(15);

// The oldest `count`. What arrives meanwhile stays for the next time, so that the work of one call
// is bounded.
template <class Record>
std::size_t drain_ring(Ring<Record>& ring, std::size_t count,
                       const std::vector<CycleListener*>& listeners,
                       void (CycleListener::*told)(const Record&)) {
  for (std::size_t k = 0; k < count; ++k) {
    for (CycleListener* listener : listeners) (listener->*told)(ring.front());
    ring.pop_front();
  }
  return count;
}

}  // namespace

std::size_t drain(const CycleRings& rings, const std::vector<CycleListener*>& listeners) {
  // Counted first: what led to these outputs is in the other rings by now, and goes before them.
  const std::size_t outputs = rings.outputs.size();
  if (rings.program_reads) {
    for (const recording::ProgramRead& read : rings.program_reads()) {
      for (CycleListener* listener : listeners) listener->on_program_read(read);
    }
  }
  return drain_ring(rings.inputs, rings.inputs.size(), listeners, &CycleListener::on_input) +
         drain_ring(rings.changes, rings.changes.size(), listeners, &CycleListener::on_change) +
         drain_ring(rings.outputs, outputs, listeners, &CycleListener::on_output) +
         drain_ring(rings.events, rings.events.size(), listeners, &CycleListener::on_event);
}

PublisherThread::PublisherThread(const CycleRings& rings, std::vector<CycleListener*> listeners,
                                 OnFault on_fault)
    : rings_(rings), listeners_(std::move(listeners)), on_fault_(std::move(on_fault)) {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    try {
      run(stop);
    } catch (const std::exception& fault) {
      on_fault_(fault.what());
    }
  });
}

void PublisherThread::run(const std::stop_token& stop) const {
  prefer_this_thread(publisher_priority);
  ProcessorShare share(publisher_share, publisher_window);
  while (!stop.stop_requested()) {
    if (drain(rings_, listeners_) == 0) std::this_thread::sleep_for(empty_pause);
    share.rest_when_used_up();
  }
  drain(rings_, listeners_);
}

}  // namespace stanok::daemon
