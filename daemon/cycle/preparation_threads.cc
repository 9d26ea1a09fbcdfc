#include "daemon/cycle/preparation_threads.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "daemon/host/processor_share.h"
#include "daemon/host/real_time_rights.h"

namespace stanok::daemon {
namespace {

constexpr auto blocked_pause = std::chrono::milliseconds(1);
constexpr int urgent_priority = 50;  // below the buses
constexpr auto urgent_window = std::chrono::milliseconds(20);

// Of each of `threads`, all of them together half of the computer.
std::chrono::nanoseconds share_of_window(int threads) {
  const auto processors = std::max(1U, std::thread::hardware_concurrency());
  return std::chrono::nanoseconds(urgent_window) * std::min<std::int64_t>(threads, processors) /
         (2 * threads);
}

}  // namespace

PreparationThreads::PreparationThreads(int channels, Prepare prepare, IsUrgent is_urgent,
                                       OnFault on_fault)
    : channels_(channels),
      prepare_(std::move(prepare)),
      is_urgent_(std::move(is_urgent)),
      on_fault_(std::move(on_fault)) {
  for (int index = 0; index < channels; ++index) {
    threads_.emplace_back([this, index](const std::stop_token& stop) {
      try {
        run(stop, index);
      } catch (const std::exception& fault) {
        on_fault_(index, fault.what());
      }
    });
  }
}

void PreparationThreads::run(const std::stop_token& stop, int index) const {
  ProcessorShare share(share_of_window(channels_), urgent_window);
  bool is_preferred = false;
  while (!stop.stop_requested()) {
    if (prepare_(index) == channels::Progress::blocked) std::this_thread::sleep_for(blocked_pause);
    const bool prefers = is_urgent_(index) && !share.is_used_up();
    if (prefers == is_preferred) continue;
    prefers ? prefer_this_thread(urgent_priority) : be_ordinary_thread();
    is_preferred = prefers;
  }
}

}  // namespace stanok::daemon
