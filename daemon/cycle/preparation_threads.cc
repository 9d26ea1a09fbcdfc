#include "daemon/cycle/preparation_threads.h"

#include <chrono>
#include <exception>

namespace stanok::daemon {
namespace {

constexpr auto blocked_pause = std::chrono::milliseconds(1);

}  // namespace

PreparationThreads::PreparationThreads(int channels, Prepare prepare, OnFault on_fault)
    : prepare_(std::move(prepare)), on_fault_(std::move(on_fault)) {
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
  while (!stop.stop_requested()) {
    if (prepare_(index) == channels::Progress::blocked) std::this_thread::sleep_for(blocked_pause);
  }
}

}  // namespace stanok::daemon
