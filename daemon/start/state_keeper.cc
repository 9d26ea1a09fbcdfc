#include "daemon/start/state_keeper.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace stanok::daemon {
namespace {

constexpr auto period = std::chrono::milliseconds(500);

}  // namespace

StateKeeper::StateKeeper(std::filesystem::path file, const DurableKind& kind, Snapshot snapshot)
    : file_(std::move(file)), kind_(kind), snapshot_(std::move(snapshot)), saved_(snapshot_()) {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      try_to_save();
      wake.wait_for(lock, stop, period, [] { return false; });
    }
    try_to_save();
  });
}

// Where memory ends it is tried again, as with a disk that is full.
void StateKeeper::try_to_save() {
  try {
    save_when_changed();
  } catch (const std::exception& fault) {
    if (!has_told_fault_)
      spdlog::error("{} cannot be kept: {}; tried again", kind_.name, fault.what());
    has_told_fault_ = true;
  }
}

StateKeeper::~StateKeeper() = default;

void StateKeeper::save_when_changed() {
  std::string now = snapshot_();
  if (now == saved_) return;
  if (const auto fault = write_durably(file_, kind_, now)) {
    if (!has_told_fault_) spdlog::error("{} cannot be kept: {}; tried again", kind_.name, *fault);
    has_told_fault_ = true;
    return;
  }
  if (has_told_fault_) spdlog::info("{} are kept again", kind_.name);
  has_told_fault_ = false;
  saved_ = std::move(now);
}

}  // namespace stanok::daemon
