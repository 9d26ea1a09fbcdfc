#include "daemon/start/state_keeper.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <exception>
#include <utility>

namespace stanok::daemon {
namespace {

constexpr auto keeping_period = std::chrono::milliseconds(500);

}  // namespace

StateKeeper::StateKeeper(std::filesystem::path file, const DurableKind& kind, Snapshot snapshot,
                         OnFault on_fault)
    : file_(std::move(file)),
      kind_(kind),
      snapshot_(std::move(snapshot)),
      on_fault_(std::move(on_fault)),
      saved_(snapshot_()) {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      save_for(std::exchange(waiting_, {}));
      wake_.wait_for(lock, stop, keeping_period, [this] { return !waiting_.empty(); });
    }
    save_for(std::exchange(waiting_, {}));
  });
}

void StateKeeper::keep(Done done) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(done));
  wake_.notify_all();
}

// Under the lock, which is given up meanwhile.
void StateKeeper::save_for(const std::vector<Done>& waiting) {
  mutex_.unlock();
  const auto fault = try_to_save();
  for (const Done& done : waiting) done(fault);
  mutex_.lock();
}

// Where memory ends it is tried again, as with a disk that is full.
std::optional<std::string> StateKeeper::try_to_save() {
  std::optional<std::string> fault;
  try {
    fault = save_when_changed();
  } catch (const std::exception& thrown) {
    fault = thrown.what();
  }
  if (fault && !has_told_fault_) {
    spdlog::error("{} cannot be saved: {}; the daemon tries again", kind_.name, *fault);
    tell(*fault);
  }
  if (!fault && has_told_fault_) spdlog::info("{} are being saved again", kind_.name);
  has_told_fault_ = fault.has_value();
  return fault;
}

// Where there is no memory to say it with, the log has it.
void StateKeeper::tell(const std::string& fault) {
  try {
    on_fault_(kind_.name, fault);
  } catch (const std::exception& untold) {
    spdlog::error("operators cannot be told: {}", untold.what());
  }
}

StateKeeper::~StateKeeper() = default;

std::optional<std::string> StateKeeper::save_when_changed() {
  std::string now = snapshot_();
  if (now == saved_) return std::nullopt;
  if (auto fault = write_durably(file_, kind_, now)) return fault;
  saved_ = std::move(now);
  return std::nullopt;
}

}  // namespace stanok::daemon
