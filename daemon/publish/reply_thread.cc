#include "daemon/publish/reply_thread.h"

#include <chrono>
#include <exception>
#include <utility>

#include "daemon/host/real_time_rights.h"

namespace stanok::daemon {
namespace {

constexpr int reply_priority = 45;  // below the buses
constexpr auto look_pause = std::chrono::milliseconds(1);
constexpr auto cycle_pause = std::chrono::microseconds(100);

}  // namespace

ReplyThread::ReplyThread(Ring<channels::OperatorReply>& replies, Cycles cycles, Tell tell,
                         OnFault on_fault)
    : replies_(replies),
      cycles_(std::move(cycles)),
      tell_(std::move(tell)),
      on_fault_(std::move(on_fault)) {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    try {
      run(stop);
    } catch (const std::exception& fault) {
      on_fault_(fault.what());
    }
  });
}

void ReplyThread::run(const std::stop_token& stop) {
  prefer_this_thread(reply_priority);
  while (!stop.stop_requested()) {
    const std::size_t count = replies_.size();
    const std::int64_t over = cycles_();
    if (count == 0) {
      std::this_thread::sleep_for(look_pause);
      continue;
    }
    // They were given in the cycle behind `over` at the latest.
    while (cycles_() == over && !stop.stop_requested()) std::this_thread::sleep_for(cycle_pause);
    for (std::size_t k = 0; k < count; ++k) {
      tell_(replies_.front());
      replies_.pop_front();
    }
  }
}

}  // namespace stanok::daemon
